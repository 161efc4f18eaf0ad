#include "physics/effect_info.hpp"

#include "physics/hooks.hpp"

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

namespace {

// NOLINTBEGIN(bugprone-macro-parentheses): the name of a member takes none
#define PLUMBLINE_COUNT(hook, Sum) \
  hooks += requires { &Effect::template hook<double>; };
#define PLUMBLINE_SAYS(trait) \
  info.trait = requires { Effect::trait; };
// NOLINTEND(bugprone-macro-parentheses)

template <class Effect>
EffectInfo info_of(bool base) {
  EffectInfo info{Effect::name, {Effect::parameters.data(), Effect::parameters.size()}, base};
  PLUMBLINE_SAYS(own_strut_alone)
  PLUMBLINE_SAYS(dynamic)
  PLUMBLINE_SAYS(rare)
  PLUMBLINE_SAYS(suspect)
  PLUMBLINE_SAYS(sums_to_zero)
  PLUMBLINE_SAYS(geometry)
  PLUMBLINE_SAYS(path)
  PLUMBLINE_SAYS(friction)
  PLUMBLINE_SAYS(description)
  if constexpr (requires { Effect::bend; }) info.bend = &Effect::bend;
  int hooks = 0;
  PLUMBLINE_HOOKS(PLUMBLINE_COUNT)
  info.reading_alone = hooks == 1 && requires { &Effect::template reading<double>; };
  return info;
}

#undef PLUMBLINE_COUNT
#undef PLUMBLINE_SAYS

}  // namespace

const std::array<EffectInfo, kEffects>& effect_infos() {
  static const std::array<EffectInfo, kEffects> infos = [] {
    std::array<EffectInfo, kEffects> table{};
    for_each_effect([&]<class Effect>(std::size_t i) { table[i] = info_of<Effect>(i < kBaseEffects); });
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

std::vector<std::string_view> cause_names() {
  std::vector<std::string_view> names;
  for (const EffectInfo& info : effect_infos()) {
    if (info.is_cause()) names.push_back(info.name);
  }
  return names;
}

}  // namespace plumbline::physics
