// How two programs differ, for people and as JSON.
#pragma once

#include <string>

#include "jobs/diff/diff.hpp"

namespace plumbline::report {

std::string diff_text(const jobs::DiffSummary& summary);
/// `"plumbline": "diff 1"`
std::string diff_json(const jobs::DiffSummary& summary);

}  // namespace plumbline::report
