// What the channels of all runs show without a fit: a bar in a larger unit, torques without their signs.
#include <algorithm>
#include <array>
#include <cmath>

#include "inspect/channel_rows.hpp"
#include "inspect/hypothesis.hpp"

namespace plumbline::inspect {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using identify::kChannels;
using identify::kRadial;

// Readings of a bar come in steps of 0.1 um at best [Renishaw, QC20-W: resolution]; noise below that is of another
// unit:
constexpr double kFinestBar = 0.02e-6;                               // m, 1 sigma from sample to sample
constexpr std::array kLargerUnits{1e-3, 1 / 25.4, 1 / 25.4 * 1e-3};  // mm, thousandths of an inch, inches

constexpr double kAbout = 1.5;  // the factor within which readings are such a part of what is predicted
// of the misfit in um, that a larger unit may leave, where no effect may make up for it
constexpr double kLargerLeaves = 0.3;

// Torques without their signs: of what the model predicts
constexpr double kSure = 3;            // times the noise, from which a sign is sure
constexpr double kOfEachSign = 0.005;  // of all samples, at least,
constexpr Index kLeastOfEach = 20;     // and so many
constexpr double kSizesLeave = 0.2;    // of the squares that negative ones leave, that their sizes may leave

// The unit of which readings of the bar are about the part of what is predicted.
std::optional<double> larger_unit(const Channels& channels) {
  const double factor = channels.factor({kRadial});
  for (const double unit : kLargerUnits) {
    if (factor * kAbout >= unit && factor <= kAbout * unit) return unit;
  }
  return std::nullopt;
}

Fault bar_in(const Suspects& suspects, std::vector<double> values) {
  Fault fault{FaultKind::bar_unit, suspects.runs};
  fault.channels = {kRadial};
  fault.values = std::move(values);
  return fault;
}

}  // namespace

std::optional<Fault> finer_than_any_bar(const Suspects& suspects) {
  const Channels channels(suspects);
  if (!channels.has(kRadial)) return std::nullopt;
  double squares = 0;
  Index count = 0;
  for (const RunRows* run : suspects.rows) {
    if (!run->raw.first_row(kRadial)) continue;
    const VectorXd readings = segment(run->measured, *run, kRadial);
    squares += (readings.tail(readings.size() - 1) - readings.head(readings.size() - 1)).squaredNorm() / 2;
    count += readings.size() - 1;
  }
  const double noise = std::sqrt(squares / static_cast<double>(std::max<Index>(1, count)));
  const std::optional<double> unit = larger_unit(channels);
  if (!unit || noise >= kFinestBar) return std::nullopt;
  return bar_in(suspects, {*unit, noise});
}

std::optional<Fault> has_no_signs(const Suspects& suspects) {
  Index samples = 0;
  Index above = 0;
  Index below = 0;  // where a negative one is predicted
  double products = 0;
  double squares = 0;
  double read_below = 0;
  double products_below = 0;
  double squares_below = 0;
  for (const RunRows* run : suspects.rows) {
    for (int motor = 1; motor < kChannels; ++motor) {
      if (!run->raw.first_row(motor)) continue;
      const VectorXd read = segment(run->measured, *run, motor);
      if (read.minCoeff() < 0) return std::nullopt;
      const VectorXd model = read - segment(run->raw.residual, *run, motor);
      const double sure = kSure * suspects.bench.noise.channels[static_cast<std::size_t>(motor)].sigma;
      const VectorXd negative = (model.array() < -sure).select(model, 0);
      samples += model.size();
      above += (model.array() > sure).count();
      below += (negative.array() < 0).count();
      products += read.dot(model.cwiseAbs());
      squares += model.squaredNorm();
      read_below += (negative.array() < 0).select(read, 0).squaredNorm();
      products_below += read.dot(negative);
      squares_below += negative.squaredNorm();
    }
  }
  const auto least = std::max(kLeastOfEach, static_cast<Index>(kOfEachSign * static_cast<double>(samples)));
  if (std::min(above, below) < least) return std::nullopt;
  const double factor = products / squares;
  const auto left_by = [&](double by) { return read_below - 2 * by * products_below + by * by * squares_below; };
  if (left_by(-factor) > kSizesLeave * left_by(factor)) return std::nullopt;
  Fault fault{FaultKind::motors_unsigned, suspects.runs};
  fault.channels = {1, 2, 3, 4, 5, 6};
  return fault;
}

std::optional<Fault> fits_in_larger_unit(const Suspects& suspects) {
  const Channels channels(suspects);
  if (!channels.has(kRadial)) return std::nullopt;
  const std::optional<double> unit = larger_unit(channels);
  if (!unit) return std::nullopt;
  const VectorXd readings =
      channels.whitened([&](std::size_t, const RunRows& run) { return scaled(run, {kRadial}, 1 / *unit); });
  const double left = *unit * *unit * channels.chi2_of(readings, {kRadial});
  if (left > kLargerLeaves * channels.chi2_of(channels.measured(), {kRadial})) return std::nullopt;
  return bar_in(suspects, {*unit});
}

}  // namespace plumbline::inspect
