#include "physics/force_model.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/check.hpp"
#include "base/text/nearest_name.hpp"
#include "machine/model_values.hpp"

namespace plumbline::physics {
namespace {

using machine::EffectRow;
using machine::EffectValue;

std::string size_text(const ParameterSpec& spec) {
  if (spec.each > 1) return fmt::format("{} arrays of {} numbers", spec.count, spec.each);
  return spec.count == 1 ? "one number" : fmt::format("an array of {} numbers", spec.count);
}

void check_size(const EffectRow& row, const EffectValue& value, const ParameterSpec& spec) {
  std::vector<std::size_t> shape;
  if (spec.count > 1) shape.push_back(static_cast<std::size_t>(spec.count));
  if (spec.each > 1) shape.push_back(static_cast<std::size_t>(spec.each));
  if (value.shape == shape) return;
  refuse("effect-wrong-size", fmt::format("{} of the effect {} needs {}", spec.key, row.name, size_text(spec)),
         spec.count == 6 ? "one for each strut; zero where the effect does not act" : "write it so", value.place);
}

void check_bounds(const EffectRow& row, const EffectValue& value, const ParameterSpec& spec) {
  for (const double x : value.values) {
    if (x >= spec.lower && x <= spec.upper) continue;
    refuse("effect-out-of-bounds",
           fmt::format("{} of the effect {} is {:.12g} {}", spec.key, row.name, x, spec.unit.name),
           fmt::format("it lies between {:.12g} and {:.12g} {}{}", spec.lower, spec.upper, spec.unit.name,
                       machine::slip_hint(spec.unit, x, spec.lower, spec.upper)),
           value.place);
  }
}

void check_whole(const EffectRow& row, const EffectValue& value, const ParameterSpec& spec) {
  if (!spec.whole) return;
  for (const double x : value.values) {
    if (x == std::floor(x)) continue;
    refuse("effect-not-whole", fmt::format("{} of the effect {} holds {:.12g}", spec.key, row.name, x),
           "these are whole numbers", value.place);
  }
}

// Numbers that were fitted and rounded sum to nearly nothing.
void check_sum(const EffectRow& row, const EffectValue& value, const ParameterSpec& spec) {
  constexpr double kShare = 0.01;  // of all magnitudes
  constexpr double kLeast = 0.06;  // in the file's unit
  double sum = 0;
  double magnitudes = 0;
  for (const double x : value.values) {
    sum += x;
    magnitudes += std::abs(x);
  }
  if (std::abs(sum) <= kLeast + kShare * magnitudes) return;
  refuse("effect-out-of-bounds",
         fmt::format("{} of the effect {} sums to {:.6g} {}", spec.key, row.name, sum, spec.unit.name),
         fmt::format("these numbers are differences and sum to 0: take their mean, {:.6g} {}, from each; what all have "
                     "in common is another effect (docs/effects.md)",
                     sum / static_cast<double>(value.values.size()), spec.unit.name),
         value.place);
}

void check_keys(const EffectRow& row, const EffectInfo& info) {
  std::vector<std::string_view> known;
  for (const ParameterSpec& spec : info.parameters) known.push_back(spec.key);
  for (const EffectValue& value : row.values) {
    if (std::find(known.begin(), known.end(), value.key) != known.end()) continue;
    refuse("effect-unknown-key", fmt::format("the effect {} has no key {}", row.name, value.key),
           suggestion(value.key, known), value.key_place);
  }
}

}  // namespace

ForceModel::ForceModel(const machine::MachineModel& model) {
  machine.geometry = model.geometry;
  machine.gravity = model.gravity;
  const std::vector<double>& lead = model.value("strut", "lead_mm").values;
  std::copy(lead.begin(), lead.end(), machine.lead.begin());
  machine.middle_length = 0.5 * (model.limits.length_min + model.limits.length_max);
  sign_speed = model.value("strut", "sign_speed_mm_s").values.front();
  for (std::size_t effect = 0; effect < kBaseEffects; ++effect) add_base(model, effect);
  for (const EffectRow& row : model.effects) add_row(row);
}

int ForceModel::append(std::size_t effect) {
  const int first = static_cast<int>(parameters.size());
  for (const ParameterSpec& spec : effect_infos()[effect].parameters) {
    parameters.insert(parameters.end(), static_cast<std::size_t>(spec.size()), spec.initial * spec.unit.si);
  }
  instances_.push_back({effect, first});
  by_effect_[effect].push_back(first);
  return first;
}

void ForceModel::add_base(const machine::MachineModel& model, std::size_t effect) {
  const int first = append(effect);  // first, since it may move them
  auto into = parameters.begin() + first;
  for (const ParameterSpec& spec : effect_infos()[effect].parameters) {
    const std::vector<double>& values = model.value(spec.table, spec.key).values;
    into = std::copy(values.begin(), values.end(), into);
  }
}

void ForceModel::add_row(const EffectRow& row) {
  const std::size_t effect = effect_index(row.name);
  if (effect == kEffects || effect_infos()[effect].base) {
    refuse("effect-unknown", fmt::format("no effect is called {}", row.name), suggestion(row.name, catalogue_names()),
           row.place);
  }
  const EffectInfo& info = effect_infos()[effect];
  check_keys(row, info);
  const int first = append(effect);  // first, since it may move them
  auto into = parameters.begin() + first;
  for (const ParameterSpec& spec : info.parameters) {
    const auto value =
        std::find_if(row.values.begin(), row.values.end(), [&](const EffectValue& v) { return v.key == spec.key; });
    if (value == row.values.end() && spec.optional) {
      into += spec.size();
      continue;
    }
    if (value == row.values.end()) {
      refuse("effect-missing-key", fmt::format("the effect {} needs {}", row.name, spec.key),
             fmt::format("add it: {}{}", size_text(spec),
                         spec.unit.name.empty() ? "" : fmt::format(", {}", spec.unit.name)),
             row.place);
    }
    check_size(row, *value, spec);
    check_bounds(row, *value, spec);
    check_whole(row, *value, spec);
    if (info.sums_to_zero) check_sum(row, *value, spec);
    for (const double x : value->values) *into++ = x * spec.unit.si;
  }
}

int ForceModel::add(std::string_view effect) {
  const std::size_t index = effect_index(effect);
  PLUMBLINE_CHECK(index < kEffects && !effect_infos()[index].base);
  return append(index);
}

int ForceModel::find(std::string_view effect, std::string_view key) const {
  const std::size_t index = effect_index(effect);
  PLUMBLINE_CHECK(index < kEffects);
  const int offset = effect_infos()[index].offset_of(key);
  PLUMBLINE_CHECK(offset >= 0);
  return by_effect_[index].empty() ? -1 : by_effect_[index].front() + offset;
}

Environment ForceModel::environment() const {
  Environment environment;
  environment.sign_speed = sign_speed;
  return environment;
}

}  // namespace plumbline::physics
