// Pairs of runs at one pose that differ in one thing alone.
#pragma once

#include <string_view>

#include "diagnose/gap/channels.hpp"

namespace plumbline::diagnose {

/// How the waves of two runs at one pose agree, over many pairs and orders. The noise of one run knows nothing of that
/// of another: between their waves every phase is as likely as any other, whatever the noise is like.
struct Recurrence {
  double chi2 = 0;  // for each order and channel: the sum of Re(a conj b) over the pairs, squared, in units of its
  int count = 0;    // variance where phases are drawn evenly; how many these are
  double correlation = 0;  // sum of Re(a conj b) over the sum of |a b|, from -1 to 1
};

/// What two runs at one pose differ in, and in nothing else.
enum class Difference { direction, feed, payload, time };
std::string_view to_text(Difference difference);

/// Pairs of runs at one pose that differ in one thing alone, compared at equal angles. Where nothing but noise is left,
/// both are the noise's sigma.
struct Contrast {
  Difference by = Difference::direction;
  int pairs = 0;
  BarAndTorque common;   // rms of (a + b) / sqrt 2
  BarAndTorque differs;  // rms of (a - b) / sqrt 2
  Recurrence radial, torque;
};

/// By direction, feed, payload and time, where there are such pairs. `residuals` are those of `runs`.
std::vector<Contrast> contrasts_of(const std::vector<measure::Run>& runs,
                                   const std::vector<identify::RunEquations>& residuals);

/// Rms of what comes again in the readings of the bar, m: the root of the mean product of two runs' residuals at equal
/// angles, which their noise leaves as it is; over all pairs. 0: there are none, or nothing comes again.
double recurring_radial(const std::vector<Contrast>& contrasts);

}  // namespace plumbline::diagnose
