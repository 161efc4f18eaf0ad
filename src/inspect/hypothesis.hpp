// What may be wrong with a run, each tried: fitted, and weighed against what the other runs predict.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "inspect/fault.hpp"
#include "inspect/prediction.hpp"

namespace plumbline::inspect {

/// What a hypothesis makes of the misfit of the runs that it is about.
struct Tried {
  Fault fault;
  double chi2 = 0;     // of the rows, mended
  double penalty = 0;  // nats for what was fitted, and for the alternatives that were tried
};

/// Runs that are mended alike, and what is known of the machine from elsewhere.
struct Suspects {
  const Bench& bench;
  const std::vector<measure::Run>& all;    // the dataset
  const std::vector<measure::Run>& whole;  // with the samples where struts turn round
  std::vector<std::size_t> runs;           // which of them
  std::vector<const RunRows*> rows;        // of these
  const Knowledge& known;
};

/// Something else was said of a run than is true of it: `made` is the run as it would then be; `start` and `step` of
/// the numbers that are fitted.
struct Relabelled {
  FaultKind kind = FaultKind::direction;
  std::function<measure::Run(const measure::Run&, const Eigen::VectorXd&)> made;
  Eigen::VectorXd start, step;  // none: nothing is fitted
  double alternatives = 1;      // that were tried of this kind
  std::size_t like = 0;         // the run whose description it would have
};

/// A run that went around the other way.
measure::Run turned_back(measure::Run run);
/// What is easily mistaken of a tilt, and of a centre: signs, and X for Y.
std::vector<std::function<void(measure::Run&)>> tilt_slips();
std::vector<std::function<void(measure::Run&)>> centre_slips();

/// Everything that may have been said wrongly.
std::vector<Relabelled> relabellings(const Suspects& suspects);
/// One radius, one length of the bar, or one angle zero, that was said wrongly of all suspects by a little. `closely`:
/// to the last digit, which takes as long as all else.
std::vector<Tried> tried_alike(const Suspects& suspects, bool closely = false);
/// All payloads times one factor, fitted.
Relabelled payload_factor();
/// Nothing: the machine cannot make such a run, or the fit leads nowhere.
std::optional<Tried> tried(const Suspects& suspects, const Relabelled& relabelled);

/// The misfit of the suspects as they are stated.
double chi2_as_stated(const Suspects& suspects);

/// A drift of the bar, the same within each suspect: what it takes of the misfit, and its size over the run, m.
/// Nothing: there are no readings of the bar.
struct Drift {
  double gain = 0, size = 0;
};
std::optional<Drift> drift_of(const Suspects& suspects);

/// The bar is quieter than any is, and reads the part of what is predicted that a larger unit leaves: the number of um
/// of the unit inverted, and the noise, m.
std::optional<Fault> finer_than_any_bar(const Suspects& suspects);
/// Runs of a machine that has nothing but its model and the priors of that: the bar reads the part of what is predicted
/// that a larger unit leaves, and in that unit fits far better. The number of um of the unit inverted.
std::optional<Fault> fits_in_larger_unit(const Suspects& suspects);

/// No torque is negative, and they follow the size of what the model predicts far better than that itself.
std::optional<Fault> has_no_signs(const Suspects& suspects);

/// What a channel may hold instead of what it says: signs, units, channels exchanged, steps and drifts.
std::vector<Tried> tried_channels(const Suspects& suspects);

}  // namespace plumbline::inspect
