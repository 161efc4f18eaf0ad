// A program file compensated into another one.
#pragma once

#include <string>

#include "base/progress.hpp"
#include "compensate/summary.hpp"
#include "jobs/options.hpp"

namespace plumbline::jobs {

/// Compensates `program` into `output` ("-": standard input and output) as `options` say, which name the model.
/// Nothing is written unless all of it succeeds; `json`, if it is not empty, names a file for the summary. Refuses what
/// the readers, the interpreter and the compensation refuse.
compensate::Summary compensate_file(const std::string& program, const std::string& output, const Options& options,
                                    const Progress& progress = {}, const std::string& json = {});

}  // namespace plumbline::jobs
