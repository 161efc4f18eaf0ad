// The residuals of one channel around the circle.
#pragma once

#include <array>
#include <complex>
#include <optional>

#include "base/mean_square.hpp"
#include "diagnose/readings/noise_spectrum.hpp"
#include "measure/dataset.hpp"

namespace plumbline::diagnose {

inline constexpr int kArcs = 12;   // of a circle
inline constexpr int kWaves = 10;  // orders 1 to 10 of a circle

/// The residuals of one channel around the circle, all runs together. SI.
struct ChannelResiduals {
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

/// Sums of squares of bar and torques.
struct BarAndTorqueSquares {
  MeanSquare radial, torque;
  void add(int channel, double value) { (channel == identify::kRadial ? radial : torque).add(value); }
  BarAndTorque root() const { return {radial.root(), torque.root()}; }
};

/// What a run leaves of a channel; nothing if that was not measured.
std::optional<Eigen::VectorXd> channel_of(const identify::RunEquations& run, int channel);

/// Amplitude and phase of the wave of one order: a exp(i phase) / 2.
std::complex<double> wave_of(const Eigen::VectorXd& e, const std::vector<double>& angle, int order);

/// All runs together, with the noise as estimated.
ChannelResiduals around_the_circle(const std::vector<measure::Run>& runs,
                                   const std::vector<identify::RunEquations>& residuals, int channel,
                                   const identify::ChannelNoise& noise);

}  // namespace plumbline::diagnose
