#include "identify/unknowns/unknowns.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "base/check.hpp"

namespace plumbline::identify {
namespace {

constexpr double kShareOfRange = 0.01;  // of a free unknown's bounds that counts as a change that matters

const physics::ParameterSpec& spec_of(std::string_view effect, std::string_view key) {
  const physics::EffectInfo& info = physics::effect_infos()[physics::effect_index(effect)];
  const auto spec = std::find_if(info.parameters.begin(), info.parameters.end(),
                                 [&](const physics::ParameterSpec& s) { return s.key == key; });
  PLUMBLINE_CHECK(spec != info.parameters.end());
  return *spec;
}

std::string label_of(std::string_view effect, const physics::ParameterSpec& spec, int index) {
  constexpr std::string_view kAxes = "xyz";
  const std::string_view short_name = spec.label.empty() ? spec.key : spec.label;
  std::string label = spec.table.empty() ? fmt::format("{} {}", effect, spec.key) : std::string(short_name);
  if (index < 0) return label;
  if (spec.each == 3) return label + fmt::format(" strut {} {}", index / 3 + 1, kAxes[index % 3]);
  if (spec.count == 6) return label + fmt::format(" strut {}", index + 1);
  if (spec.count > 3) return label + fmt::format(" {}", index + 1);
  if (spec.count > 1) return label + fmt::format(" {}", kAxes[index]);
  return label;
}

// The mean of a key's numbers in the first instance of an effect that acts.
double mean_of(const physics::ForceModel& forces, std::string_view effect, std::string_view key) {
  const int size = spec_of(effect, key).size();
  const auto first = forces.parameters.begin() + forces.find(effect, key);
  return std::accumulate(first, first + size, 0.0) / size;
}

constexpr std::string_view kUncertainty = "uncertainty";  // the table of the model file

}  // namespace

std::vector<KeyOfEffect> keys_known_by(std::string_view uncertainty) {
  std::vector<KeyOfEffect> keys;
  for (const physics::EffectInfo& info : physics::effect_infos()) {
    for (const physics::ParameterSpec& spec : info.parameters) {
      if (spec.uncertainty == uncertainty) keys.push_back({info.name, &spec});
    }
  }
  return keys;
}

int Unknowns::instance(std::string_view effect, int row) {
  const std::size_t index = physics::effect_index(effect);
  PLUMBLINE_CHECK(index < physics::kEffects);
  const std::vector<int>& instances = forces_.instances_of(index);
  if (instances.empty() && row == 0) return forces_.add(effect);
  PLUMBLINE_CHECK(row >= 0 && row < static_cast<int>(instances.size()));
  return instances[static_cast<std::size_t>(row)];
}

std::size_t Unknowns::append(Unknown unknown) {
  const physics::ParameterSpec& spec = spec_of(unknown.effect, unknown.key);
  unknown.unit = spec.unit;
  unknown.shape = spec.shape;
  unknown.periodic = spec.periodic;
  unknown.label = label_of(unknown.effect, spec, unknown.index);
  if (unknown.row > 0) unknown.label += fmt::format(", row {}", unknown.row + 1);
  unknown.lower = spec.lower * spec.unit.si;
  unknown.upper = spec.upper * spec.unit.si;
  unknown.scale = kShareOfRange * (spec.upper - spec.lower) * spec.unit.si;
  // keys of the model file have bounds that only slips of units exceed: they say nothing of what matters
  if (!spec.table.empty()) unknown.scale = unknown.start != 0 ? std::abs(unknown.start) : spec.unit.si;
  list_.push_back(std::move(unknown));
  return list_.size() - 1;
}

std::size_t Unknowns::add(std::string_view effect, std::string_view key, int index, int row) {
  const int first = instance(effect, row) + physics::effect_infos()[physics::effect_index(effect)].offset_of(key);
  const physics::ParameterSpec& spec = spec_of(effect, key);
  PLUMBLINE_CHECK(index >= 0 && index < spec.size());
  Unknown unknown{std::string(effect), std::string(key), spec.size() == 1 ? -1 : index, row};
  unknown.terms = {{first + index, 1}};
  unknown.start = forces_.parameters[static_cast<std::size_t>(first + index)];
  return append(std::move(unknown));
}

std::size_t Unknowns::add_shared(std::string_view effect, std::string_view key) {
  const int first = instance(effect) + physics::effect_infos()[physics::effect_index(effect)].offset_of(key);
  const int size = spec_of(effect, key).size();
  Unknown unknown{std::string(effect), std::string(key)};
  unknown.start = mean_of(forces_, effect, key);
  const auto values = forces_.parameters.begin() + first;
  for (int i = 0; i < size; ++i) {
    unknown.terms.push_back({first + i, unknown.start != 0 ? values[i] / unknown.start : 1});
  }
  return append(std::move(unknown));
}

void Unknowns::add_effect(std::string_view effect) {
  for (const physics::ParameterSpec& spec : physics::effect_infos()[physics::effect_index(effect)].parameters) {
    for (int i = 0; i < (spec.setting ? 0 : spec.size()); ++i) add(effect, spec.key, i);
  }
}

void Unknowns::set_prior(std::size_t unknown, double sigma) {
  PLUMBLINE_CHECK(sigma > 0);
  list_[unknown].sigma = sigma;
  list_[unknown].scale = sigma;
}

void Unknowns::set_free(std::size_t unknown) { list_[unknown].sigma = std::numeric_limits<double>::infinity(); }

int Unknowns::find(std::string_view effect, std::string_view key, int index) const {
  const auto found = std::find_if(list_.begin(), list_.end(), [&](const Unknown& u) {
    return u.effect == effect && u.key == key && u.index == index && u.row == 0;
  });
  return found == list_.end() ? -1 : static_cast<int>(found - list_.begin());
}

std::vector<std::size_t> Unknowns::of_effect(std::string_view effect) const {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < list_.size(); ++i) {
    if (list_[i].effect == effect) places.push_back(i);
  }
  return places;
}

