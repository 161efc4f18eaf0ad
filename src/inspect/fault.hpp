// What may be wrong with measurements themselves: facts, which the report puts into words.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "inspect/lines.hpp"

namespace plumbline::inspect {

enum class FaultKind {
  // what the dataset says of a run
  direction,
  angle_zero,
  centre,
  tilt,
  payload,
  radius,
  bar_length,
  feed,
  exchanged,  // it has what the dataset says of another run
  // what a channel holds
  bar_sign,
  bar_unit,
  motor_sign,
  motors_swapped,
  torque_unit,
  clock,            // of the motors beside the bar's
  drift,            // of the bar within a run
  bar_step,         // the bar slipped
  motor_zero,       // a torque is off by a constant
  motors_unsigned,  // the sizes of the torques, without their signs
  motor_silent,     // noise, and nothing of the way
  stuck,            // a channel stands still
  clipped,          // or stands at its end
  noisy,            // or is noisier than in other runs
  // the records
  same_readings,  // two runs have the same readings
  motors_alike,   // two motors have the same readings
  start,          // runs are said to go on while the next ones begin
  spikes,
  gaps,
  unreachable,  // the machine cannot stand there
  periodic,     // in time: a floor, a pump, the mains; kept out of everything else
  noise,        // larger than the instrument states
  stands_out,   // nothing of the above explains it
};
/// "direction", "angle-zero", ...
std::string_view to_text(FaultKind kind);

/// Where a run was made and with what: a number, or several, of what the dataset says of it.
bool is_setting(FaultKind kind);
/// A setting, or something that a channel has more or less of.
bool is_by_degrees(FaultKind kind);

/// One thing that is wrong with one run, or alike with all of them.
struct Fault {
  FaultKind kind = FaultKind::stands_out;
  std::vector<std::size_t> runs;  // of the dataset
  bool all = false;               // it is alike in all runs
  std::vector<int> channels;      // identify's; those that it is about
  std::vector<double> values;     // what was found, SI: an angle, a place, a mass, a factor
  std::size_t like = 0;           // of two runs that have something in common: the other one
  // Misfit of these runs as the others and the model predict them, in units of the noise, as stated and if this is
  // mended; nil where it was not fitted.
  double before = 0;
  double after = 0;
  double nats = 0;                  // by which mending it makes the readings more likely
  std::vector<FaultKind> or_these;  // that explain it about as well
  bool may_be_effect = false;       // what the model lacks may look like it
  bool blocks = true;               // no name is given to an effect before it is mended or accepted
};

/// How far one run is from what all others and the model with its priors and the whole catalogue predict.
struct RunMisfit {
  double all = 0;                // in units of the noise
  std::vector<double> channels;  // the same of each channel, about the prediction; nil: not measured
};

struct Inspection {
  std::vector<Fault> faults;
  std::vector<RunMisfit> runs;
  double usual = 1;          // the median misfit of runs nothing is wrong with
  std::vector<Line> lines;   // periodic in time
  std::size_t left_out = 0;  // samples that were left out: spikes, empty cells

  /// The faults that stand in the way of a name.
  bool blocks() const;
};

}  // namespace plumbline::inspect
