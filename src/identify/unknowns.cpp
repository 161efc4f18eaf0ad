#include "identify/unknowns.hpp"

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

// What people call the keys of the model file; keys of effects go by their own names.
std::string short_name(std::string_view key) {
  struct Name {
    std::string_view key, name;
  };
  static constexpr std::array kNames{
      Name{"compliance_per_length_um_N_m", "K1"}, Name{"compliance_um_N", "K2"},
      Name{"coulomb_friction_N", "friction"},     Name{"centre_of_mass_mm", "centre of mass"},
      Name{"screw_mass_kg", "screw mass"},        Name{"motor_mass_kg", "motor mass"},
      Name{"mass_kg", "platform mass"},           Name{"viscous_friction_Nms_rad", "joint friction"}};
  for (const Name& name : kNames) {
    if (name.key == key) return std::string(name.name);
  }
  return std::string(key);
}

std::string label_of(std::string_view effect, const physics::ParameterSpec& spec, int index) {
  constexpr std::string_view kAxes = "xyz";
  const bool base = !spec.table.empty();
  std::string label = base ? short_name(spec.key) : fmt::format("{} {}", effect, spec.key);
  if (index < 0) return label;
  if (spec.each == 3) return label + fmt::format(" strut {} {}", index / 3 + 1, kAxes[index % 3]);
  if (spec.count == 6) return label + fmt::format(" strut {}", index + 1);
  if (spec.count > 1) return label + fmt::format(" {}", kAxes[index]);
  return label;
}

// The mean of a key's numbers in the first instance of an effect that acts.
double mean_of(const physics::ForceModel& forces, std::string_view effect, std::string_view key) {
  const int size = spec_of(effect, key).size();
  const auto first = forces.parameters.begin() + forces.find(effect, key);
  return std::accumulate(first, first + size, 0.0) / size;
}

}  // namespace

int Unknowns::instance(std::string_view effect) {
  const std::size_t index = physics::effect_index(effect);
  PLUMBLINE_CHECK(index < physics::kEffects);
  const std::vector<int>& instances = forces_.instances_of(index);
  return instances.empty() ? forces_.add(effect) : instances.front();
}

std::size_t Unknowns::append(Unknown unknown) {
  const physics::ParameterSpec& spec = spec_of(unknown.effect, unknown.key);
  unknown.unit = spec.unit;
  unknown.label = label_of(unknown.effect, spec, unknown.index);
  unknown.lower = spec.lower * spec.unit.si;
  unknown.upper = spec.upper * spec.unit.si;
  unknown.scale = kShareOfRange * (spec.upper - spec.lower) * spec.unit.si;
  // keys of the model file have bounds that only slips of units exceed: they say nothing of what matters
  if (!spec.table.empty()) unknown.scale = unknown.start != 0 ? std::abs(unknown.start) : spec.unit.si;
  list_.push_back(std::move(unknown));
  return list_.size() - 1;
}

std::size_t Unknowns::add(std::string_view effect, std::string_view key, int index) {
  const int first = instance(effect) + physics::effect_infos()[physics::effect_index(effect)].offset_of(key);
  const physics::ParameterSpec& spec = spec_of(effect, key);
  PLUMBLINE_CHECK(index >= 0 && index < spec.size());
  Unknown unknown{std::string(effect), std::string(key), spec.size() == 1 ? -1 : index};
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
    return u.effect == effect && u.key == key && u.index == index;
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
  const auto sigma_of = [&](const char* key) { return machine.uncertainty(key).value_or(0); };
  const auto each = [&](const char* listed, const char* effect, const char* key) {
    const double sigma = sigma_of(listed);
    if (sigma <= 0) return;
    for (int i = 0; i < spec_of(effect, key).size(); ++i) unknowns.set_prior(unknowns.add(effect, key, i), sigma);
  };
  const auto shared = [&](const char* listed, const char* effect, const char* key) {
    const double sigma = sigma_of(listed);
    if (sigma > 0) unknowns.set_prior(unknowns.add_shared(effect, key), sigma);
  };
  for (const char* key : {"compliance_per_length_um_N_m", "compliance_um_N"}) {
    const double sigma = sigma_of("compliance_relative") * mean_of(forces, "axial-elasticity", key);
    if (sigma > 0) unknowns.set_prior(unknowns.add_shared("axial-elasticity", key), sigma);
  }
  each("coulomb_friction_N", "screw-friction", "coulomb_friction_N");
  each("centre_of_mass_mm", "platform-gravity", "centre_of_mass_mm");
  each("platform_mass_kg", "platform-gravity", "mass_kg");
  shared("strut_mass_kg", "strut-gravity", "screw_mass_kg");
  shared("motor_mass_kg", "strut-gravity", "motor_mass_kg");
  each("level_mrad", "level", "tilt_mrad");
  each("strut_offset_um", "strut-offset", "length_um");
  each("joint_position_um", "joint-position", "base_um");
  each("joint_position_um", "joint-position", "platform_um");
  return unknowns;
}

}  // namespace plumbline::identify
