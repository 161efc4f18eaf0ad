#include "inspect/fine_noise.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace plumbline::inspect {

using Eigen::Index;

double FineNoise::with_memory() const { return kRemembers * std::accumulate(square.begin(), square.end(), 0.0); }

double FineNoise::expected(const Fault& mended) const {
  double sum = 0;
  for (std::size_t c = 0; c < square.size(); ++c) {
    const bool about = std::count(mended.channels.begin(), mended.channels.end(), static_cast<int>(c)) > 0;
    const bool unit = mended.kind == FaultKind::bar_unit || mended.kind == FaultKind::torque_unit;
    const double factor = about && unit ? mended.values.at(0) : 1;
    sum += std::max(std::abs(factor) > 1 ? 0 : rows[c], square[c] / (factor * factor));
  }
  return sum;
}

FineNoise noise_from_sample_to_sample(const std::vector<identify::RunEquations>& remainders,
                                      const identify::NoiseModel& noise) {
  FineNoise fine;
  for (const identify::RunEquations& run : remainders) {
    for (std::size_t c = 0; c < run.channels.size(); ++c) {
      const Eigen::VectorXd e = run.residual.segment(static_cast<Index>(c) * run.samples, run.samples);
      const auto channel = static_cast<std::size_t>(run.channels[c]);
      const double sigma = noise.channels[channel].sigma;
      fine.square[channel] += (e.tail(e.size() - 1) - e.head(e.size() - 1)).squaredNorm() / (2 * sigma * sigma);
      fine.rows[channel] += static_cast<double>(run.samples);
    }
  }
  return fine;
}

}  // namespace plumbline::inspect
