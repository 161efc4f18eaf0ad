#include "measure/thinning.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace plumbline::measure {
namespace {

constexpr double kWholeTurn = 2 * std::numbers::pi;

void average(std::vector<double>& column, std::size_t each) {
  std::size_t kept = 0;
  for (std::size_t first = 0; first < column.size(); first += each) {
    const std::size_t end = std::min(first + each, column.size());
    double sum = 0;
    for (std::size_t i = first; i < end; ++i) sum += column[i];
    column[kept++] = sum / static_cast<double>(end - first);
  }
  column.resize(kept);
  column.shrink_to_fit();
}

// Angles start again after a turn: they are followed from the first of each mean.
void follow(std::vector<double>& angle, std::size_t each) {
  for (std::size_t i = 0; i < angle.size(); ++i) {
    const double first = angle[i - i % each];
    angle[i] = first + std::remainder(angle[i] - first, kWholeTurn);
  }
}

// From 0 up to a turn.
void wrap(std::vector<double>& angle) {
  for (double& a : angle) a -= kWholeTurn * std::floor(a / kWholeTurn);
}

}  // namespace

Thinned thinned(std::vector<Run> runs, const ThinningOptions& options) {
  Thinned result;
  for (Run& run : runs) {
    result.longest = std::max(result.longest, run.samples());
    const std::size_t each = run.samples() / options.enough;
    if (each < 2) continue;
    ++result.thinned;
    result.largest = std::max(result.largest, each);
    follow(run.angle, each);
    for (auto* const column : {&run.time, &run.angle, &run.radial}) average(*column, each);
    for (auto& column : run.torque) average(column, each);
    wrap(run.angle);
  }
  result.runs = std::move(runs);
  return result;
}

std::string Thinned::text() const {
  if (thinned == 0) return {};
  return fmt::format(
      "{} of {} runs have up to {} samples: means of up to {} consecutive ones were used, and the noise stated is that "
      "of "
      "these means",
      thinned, runs.size(), longest, largest);
}

}  // namespace plumbline::measure
