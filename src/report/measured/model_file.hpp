// The model file that a command leaves: the text that was given, with what was learnt, and notes of where it comes
// from.
#pragma once

#include <string>

#include "jobs/diagnose.hpp"
#include "jobs/identify.hpp"

namespace plumbline::report {

/// After `identify` or `calibrate`: each number before and after with its standard error, what the data cannot tell.
std::string model_file(const jobs::IdentifiedModel& model);

/// After `diagnose`: the verdict, and what could not be told apart.
std::string model_file(const jobs::DiagnoseResult& result);

}  // namespace plumbline::report
