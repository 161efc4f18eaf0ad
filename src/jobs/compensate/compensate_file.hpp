// A program file compensated into another one.
#pragma once

#include <functional>
#include <string>

#include "base/progress.hpp"
#include "compensate/summary.hpp"
#include "settings/options.hpp"

namespace plumbline::jobs {

/// A file for the summary, which appears together with the program.
struct SummaryFile {
  std::string path;  // empty: none is wanted
  std::function<std::string(const compensate::Summary&)> text{};
};

/// Compensates `program` into `output` ("-": standard input and output) as `options` say, which name the model.
/// Nothing is written unless all of it succeeds. Refuses what the readers, the interpreter and the compensation refuse.
compensate::Summary compensate_file(const std::string& program, const std::string& output,
                                    const settings::Options& options, const Progress& progress = {},
                                    const SummaryFile& summary_file = {});

}  // namespace plumbline::jobs
