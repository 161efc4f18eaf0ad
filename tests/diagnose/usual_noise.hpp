// Noise of the usual size, for the tests of this module.
#pragma once

#include "identify/equations/noise.hpp"

namespace plumbline::testing {

/// 0.5 um and 0.05 N m. What testing::measured makes has a memory of 0.6.
inline identify::NoiseModel usual_noise(double memory = 0, double white = 0) {
  identify::NoiseModel noise;
  for (identify::ChannelNoise& channel : noise.channels) channel = {0.05, memory, 1, white};
  noise.channels[identify::kRadial].sigma = 0.5e-6;
  return noise;
}

}  // namespace plumbline::testing
