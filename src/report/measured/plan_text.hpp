// A plan of circular tests, for people and as JSON.
#pragma once

#include <string>
#include <vector>

#include "jobs/plan.hpp"

namespace plumbline::report {

/// For people: the runs, what is known before and after, what stays unseen.
std::string plan_text(const jobs::PlannedTests& plan);
/// Where the tip is to be certain: the box, its tilts, and how many of the poses are in reach.
std::string box_text(const jobs::PlannedTip& tip);
/// What the plan does not tell, a sentence each.
std::vector<std::string> unseen_text(const jobs::PlannedTests& plan);
/// As docs/formats.md says.
std::string plan_json(const jobs::PlannedTests& plan);

}  // namespace plumbline::report
