// The summary of a compensation, for people and for scripts.
#pragma once

#include <string>

#include "compensate/summary.hpp"
#include "settings/options.hpp"

namespace plumbline::report {

/// A line per figure, the names aligned, each number with its unit and the line of the program where it was.
std::string summary_text(const compensate::Summary& summary, const settings::Options& options);

/// One JSON object, `"plumbline": "compensation 1"`: every figure, its unit in its key; null for what there is not.
std::string summary_json(const compensate::Summary& summary, const settings::Options& options);
/// The same on one line, without its end.
std::string summary_json_line(const compensate::Summary& summary, const settings::Options& options);

}  // namespace plumbline::report
