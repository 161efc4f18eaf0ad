// The pages of models beside measurements, and of what the bar shows alone.
#pragma once

#include <string>
#include <vector>

#include "jobs/circularity.hpp"
#include "jobs/compare.hpp"
#include "jobs/run_profiles.hpp"
#include "report/page/page.hpp"

namespace plumbline::report {

/// Of one model, or of two beside each other: `comparisons` are theirs, in the order of the models of `runs`.
Page compare_page(const std::vector<jobs::Comparison>& comparisons, const jobs::RunsAndModels& runs);

/// `runs` may have models beside them.
Page circularity_page(const jobs::CircularityTable& table, const jobs::RunsAndModels& runs);

}  // namespace plumbline::report
