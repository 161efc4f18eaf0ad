// Which datasets something was learnt from, for people and as JSON.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "jobs/measured/measured_file.hpp"

namespace plumbline::report {

/// Which runs are called otherwise than in their dataset, a line for each dataset that has such; empty: none has.
std::string renamed_text(const std::vector<jobs::MeasuredFile>& measured);

/// File, hash, how many runs, and those with another name.
nlohmann::ordered_json datasets_json(const std::vector<jobs::MeasuredFile>& measured);

}  // namespace plumbline::report
