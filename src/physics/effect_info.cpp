#include "physics/effect_info.hpp"

namespace plumbline::physics {

int EffectInfo::size() const {
  int size = 0;
  for (const ParameterSpec& spec : parameters) size += spec.size();
  return size;
}

int EffectInfo::offset_of(std::string_view key) const {
  int offset = 0;
  for (const ParameterSpec& spec : parameters) {
    if (spec.key == key) return offset;
    offset += spec.size();
  }
  return -1;
}

int EffectInfo::strut_of(int offset) const {
  for (const ParameterSpec& spec : parameters) {
    if (offset < spec.size()) return offset / spec.each;
    offset -= spec.size();
  }
  return -1;
}

const std::array<EffectInfo, kEffects>& effect_infos() {
  static const std::array<EffectInfo, kEffects> infos = [] {
    std::array<EffectInfo, kEffects> table{};
    for_each_effect([&]<class Effect>(std::size_t i) {
      table[i] = {Effect::name,
                  {Effect::parameters.data(), Effect::parameters.size()},
                  i < kBaseEffects,
                  moves_own_strut_alone<Effect>,
                  is_dynamic<Effect>};
    });
    return table;
  }();
  return infos;
}

std::size_t effect_index(std::string_view name) {
  const auto& infos = effect_infos();
  std::size_t index = 0;
  while (index < kEffects && infos[index].name != name) ++index;
  return index;
}

std::vector<std::string_view> catalogue_names() {
  std::vector<std::string_view> names;
  for (const EffectInfo& info : effect_infos()) {
    if (!info.base) names.push_back(info.name);
  }
  return names;
}

}  // namespace plumbline::physics
