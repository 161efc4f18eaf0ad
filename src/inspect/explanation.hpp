// Of what was tried, what is large enough to be a mistake, and what explains how far runs are off.
#pragma once

#include <optional>
#include <vector>

#include "inspect/hypothesis.hpp"
#include "inspect/inspect.hpp"

namespace plumbline::inspect {

/// Drops what is smaller than people get wrong, of a run or of runs that are alike.
void leave_large_ones(std::vector<Tried>& all, const measure::Run& run, const InspectOptions& options);

/// Of everything that was tried the best, if it explains what is off: `before` is chi-square of `rows` readings as they
/// are stated, `usual` the mean square of runs nothing is wrong with.
std::optional<Fault> explanation(std::vector<Tried> all, const measure::Run& run, double before, Eigen::Index rows,
                                 double usual, const InspectOptions& options);

}  // namespace plumbline::inspect
