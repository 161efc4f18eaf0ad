// What records say by themselves, without any model: spikes, gaps, channels that stand still, motors that read noise,
// two runs with the same readings or under way at once.
#pragma once

#include "inspect/fault.hpp"
#include "measure/dataset.hpp"

namespace plumbline::inspect {

struct RecordOptions {
  double spike = 12;              // robust standard deviations by which a sample is off its neighbours on either side
  double returns = 0.25;          // of a spike's height: further apart than that its neighbours are a step
  double step = 0.15;             // of it: off a parabola by more they are a step, which is 0.4, however noisy
  double least_radial = 0.02e-6;  // m, noise that any bar has
  double least_torque = 1e-3;     // N m, and any motor
  double of_bend = 0.15;          // of what neighbours bend: edges of two steps beside each other are no more than that
  double most_spikes = 0.03;      // of the samples of a run; with more it is no single spikes
  double gap = 3.5;               // usual steps of angle between two samples
  double same_readings = 0.9;     // of the samples of two runs
  std::size_t standing = 12;      // samples one after the other that are alike
  double stands = 0.2;            // share of the samples of a channel that stand together
  double silent = 0.2;            // correlation of samples beside each other, up to which a motor reads noise
  double follows = 0.8;           // and from which it follows the way
  double feed = 0.03;             // by which the feed that is stated may be off what the times say
};

/// The readings of a channel; empty: not measured.
const std::vector<double>& readings_of_channel(const measure::Run& run, int channel);

/// How fast a run goes around as its angles and times have it, rad/s.
double rate_of(const measure::Run& run);

/// Samples with a spike in any channel, ascending.
std::vector<std::size_t> spikes_in(const measure::Run& run, const RecordOptions& options = {});

/// All of it; no fault is fitted to anything.
std::vector<Fault> record_faults(const std::vector<measure::Run>& runs, const RecordOptions& options = {});

}  // namespace plumbline::inspect
