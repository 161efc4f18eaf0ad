#include "truth/noise.hpp"

#include <cmath>

namespace truth {
namespace {

constexpr double kRedPart = 0.6;  // of sigma, of mixed noise

std::vector<double> autoregressive(std::size_t count, double sigma, double memory, Random& random) {
  std::normal_distribution<double> normal;
  std::vector<double> values(count);
  double now = sigma * normal(random);
  for (double& value : values) {
    value = now;
    now = memory * now + std::sqrt(1 - memory * memory) * sigma * normal(random);
  }
  return values;
}

}  // namespace

std::vector<double> noise(std::size_t count, double sigma, Colour colour, double memory, Random& random) {
  if (colour == Colour::white) return autoregressive(count, sigma, 0, random);
  if (colour == Colour::red) return autoregressive(count, sigma, memory, random);
  std::vector<double> values = autoregressive(count, kRedPart * sigma, memory, random);
  const std::vector<double> white = autoregressive(count, std::sqrt(1 - kRedPart * kRedPart) * sigma, 0, random);
  for (std::size_t i = 0; i < count; ++i) values[i] += white[i];
  return values;
}

double rounded(double value, double step) { return std::round(value / step) * step; }

}  // namespace truth
