// What data can tell of the unknowns and what they cannot.
#pragma once

#include <optional>
#include <vector>

#include "identify/fit.hpp"
#include "identify/unknowns/geometry.hpp"

namespace plumbline::identify {

struct ObservabilityOptions {
  double apart = 0.95;       // correlation from which two unknowns count as not separated
  double little = 0.9;       // share of the prior's sigma that is left from which data count as telling little
  double one_height = 0.01;  // m, within which circles count as lying at one height
  double better = 0.5;       // share of the prior's sigma below which data tell more of a direction than was known
};

/// Two unknowns that the data do not tell apart, and what they tell instead: weight x first + second.
struct Confusion {
  std::size_t first = 0;
  std::size_t second = 0;
  double correlation = 0;  // as the data alone have it, the others within their priors
  double weight = 0;       // SI of the second per SI of the first
  double value = 0;        // of the combination, SI of the second
  double standard_error = 0;
};

/// Where the readings were taken.
enum class MeasuredAt { poses, circles_at_one_height, circles };

struct Observability {
  Eigen::VectorXd singular_values;  // of the data's slopes, whitened and in scales, the largest first: below one, data
                                    // tell less of that direction than the scale (a prior's sigma) says already
  std::vector<Confusion> confusions;  // the strongest first; joints and offsets are left out: they are many, and all
                                      // alike
  std::vector<std::size_t> little;    // unknowns of which the data tell little beyond the prior
  std::vector<std::size_t> nothing;   // free unknowns of which they tell nothing
  MeasuredAt measured_at = MeasuredAt::poses;
};

Observability observability(const Fit& fit, const std::vector<measure::Run>& runs,
                            const ObservabilityOptions& options = {});

/// What data show of the geometry, of the coordinates of joints and the offsets of struts that have a prior.
struct ShownGeometry {
  std::size_t directions = 0;       // how many there are
  std::size_t better = 0;           // of which the data tell more than was known
  std::vector<WholeMotion> hidden;  // motions of the geometry as a whole of which they tell little beyond the priors
};

/// Nothing if the geometry is not among the unknowns.
std::optional<ShownGeometry> shown_geometry(const machine::Geometry& geometry, const Unknowns& unknowns,
                                            const Eigen::MatrixXd& covariance,
                                            const ObservabilityOptions& options = {});

}  // namespace plumbline::identify
