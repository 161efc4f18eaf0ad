// Noise of measured channels.
#pragma once

#include <vector>

#include "truth/machine.hpp"

namespace truth {

enum class Colour {
  white,
  mixed,  // white, and a part that the next sample mostly keeps, as measured channels are
  red,    // each sample keeps a fixed part of the one before: AR(1)
};

/// `memory`: what the next sample keeps of the coloured part.
std::vector<double> noise(std::size_t count, double sigma, Colour colour, double memory, Random& random);

/// As an instrument writes it: in whole steps.
double rounded(double value, double step);

}  // namespace truth
