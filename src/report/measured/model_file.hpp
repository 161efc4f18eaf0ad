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

/// A model that was learnt, and its posterior, which lies beside it.
struct LearntFiles {
  std::string model, posterior;
};

/// The same with the posterior, which the model then names: `posterior_name`, seen from the model.
LearntFiles learnt_files(const jobs::IdentifiedModel& model, const std::string& posterior_name);
LearntFiles learnt_files(const jobs::DiagnoseResult& result, const std::string& posterior_name);

/// How the posterior of a model file is called: "m.posterior.toml" of "m.toml", in the same folder.
std::string posterior_path(const std::string& model_path);

}  // namespace plumbline::report
