// What speaks against a fit that converged: unknowns further off than anybody thought possible, and circles that it
// predicts worse than the model it began with.
#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "identify/fit.hpp"
#include "identify/prior_strain.hpp"

namespace plumbline::identify {

struct PlausibleOptions {
  double most_sigmas = 6;         // that one unknown may be off from what was known of it
  double most_sigmas_all = 3.09;  // as a normal deviate, of what all of them together may be: one machine of a thousand
  double least_share = 0.03;    // of a direction's prior variance that the data take away, from which they say anything
  double worse_times = 1.1;     // as far off as the base model may the fit be on circles that it did not see
  double expected_times = 2;    // as far off as it must expect, unsure of its unknowns as it is, may it be beside that
  double least_radial = 2e-8;   // m; less than that is rounding
  double least_torque = 1e-3;   // N m
  std::size_t least_poses = 3;  // with fewer no pose can be spared
  // a fit is borne out, though priors together are not, where
  double predicted = 0.5;       // more than so much of what the bar says beside the base model is predicted
  double may_be_worse = 0.1;    // and no more than that is the chance that the tip comes out further off
  double open_share = 1.0 / 3;  // of the gap before: a gap that is no noise is open where more is left of it
  bool joints_seen = false;     // a tracker measured where the joints are: that they are far off is what it is for
};

/// An unknown with a prior, and how many of its sigmas the fit moved it.
struct Strain {
  std::size_t unknown = 0;
  double sigmas = 0;
};

/// Rms of readings of one kind that a fit to all other poses leaves, the set-ups fitted, and what the start leaves.
struct Predicted {
  double before = 0, after = 0;  // m or N m
  double doubt = 0;              // rms by which `after` is off as a fit to the other poses does not know its unknowns
  Eigen::Index readings = 0;

  /// How much of the mean square that the start leaves is explained on poses left out.
  double predicted() const { return readings > 0 && before > 0 ? 1 - after * after / (before * before) : 0; }
  bool worse(const PlausibleOptions& than, double least) const {
    return readings > 0 && after > std::hypot(than.worse_times * before + least, than.expected_times * doubt);
  }
};

struct Plausibility {
  std::vector<Strain> strained;  // beyond most_sigmas, the furthest first
  double chi2 = 0;               // of all priors together: how far the data moved what they tell
  double degrees = 0;            // of freedom: directions of the unknowns that the data tell
  double all_sigmas = 0;         // chi2 as the normal deviate that is as rare
  bool all_strained = false;     // and that is beyond most_sigmas_all
  Eigen::MatrixXd left_out;      // how far each unknown moves when a pose is left out, SI: a column for each pose
  Predicted radial, torque;      // poses left out in turn; no readings: too few poses

  double widening() const { return PriorStrain{chi2, degrees}.widening(); }
};

/// How sure the values found are: of `fit` (rows and columns of zeros: what nothing tells), wider where chi2 says that
/// the priors are too narrow, by chi2 / degrees  [Birge 1932], and wider by what leaving out poses changes: their
/// jackknife  [Efron 1982]. What a model lacks moves each pose otherwise, which no estimate of the noise knows.
Eigen::MatrixXd doubt_of(const Fit& fit, const Plausibility& plausible);

/// Each pose is left out in turn, to first order about the fit: no second fit is made.
Plausibility plausibility(const machine::RotationOrder& order, const std::vector<measure::Run>& runs, const Fit& fit,
                          const FitOptions& fitted_with, const PlausibleOptions& options = {});

/// How far each unknown moves when a pose is left out, to first order about the fit, SI: a column for each pose; none
/// where there are fewer than `least_poses`.
Eigen::MatrixXd moved_by_poses(const machine::RotationOrder& order, const std::vector<measure::Run>& runs,
                               const Fit& fit, const ObjectiveOptions& fitted_with, std::size_t least_poses);

/// Those moves so that the sum of their outer products is what they add to a covariance: their jackknife.
Eigen::MatrixXd jackknife(const Eigen::MatrixXd& moved_by_poses);

/// The same number for runs at one pose (centre and tilt), from 0 in the order in which poses come first.
std::vector<int> poses_of(const std::vector<measure::Run>& runs);

/// Whether circles that a fit did not see are predicted by it better than not, and the tip is hardly further off with
/// it: `chance`, the larger of those where it stands and with its zero touched off. It then stands for what the model
/// lacks, though it says it in other words.
bool borne_out(const Plausibility& plausible, double chance, const PlausibleOptions& options = {});

/// What speaks against a fit; the numbers are in its Plausibility.
enum class Objection {
  strained,      // single priors are refuted
  all_strained,  // the priors together are
  radial_worse,  // circles that a fit to the others did not see are further off than with the model as given:
  torque_worse,  // readings of the bar, or torques
};

/// Why a fit is not to be believed; nothing speaks against it where there is none. That priors together are refuted
/// does not speak against a fit that is borne out.
std::optional<Objection> objection(const Plausibility& plausible, bool borne_out, const PlausibleOptions& options = {});

}  // namespace plumbline::identify
