// White noise of the usual size, for the tests of this module.
#pragma once

#include "identify/equations/noise.hpp"

namespace plumbline::testing {

/// 0.5 um and 0.05 N m that remember nothing.
inline identify::NoiseModel usual_noise() {
  identify::NoiseModel noise;
  for (identify::ChannelNoise& channel : noise.channels) channel = {0.05, 0, 1, 0};
  noise.channels[identify::kRadial].sigma = 0.5e-6;
  return noise;
}

}  // namespace plumbline::testing
