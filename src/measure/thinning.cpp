#include "measure/thinning.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

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
  Thinning thinning{.runs = runs.size()};
  for (Run& run : runs) {
    thinning.longest = std::max(thinning.longest, run.samples());
    const std::size_t each = run.samples() / options.enough;
    if (each < 2) continue;
    ++thinning.thinned;
    thinning.largest = std::max(thinning.largest, each);
    follow(run.angle, each);
    for (auto* const column : {&run.time, &run.angle, &run.radial}) average(*column, each);
    for (auto& column : run.torque) average(column, each);
    wrap(run.angle);
  }
  return {std::move(runs), thinning};
}

}  // namespace plumbline::measure
