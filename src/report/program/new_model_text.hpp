// A new model in words: what is assumed, and whether it holds.
#pragma once

#include <string>

#include "jobs/new_model/new_model.hpp"

namespace plumbline::report {

/// What was read and left out, each assumption with its rule, and what the check found; lines.
std::string new_model_text(const jobs::NewModel& made);

}  // namespace plumbline::report
