// How far the readings of a machine move with each unknown: exact derivatives through the fixed point that finds where
// the machine stands.
#pragma once

#include <array>
#include <vector>

#include "identify/equations/jet.hpp"
#include "identify/unknowns/unknowns.hpp"
#include "physics/error.hpp"

namespace plumbline::identify {

/// Rows: where the tip stands (x, y, z in W, m), the torques of the six motors (N m), how the platform is turned
/// (rotation vector in W, rad; to first order of the error's own turn). A column for each unknown.
inline constexpr int kTipRow = 0;
inline constexpr int kTorqueRow = 3;
inline constexpr int kTurnRow = 9;
inline constexpr int kOutcomes = 12;
using Slopes = Eigen::Matrix<double, kOutcomes, Eigen::Dynamic>;

/// Derivatives for one force model. The unknowns and the model are those that a point was simulated with; the model
/// holds the effects of the unknowns (Unknowns::at).
class Sensitivity {
 public:
  /// `forces` is kept by reference.
  Sensitivity(const physics::ForceModel& forces, const Unknowns& unknowns);

  /// Fills `slopes` (12 x unknowns) for the point that `error` is the converged result of. May be called from several
  /// threads.
  void at(const physics::Environment& environment, const physics::Motion<double>& motion,
          const physics::TipError<double>& error, Eigen::Ref<Slopes> slopes) const;

  Eigen::Index unknowns() const { return unknowns_; }

 private:
  // An unknown's part in a parameter of an instance of an effect.
  struct Seed {
    int offset = 0;  // from the instance's first parameter
    int slot = 0;    // which of the derivatives carries it
    double weight = 1;
  };
  // Up to six unknowns that work through one instance.
  struct Chunk {
    int first = 0;  // parameter of the instance
    std::vector<Seed> seeds;
    std::array<int, kSeeds> unknowns{};
    int used = 0;
  };
  // Up to six unknowns of each strut that work through one instance of an effect whose numbers move their own strut
  // alone: the struts share the derivatives. No unknown: -1.
  struct StrutChunk {
    int first = 0;
    std::vector<Seed> seeds;
    std::array<std::array<int, machine::kStruts>, kSeeds> unknowns{};
  };
  struct Point;

  void add_seed(std::size_t effect, int first, int unknown, Seed seed);
  void add_strut_seed(std::size_t effect, int first, int unknown, Seed seed);
  template <class Effect>
  void add_slopes(const Chunk& chunk, Point& point, Eigen::Ref<Slopes> slopes) const;
  template <class Effect>
  void add_strut_slopes(const StrutChunk& chunk, Point& point, Eigen::Ref<Slopes> slopes) const;
  template <class Effect>
  auto seeded(int first, const std::vector<Seed>& seeds) const;

  const physics::ForceModel& forces_;
  Eigen::Index unknowns_ = 0;
  std::vector<Jet> parameters_;                               // of the model, without derivatives
  std::array<std::vector<Chunk>, physics::kEffects> chunks_;  // by effect
  std::array<std::vector<StrutChunk>, physics::kEffects> strut_chunks_;
};

}  // namespace plumbline::identify
