// What data can tell of the unknowns and what they cannot, in numbers and in words.
#pragma once

#include <string>
#include <vector>

#include "identify/fit.hpp"

namespace plumbline::identify {

struct ObservabilityOptions {
  double apart = 0.95;       // correlation from which two unknowns count as not told apart
  double little = 0.9;       // share of the prior's sigma that is left from which data count as telling little
  double one_height = 0.01;  // m, within which circles count as lying at one height
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

struct Observability {
  Eigen::VectorXd singular_values;  // of the data's slopes, whitened and in scales, the largest first: below one, data
                                    // tell less of that direction than the scale (a prior's sigma) says already
  std::vector<Confusion> confusions;    // the strongest first; joints and offsets are left out: they are many, and all
                                        // alike
  std::vector<std::size_t> little;      // unknowns of which the data tell little beyond the prior
  std::vector<std::size_t> nothing;     // free unknowns of which they tell nothing
  std::vector<std::string> statements;  // all of this in words
};

Observability observability(const Fit& fit, const std::vector<measure::Run>& runs,
                            const ObservabilityOptions& options = {});

}  // namespace plumbline::identify
