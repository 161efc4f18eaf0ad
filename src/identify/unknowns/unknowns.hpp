// What is not known of a machine: named numbers that a fit may change, each of them one parameter of a force model or
// several that move together.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "machine/model.hpp"
#include "physics/force_model.hpp"

namespace plumbline::identify {

struct Unknown {
  /// A parameter of the force model and how far it moves when the unknown moves by one.
  struct Term {
    int parameter = 0;
    double weight = 1;
  };

  std::string effect;  // a name of the list of effects
  std::string key;     // of its parameters
  int index = -1;      // among the key's numbers; -1: the key is one number, or all six struts share it
  int row = 0;         // of the rows of that effect
  std::string label;   // as people call it: "K1", "joint-position base_um strut 3 y"
  machine::Unit unit;  // of files
  std::vector<Term> terms;

  // SI from here on
  double start = 0;                                         // what the force model had
  double sigma = std::numeric_limits<double>::infinity();   // of what is known beforehand; infinite: free
  double lower = -std::numeric_limits<double>::infinity();  // bounds
  double upper = std::numeric_limits<double>::infinity();
  double scale = 1;  // a change that matters: sigma; of what is free its value, or a hundredth of an effect's range

  bool shape = false;  // see physics::ParameterSpec
  bool periodic = false;

  bool free() const { return !(sigma < std::numeric_limits<double>::infinity()); }
};

/// Unknowns and the force model that they belong to. The model holds an instance of every effect that they need; as it
/// stands, all unknowns are at their start.
class Unknowns {
 public:
  explicit Unknowns(physics::ForceModel forces) : forces_(std::move(forces)) {}

  /// One number of an effect's key, free within the effect's bounds. Adds the effect if it does not act yet. `index`
  /// counts the key's numbers from 0, `row` the effect's rows. Returns its place in the list.
  std::size_t add(std::string_view effect, std::string_view key, int index, int row = 0);
  /// All numbers of a key that the struts share: they move in proportion to what they are; if they are all zero, alike.
  std::size_t add_shared(std::string_view effect, std::string_view key);
  /// Every number of every key of an effect that is no setting, free within its bounds.
  void add_effect(std::string_view effect);
  /// States what is known of an unknown beforehand: its start, give or take sigma (SI).
  void set_prior(std::size_t unknown, double sigma);
  /// Nothing is known of it beforehand.
  void set_free(std::size_t unknown);

  std::size_t size() const { return list_.size(); }
  const Unknown& operator[](std::size_t i) const { return list_[i]; }
  const std::vector<Unknown>& list() const { return list_; }
  std::vector<Unknown>::const_iterator begin() const { return list_.begin(); }
  std::vector<Unknown>::const_iterator end() const { return list_.end(); }
  /// The place of a number of an effect's first row in the list, -1 if it is not unknown.
  int find(std::string_view effect, std::string_view key, int index = -1) const;
  /// All places of an effect's numbers.
  std::vector<std::size_t> of_effect(std::string_view effect) const;

  const physics::ForceModel& forces() const { return forces_; }
  /// Where all unknowns start, SI.
  Eigen::VectorXd start() const;
  /// Their scales, SI.
  Eigen::VectorXd scales() const;
  /// The force model with the unknowns at `values` (SI, in the order of the list).
  physics::ForceModel at(const Eigen::VectorXd& values) const;

 private:
  std::size_t append(Unknown unknown);
  int instance(std::string_view effect, int row = 0);

  physics::ForceModel forces_;
  std::vector<Unknown> list_;
};

/// A key of an effect.
struct KeyOfEffect {
  std::string_view effect;
  const physics::ParameterSpec* spec = nullptr;
};
/// The keys that a key of [uncertainty] says the sigma of, in the order of the list of effects.
std::vector<KeyOfEffect> keys_known_by(std::string_view uncertainty);

/// What the owner of the model does not know better: exactly the keys of its [uncertainty], each with its sigma, all
/// independent. joint_position_um on each coordinate of each joint, strut_offset_um and coulomb_friction_N on each
/// strut, compliance_relative on K1 and on K2, centre_of_mass_mm on each axis, level_mrad on rx and ry, and the masses
/// that are listed; a mass of struts is shared by all six.
Unknowns nuisances(const machine::MachineModel& machine, const physics::ForceModel& forces);

}  // namespace plumbline::identify
