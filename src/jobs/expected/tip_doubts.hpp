// How far the tip may be from where a model has it, at a pose: the posterior of the model's numbers carried to the tip.
#pragma once

#include <list>
#include <optional>
#include <vector>

#include "compensate/corrector.hpp"
#include "compensate/settings.hpp"
#include "compensate/target.hpp"
#include "identify/equations/sensitivity.hpp"
#include "identify/posterior/posterior.hpp"
#include "jobs/expected/causes.hpp"

namespace plumbline::jobs {

/// Of the distance of the tip from where the model has it, e: m.
struct TipDoubt {
  double mean = 0;                                      // of |e|
  double within = 0;                                    // what |e| does not exceed with 95 %
  Vector3<double> axis_mean = Vector3<double>::Zero();  // of e along X, Y, Z of W
  Vector3<double> axis_within =
      Vector3<double>::Zero();        // what |e| along an axis does not exceed with 95 %; nil: unasked
  std::array<double, kCauses> rms{};  // of e, by what makes it
};

/// At one pose: as the tip stands, and with the zero touched off at another one.
struct PoseDoubt {
  TipDoubt stands;
  std::optional<TipDoubt> touched_off;
};

inline constexpr double kStatedProbability = 0.95;

/// A machine with a posterior. To first order in its numbers about each of its states; states beside the model's own
/// are played as they are. The slopes are exact (identify::Sensitivity). e = S (p - p_model), touched off
/// e = (S - S_zero) (p - p_model); what no number stands for adds alike on each axis, and at both places.
class TipDoubts {
 public:
  /// Both must outlive it.
  TipDoubts(const machine::MachineModel& model, const identify::Posterior& posterior,
            const compensate::Settings& settings);
  TipDoubts(const TipDoubts&) = delete;
  TipDoubts& operator=(const TipDoubts&) = delete;

  /// From now on axis_within is not computed.
  void leave_out_axes() { says_axes_ = false; }
  void set_tool(const compensate::ToolInSpindle& tool);
  /// Where the zero is touched off, the machine at rest: pose in W, mm and deg. False: the machine cannot stand there.
  bool touch_off(const AxisWords& pose);

  /// Nothing where the machine cannot stand.
  std::optional<PoseDoubt> at(const compensate::Target& target) const;

 private:
  // One way in which the machine may be.
  struct State {
    State(const identify::Posterior& posterior, const identify::PosteriorState& state, bool own);

    const identify::PosteriorState& of;
    physics::ForceModel forces;
    identify::Sensitivity sensitivity;
    Eigen::VectorXd off;        // of the mean from the model's numbers; none where the state is played
    Eigen::VectorXd precision;  // 1 / sigma^2 of each prior; 0: free
  };
  // What a state makes of the tip.
  struct Played {
    Vector3<double> off;  // of the tip where all numbers are the model's, from where the model has it
    Eigen::Matrix3Xd slopes;
  };
  physics::Motion<double> motion(const compensate::Target& target) const;
  std::optional<std::vector<Played>> played(const physics::Motion<double>& motion) const;
  TipDoubt doubt_of(const std::vector<Played>& played, double places) const;

  const identify::Posterior& posterior_;
  const machine::MachineModel& model_;
  bool says_axes_ = true;
  double time_s_;
  double radius_;  // of the platform, m
  physics::Environment environment_;
  std::list<State> states_;    // the sensitivity of each refers to its forces
  std::vector<Cause> causes_;  // of each unknown
  std::optional<std::vector<Played>> zero_;
};

}  // namespace plumbline::jobs
