// The summary of a compensation, for people and for scripts.
#pragma once

#include <optional>
#include <string>

#include "compensate/summary.hpp"
#include "jobs/expected/expected_error.hpp"
#include "settings/options.hpp"

namespace plumbline::report {

/// A line per figure, the names aligned, each number with its unit and the line of the program where it was.
/// `expected`: what is expected to be left at the tip.
std::string summary_text(const compensate::Summary& summary, const settings::Options& options,
                         const std::optional<jobs::ExpectedError>& expected = std::nullopt);

/// One JSON object, `"plumbline": "compensation 1"`: every figure, its unit in its key; null for what there is not.
std::string summary_json(const compensate::Summary& summary, const settings::Options& options,
                         const std::optional<jobs::ExpectedError>& expected = std::nullopt);
/// The same on one line, without its end.
std::string summary_json_line(const compensate::Summary& summary, const settings::Options& options,
                              const std::optional<jobs::ExpectedError>& expected = std::nullopt);

}  // namespace plumbline::report
