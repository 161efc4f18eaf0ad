// A program file compensated into another one.
#pragma once

#include <string>

#include "base/progress.hpp"
#include "compensate/summary.hpp"
#include "jobs/options.hpp"

namespace plumbline::jobs {

/// Compensates `program` into `output` ("-": standard input and output) as `options` say, which name the model.
/// Nothing is written unless all of it succeeds. Refuses what the readers, the interpreter and the compensation refuse.
compensate::Summary compensate_file(const std::string& program, const std::string& output, const Options& options,
                                    const Progress& progress = {});

/// Where --undo puts what the output replaced: beside it.
std::string undo_name(const std::string& output);

}  // namespace plumbline::jobs
