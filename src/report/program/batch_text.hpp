// What became of the programs of a folder, for people and for scripts.
#pragma once

#include <string>

#include "jobs/batch_item.hpp"

namespace plumbline::report {

/// The line above those of the programs.
std::string batch_heading();
/// The line of a program: its figures, or that it is refused.
std::string batch_line(const jobs::BatchItem& item);
/// How many became what, in how long.
std::string batch_total(const jobs::BatchSummary& summary);

/// One JSON object on a line, `"plumbline": "batch 1"`: the program, what became of it, its summary, its diagnostics.
std::string batch_json_line(const jobs::BatchItem& item);
/// The last line, `"plumbline": "batch total 1"`.
std::string batch_json_total(const jobs::BatchSummary& summary);

}  // namespace plumbline::report
