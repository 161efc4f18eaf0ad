// The noise of the readings from their spectrum: what a wrong model leaves weighs little in it.
#pragma once

#include "identify/equations/noise.hpp"

namespace plumbline::diagnose {

struct SpectrumOptions {
  double trimmed = 0.25;         // share of the runs, those of most power at a frequency, that are left out
  int bands = 24;                // of frequencies that are taken together
  double colour_step = 0.05;     // of the grid on which memory and white share are looked for
  double most_colour = 0.96;     // above that noise and drift are no longer distinguished
  double least_sigma_um = 1e-3;  // what is less is rounding
  double least_sigma_Nm = 1e-5;
};

/// White noise and noise that remembers, as sizes per channel; the colour is that of all torques alike. From the
/// periodograms of residuals of runs, the trimmed mean over runs in bands of frequency, by Whittle's likelihood
/// [Whittle 1953]. Trimming: what the model lacks shows in some runs more than in others.
identify::NoiseModel noise_of(const std::vector<identify::RunEquations>& runs, const SpectrumOptions& options = {});

/// The power of such noise at a frequency (cycles per sample), SI^2; of white noise its variance.
double noise_power(const identify::ChannelNoise& noise, double frequency);

}  // namespace plumbline::diagnose