Eigen::VectorXd Unknowns::start() const {
  Eigen::VectorXd values(static_cast<Eigen::Index>(list_.size()));
  for (std::size_t i = 0; i < list_.size(); ++i) values[static_cast<Eigen::Index>(i)] = list_[i].start;
  return values;
}

Eigen::VectorXd Unknowns::scales() const {
  Eigen::VectorXd scales(static_cast<Eigen::Index>(list_.size()));
  for (std::size_t i = 0; i < list_.size(); ++i) scales[static_cast<Eigen::Index>(i)] = list_[i].scale;
  return scales;
}

physics::ForceModel Unknowns::at(const Eigen::VectorXd& values) const {
  PLUMBLINE_CHECK(values.size() == static_cast<Eigen::Index>(list_.size()));
  physics::ForceModel forces = forces_;
  for (std::size_t i = 0; i < list_.size(); ++i) {
    const double moved = values[static_cast<Eigen::Index>(i)] - list_[i].start;
    for (const Unknown::Term& term : list_[i].terms) {
      forces.parameters[static_cast<std::size_t>(term.parameter)] += term.weight * moved;
    }
  }
  return forces;
}

Unknowns nuisances(const machine::MachineModel& machine, const physics::ForceModel& forces) {
  Unknowns unknowns(forces);
  for (const machine::KeySpec& listed : machine::kKeys) {
    if (listed.table != kUncertainty) continue;
    const double uncertainty = machine.uncertainty(listed.key).value_or(0);
    if (uncertainty <= 0) continue;
    for (const KeyOfEffect& key : keys_known_by(listed.key)) {
      // what has no unit is a share of what is known
      const double sigma =
          listed.unit.name.empty() ? uncertainty * mean_of(forces, key.effect, key.spec->key) : uncertainty;
      if (sigma <= 0) continue;
      for (int i = 0; i < (key.spec->shared ? 1 : key.spec->size()); ++i) {
        unknowns.set_prior(key.spec->shared ? unknowns.add_shared(key.effect, key.spec->key)
                                            : unknowns.add(key.effect, key.spec->key, i),
                           sigma);
      }
    }
  }
  return unknowns;
}

}  // namespace plumbline::identify
