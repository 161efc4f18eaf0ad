#include "identify/unknowns/named_keys.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "base/diagnostic.hpp"
#include "base/text/nearest_name.hpp"

namespace plumbline::identify {
namespace {

struct NamedKey {
  std::string name;
  std::string_view effect;
  const physics::ParameterSpec* spec = nullptr;
};

std::string name_of(std::string_view effect, const physics::ParameterSpec& spec) {
  return fmt::format("{}.{}", spec.table.empty() ? effect : spec.table, spec.key);
}

std::vector<NamedKey> named_keys() {
  std::vector<NamedKey> keys;
  for (const physics::EffectInfo& info : physics::effect_infos()) {
    for (const physics::ParameterSpec& spec : info.parameters) {
      keys.push_back({name_of(info.name, spec), info.name, &spec});
    }
  }
  return keys;
}

[[noreturn]] void refuse_unknown(const std::string& name, const std::vector<NamedKey>& keys) {
  std::vector<std::string_view> known;
  for (const NamedKey& k : keys) known.push_back(k.name);
  refuse("identify-unknown-key", fmt::format("{} is nothing that can be fitted", name),
         fmt::format("{}write table.key of the model file or effect.key, as strut.motor_mass_kg or backlash.width_um",
                     did_you_mean(name, known)));
}

}  // namespace

std::vector<std::size_t> named_unknowns(Unknowns& unknowns, const std::string& name) {
  const std::vector<NamedKey> keys = named_keys();
  const auto key = std::find_if(keys.begin(), keys.end(), [&](const NamedKey& k) { return k.name == name; });
  if (key == keys.end()) refuse_unknown(name, keys);
  const bool shared = key->spec->shared;
  std::vector<std::size_t> places;
  for (int i = 0; i < (shared ? 1 : key->spec->size()); ++i) {
    const int index = shared || key->spec->size() == 1 ? -1 : i;
    const int place = unknowns.find(key->effect, key->spec->key, index);
    if (place >= 0) {
      places.push_back(static_cast<std::size_t>(place));
    } else {
      places.push_back(shared ? unknowns.add_shared(key->effect, key->spec->key)
                              : unknowns.add(key->effect, key->spec->key, i));
    }
  }
  return places;
}

std::vector<std::string> names_known_by(std::string_view uncertainty) {
  std::vector<std::string> names;
  for (const KeyOfEffect& key : keys_known_by(uncertainty)) names.push_back(name_of(key.effect, *key.spec));
  return names;
}

void add_free(Unknowns& unknowns, const std::string& name) {
  for (const std::size_t place : named_unknowns(unknowns, name)) unknowns.set_free(place);
}

}  // namespace plumbline::identify
