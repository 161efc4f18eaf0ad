#include "diagnose/residual_model/told.hpp"

#include <algorithm>
#include <cmath>

#include "physics/effects/residual.hpp"

namespace plumbline::diagnose {
namespace {

using physics::Residual;

// Points of a region along each coordinate.
int points_along(std::size_t dimensions) { return dimensions == 1 ? 41 : dimensions == 2 ? 9 : 7; }

struct Ends {
  std::vector<double> lower, upper;
};
Ends ends_of(const Region& region, int part) {
  if (part >= 0) return {region.lower[static_cast<std::size_t>(part)], region.upper[static_cast<std::size_t>(part)]};
  Ends ends;
  for (std::size_t d = 0; d < region.middle.size(); ++d) {
    ends.lower.push_back(region.middle[d] - region.half_width[d]);
    ends.upper.push_back(region.middle[d] + region.half_width[d]);
  }
  return ends;
}

// Whether a constant of it does what an offset of a strut or a shift of the ball does: circles tell neither.
bool may_be_an_offset(const Shape& shape) {
  const bool alone =
      shape.strut_powers == decltype(shape.strut_powers){} && shape.shared_powers == decltype(shape.shared_powers){};
  return alone && (shape.channel == Term::Channel::length || shape.channel == Term::Channel::tip);
}

LearntFunction smooth(const Component& of, std::size_t k, const Eigen::MatrixXd& covariance) {
  LearntFunction told{of.shape, of.parts[k], may_be_an_offset(of.shape), {}, {}, {}, {}, {}, of.log_odds, of.left_out};
  const std::size_t dimensions = of.shape.coordinates.size();
  const Eigen::Index count = of.shape.functions();
  const Eigen::Index first = static_cast<Eigen::Index>(k) * count;
  const Ends ends = ends_of(of.region, told.part);
  const int points = points_along(dimensions);
  int all = 1;
  for (std::size_t d = 0; d < dimensions; ++d) all *= points;
  std::vector<FunctionValue> values(static_cast<std::size_t>(all));
  Eigen::MatrixXd functions(all, count);
  for (int i = 0; i < all; ++i) {
    FunctionValue& here = values[static_cast<std::size_t>(i)];
    int rest = i;
    for (std::size_t d = 0; d < dimensions; ++d, rest /= points)
      here.at.push_back(ends.lower[d] + (ends.upper[d] - ends.lower[d]) * (rest % points) / (points - 1));
    functions.row(i) = functions_at(of.shape, of.region, here.at);
  }
  if (told.mean_aside) functions.rowwise() -= functions.colwise().mean().eval();
  const Eigen::MatrixXd own = covariance.block(first, first, count, count);
  for (int i = 0; i < all; ++i) {
    FunctionValue& here = values[static_cast<std::size_t>(i)];
    here.value = functions.row(i).dot(of.weights.segment(first, count));
    here.sigma = std::sqrt(std::max(functions.row(i).dot(own * functions.row(i).transpose()), 0.0));
    if (i == 0 || here.value < told.least.value) told.least = here;
    if (i == 0 || here.value > told.most.value) told.most = here;
  }
  if (dimensions == 1) told.along = std::move(values);
  return told;
}

LearntFunction formula(const Component& of) {
  LearntFunction told{of.shape,   of.parts.size() == 1 ? of.parts[0] : -1, false, {}, {}, {}, {}, {}, of.log_odds,
                      of.left_out};
  const Eigen::Index count = of.shape.functions();
  for (std::size_t k = 0; k < of.parts.size(); ++k) {
    const auto first = static_cast<Eigen::Index>(k) * count;
    Term term{of.shape.channel, of.parts[k], of.shape.strut_powers, of.shape.shared_powers, of.shape.pitch};
    term.cosine = of.weights[first];
    if (of.shape.is_wave()) term.sine = of.weights[first + 1];
    told.formula.push_back(term);
  }
  return told;
}

}  // namespace

std::vector<LearntFunction> functions_of(const LearntResidual& learnt, const physics::MachineConstants& machine) {
  std::vector<LearntFunction> all;
  Eigen::Index first = 0;
  for (const Component& component : learnt.components) {
    const Eigen::Index size = component.weights.size();
    const Eigen::MatrixXd covariance = learnt.of_weights.block(first, first, size, size);
    first += size;
    if (!component.shape.is_smooth()) {
      all.push_back(formula(component));
      continue;
    }
    for (std::size_t k = 0; k < component.parts.size(); ++k) all.push_back(smooth(component, k, covariance));
    all.back().law = power_law_of(component, covariance, machine);
  }
  return all;
}

}  // namespace plumbline::diagnose
