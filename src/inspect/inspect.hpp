// The data are judged before anything is learnt from them: which runs do not fit the others, and what would mend them.
#pragma once

#include "base/units.hpp"
#include "inspect/fault.hpp"
#include "inspect/outliers.hpp"
#include "inspect/records/records.hpp"

namespace plumbline::inspect {

/// Less than that nobody gets wrong: machines do it.
struct LeastFaults {
  double samples = 1;       // of a clock
  double angle = 2 * kDeg;  // of an angle zero
  double place = 2 * kMm;   // of centre, radius and bar
  double tilt = 0.5 * kDeg;
  double payload = 0.5;  // kg
  double noises = 4;     // of a drift, a step, a zero, in units of the noise that is assumed
};

struct InspectOptions {
  LeastFaults least;
  RecordOptions records;
  LineOptions lines;
  measure::Instrument instrument;  // what it states of its noise
  OutlierOptions outliers;
  std::size_t most_samples = 180;  // of a run that are looked at
  double beyond_limits = 0.5;    // of the travel of a strut, by which a run may be beyond the lengths that it can have
  double least_nats = 25;        // by which a fault must make the readings more likely
  double setting_nats = 100;     // the same of settings: their numbers follow much that a model lacks, too
  double clearly = 1.5;          // times as far off as when it is mended is a run that is clearly wrong
  double as_far_off = 0.95;      // of what a run is off, from which others are off by as much
  double explained = 0.7;        // of what a run is off beyond the usual, that a fault must take away
  double near = 2.2;             // times the usual mean square, within which a mended run must come
  double as_good = 12;           // nats within which another fault explains a run as well
  double stands_out = 9;         // times the usual mean square, from which a run stands out by itself,
  double beyond_next = 4;        // and so many times that of the next one
  double all_explained = 0.35;   // of what all runs are off beyond noise that a clock or an angle of all may leave
  double all_nats = 100;         // by which a fault of all runs must make the readings more likely
  double all_open = 1.05;        // times the noise, from which something stays open in all runs
  double drift_sigmas = 12;      // of chi-square over all runs, from which all of them drift
  double larger = 1.5;           // times what the instrument states, from which noise is said to be larger
  double least_noise = 0.2;      // of the noise that is assumed
  double coarse = 2.5;           // times its noise from sample to sample a channel is off, from which something may
                                 // be wrong with all runs
  double usual_radial = 0.5e-6;  // m: noise that is assumed before any is estimated
  double usual_torque = 0.05;    // N m
};

/// Judges the runs of a dataset against the model with its priors, the catalogue of effects and each other. Nothing is
/// mended. Runs that the machine cannot make are not looked at.
Inspection inspect(const machine::MachineModel& machine, const std::vector<measure::Run>& runs,
                   const InspectOptions& options = {});

/// The runs without single spikes, and without what is periodic in time, as everything else takes them.
std::vector<measure::Run> cleaned(std::vector<measure::Run> runs, const Inspection& inspection,
                                  const InspectOptions& options = {});

}  // namespace plumbline::inspect
