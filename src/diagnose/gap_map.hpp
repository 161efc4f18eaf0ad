// Where model and measurements disagree: residuals cut in the ways in which effects show.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "diagnose/noise_spectrum.hpp"
#include "measure/dataset.hpp"
#include "physics/force_model.hpp"

namespace plumbline::diagnose {

inline constexpr int kArcs = 12;   // of a circle
inline constexpr int kWaves = 10;  // orders 1 to 10 of a circle

/// The residuals of one channel around the circle, all runs together. SI.
struct ChannelWhere {
  int channel = 0;
  double rms = 0;
  std::array<double, kArcs> arcs{};         // rms in each twelfth, counted from angle 0
  std::array<double, kWaves> waves{};       // rms of the wave of each order
  std::array<double, kWaves> wave_noise{};  // what the noise alone makes of it
};

/// Bar and torques, rms, SI; of readings that were not measured 0.
struct BarAndTorque {
  double radial = 0;
  double torque = 0;
};

/// How the waves of two runs at one pose agree, over many pairs and orders. The noise of one run knows nothing of that
/// of another: between their waves every phase is as likely as any other, whatever the noise is like.
struct Recurrence {
  double chi2 = 0;  // for each order and channel: the sum of Re(a conj b) over the pairs, squared, in units of its
  int count = 0;    // variance where phases are drawn evenly; how many these are
  double correlation = 0;  // sum of Re(a conj b) over the sum of |a b|, from -1 to 1
};

/// Pairs of runs at one pose that differ in one thing alone, compared at equal angles. Where nothing but noise is left,
/// both are the noise's sigma.
struct Contrast {
  std::string by;  // "direction", "feed", "payload", "time"
  int pairs = 0;
  BarAndTorque common;   // rms of (a + b) / sqrt 2
  BarAndTorque differs;  // rms of (a - b) / sqrt 2
  Recurrence radial, torque;
};

/// Runs that have something in common.
struct RunGroup {
  std::string by;  // "tilt_deg", "feed_mm_min", "payload_kg", "start_h"
  double from = 0;
  double to = 0;
  int runs = 0;
  BarAndTorque rms;
};

/// What readings do where a strut turns around, in the direction of its growing speed: as a change of the strut's
/// length (from the bar), and of its motor's torque. SI.
struct Reversal {
  int strut = 0;
  int count = 0;
  double length = 0;
  double length_error = 0;  // standard error, from the scatter of the steps; 0: not measured
  double torque = 0;
  double torque_error = 0;
};

struct GapMap {
  std::vector<ChannelWhere> channels;
  std::vector<Contrast> contrasts;
  std::vector<RunGroup> groups;
  std::vector<Reversal> reversals;
};

struct GapMapOptions {
  std::vector<double> tilts_deg{0, 5, 15, 90};  // edges of the groups
  int start_groups = 3;                         // parts of the time from the first run to the last
  double reversal_window = 0.21;                // rad, half of it before a reversal, half behind
};

/// By direction, feed, payload and time, where there are such pairs. `residuals` are those of `runs`.
std::vector<Contrast> contrasts_of(const std::vector<measure::Run>& runs,
                                   const std::vector<identify::RunEquations>& residuals);

/// `residuals` are those of `runs` (all of them) beside `forces`, the set-ups fitted.
GapMap where_of(const machine::RotationOrder& order, const std::vector<measure::Run>& runs,
                const physics::ForceModel& forces, const std::vector<identify::RunEquations>& residuals,
                const identify::NoiseModel& noise, const GapMapOptions& options = {});

}  // namespace plumbline::diagnose
