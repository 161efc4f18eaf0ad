#include "diagnose/residual_model/part.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "physics/effects/residual.hpp"

namespace plumbline::diagnose {
namespace {

using identify::SlopeRows;
using physics::kSharedFactors;
using physics::kStrutFactors;
using physics::Residual;
using Channel = Term::Channel;
using namespace coordinates;

constexpr int kOfOne = 16;           // numbers of a function of one coordinate
constexpr double kLeastHalf = 1e-3;  // of a region, in the units of coordinates: narrower ones say nothing

double coordinate_of(int coordinate, const SampleState& state, const physics::MachineConstants& machine, int part) {
  if (coordinate <= kSharedFactors) return shared_factors(state)[static_cast<std::size_t>(coordinate - 1)];
  return strut_factors(machine, state, part)[static_cast<std::size_t>(coordinate - 1 - kSharedFactors)];
}

std::size_t dimensions_of(const Shape& shape) { return shape.coordinates.size(); }

Shape of(Channel channel, std::vector<int> coordinates, const std::vector<int>& powers = {}) {
  Shape shape{channel, {}, {}, std::move(coordinates)};
  for (const int p : powers) {
    if (p <= kSharedFactors) {
      ++shape.shared_powers.at(static_cast<std::size_t>(p - 1));
    } else {
      ++shape.strut_powers.at(static_cast<std::size_t>(p - 1 - kSharedFactors));
    }
  }
  return shape;
}

}  // namespace

int Shape::functions() const {
  if (is_wave()) return 2;
  if (!is_smooth()) return 1;
  return coordinates.size() == 1 ? kOfOne : Residual::kFunctions;
}

Region region_of(const Shape& shape, const std::vector<ReadyRun>& runs, const physics::MachineConstants& machine) {
  Region region;
  const auto parts = static_cast<std::size_t>(shape.parts());
  region.lower.assign(parts, std::vector<double>(dimensions_of(shape), std::numeric_limits<double>::infinity()));
  region.upper.assign(parts, std::vector<double>(dimensions_of(shape), -std::numeric_limits<double>::infinity()));
  for (std::size_t d = 0; d < dimensions_of(shape); ++d) {
    double least = std::numeric_limits<double>::infinity();
    double most = -least;
    for (std::size_t part = 0; part < parts; ++part) {
      double& lower = region.lower[part][d];
      double& upper = region.upper[part][d];
      for (const ReadyRun& run : runs) {
        for (const SampleState& state : run.states) {
          const double x = coordinate_of(shape.coordinates[d], state, machine, static_cast<int>(part));
          lower = std::min(lower, x);
          upper = std::max(upper, x);
        }
      }
      least = std::min(least, lower);
      most = std::max(most, upper);
    }
    region.middle.push_back((least + most) / 2);
    region.half_width.push_back(std::max((most - least) / 2, kLeastHalf));
  }
  return region;
}

Eigen::VectorXd prior_widths(const Shape& shape, double length_scale) {
  Eigen::VectorXd widths = Eigen::VectorXd::Ones(shape.functions());
  if (!shape.is_smooth()) return widths;
  const Residual::Orders order = Residual::orders(static_cast<int>(dimensions_of(shape)));
  const double step = std::numbers::pi / (2 * Residual::kMargin) * length_scale;  // of omega l
  double in_the_middle = 0;                                                       // variance there
  for (Eigen::Index k = 0; k < widths.size(); ++k) {
    double squares = 0;
    bool odd = true;
    for (std::size_t d = 0; d < dimensions_of(shape); ++d) {
      const int n = order.at(static_cast<std::size_t>(k)).at(d);
      squares += n * n;
      odd = odd && n % 2 == 1;
    }
    widths[k] = std::exp(-squares * step * step / 4);
    if (odd) in_the_middle += widths[k] * widths[k];
  }
  return widths / std::sqrt(in_the_middle);
}

Eigen::RowVectorXd functions_at(const Shape& shape, const Region& region, const std::vector<double>& at) {
  Eigen::RowVectorXd values = Eigen::RowVectorXd::Ones(shape.functions());
  const std::size_t dimensions = dimensions_of(shape);
  const Residual::Orders order = Residual::orders(static_cast<int>(dimensions));
  for (std::size_t d = 0; d < dimensions; ++d) {
    const auto sines = Residual::sines<double>(at[d], region.middle[d], region.half_width[d],
                                               Residual::highest_of(static_cast<int>(dimensions)));
    for (Eigen::Index k = 0; k < values.size(); ++k)
      values[k] *= sines.at(static_cast<std::size_t>(order.at(static_cast<std::size_t>(k)).at(d) - 1));
  }
  return values;
}

namespace {

// At a sample, for one part.
Eigen::RowVectorXd functions_of(const Shape& shape, const Region& region, const SampleState& state,
                                const physics::MachineConstants& machine, int part) {
  if (shape.is_wave()) {
    const double turn = 2 * std::numbers::pi * state.struts.length[part] / shape.pitch;
    return Eigen::RowVector2d(std::cos(turn), -std::sin(turn));
  }
  if (!shape.is_smooth()) return Eigen::RowVectorXd::Ones(1);
  std::vector<double> at;
  for (const int coordinate : shape.coordinates) at.push_back(coordinate_of(coordinate, state, machine, part));
  return functions_at(shape, region, at);
}

}  // namespace

std::vector<SlopeRows> values_of(const Shape& shape, const Region& region, const ReadyRun& run,
                                 const physics::MachineConstants& machine) {
  std::vector<SlopeRows> values(static_cast<std::size_t>(shape.parts()),
                                SlopeRows(run.raw->samples, shape.functions()));
  for (int part = 0; part < shape.parts(); ++part) {
    for (Eigen::Index s = 0; s < run.raw->samples; ++s) {
      const SampleState& state = run.states[static_cast<std::size_t>(s)];
      double factor = product(shared_factors(state), shape.shared_powers);
      if (is_per_strut(shape.channel)) factor *= product(strut_factors(machine, state, part), shape.strut_powers);
      values[static_cast<std::size_t>(part)].row(s) = factor * functions_of(shape, region, state, machine, part);
    }
  }
  return values;
}

SlopeRows columns_of(const Shape& shape, const Region& region, const ReadyRun& run,
                     const physics::MachineConstants& machine) {
  const Eigen::Index n = run.raw->samples;
  const Eigen::Index count = shape.functions();
  const Eigen::MatrixXd slopes = slopes_of(run, shape.channel);
  const std::vector<SlopeRows> values = values_of(shape, region, run, machine);
  SlopeRows columns(run.raw->residual.size(), count * shape.parts());
  for (int part = 0; part < shape.parts(); ++part) {
    for (std::size_t c = 0; c < run.raw->channels.size(); ++c) {
      const Eigen::Index first = static_cast<Eigen::Index>(c) * n;
      columns.block(first, part * count, n, count) =
          slopes.col(part).segment(first, n).asDiagonal() * values[static_cast<std::size_t>(part)];
    }
  }
  return columns;
}

const std::vector<Shape>& smooth_shapes() {
  static const std::vector<Shape> all{of(Channel::length, {kLength}),
                                      of(Channel::length, {kTension}),
                                      of(Channel::length, {kLength}, {kTension}),
                                      of(Channel::length, {kLength}, {kSign}),
                                      of(Channel::length, {kTension}, {kSign}),
                                      of(Channel::length, {kUz}),
                                      of(Channel::length, {kUz}, {kTension}),
                                      of(Channel::length, {kSpeed}),
                                      of(Channel::length, {kLength, kTension}),
                                      of(Channel::drive, {kLength}),
                                      of(Channel::drive, {kTension}),
                                      of(Channel::drive, {kSpeed}),
                                      of(Channel::drive, {kLength}, {kSign}),
                                      of(Channel::drive, {kUz}, {kSign}),
                                      of(Channel::drive, {kTension}, {kSign}),
                                      of(Channel::torque, {kLength}),
                                      of(Channel::torque, {kTension}),
                                      of(Channel::torque, {kLength}, {kSign}),
                                      of(Channel::force, {kX, kY, kZ}),
                                      of(Channel::centre, {kX, kY, kZ}),
                                      of(Channel::tip, {kX, kY, kZ}),
                                      of(Channel::tip, {kAx, kAy})};
  return all;
}

}  // namespace plumbline::diagnose
