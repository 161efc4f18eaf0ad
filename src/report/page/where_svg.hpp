// The pictures of where model and measurements disagree, and of what compensation would make of it.
#pragma once

#include <string>

#include "diagnose/diagnose.hpp"

namespace plumbline::report {

/// Channel by order of the wave around the circle, and channel by twelfth of the circle: colour by rms over the noise.
std::string circle_map(const diagnose::Diagnosis& diagnosis);

/// What pairs of runs have in common and where they differ, and groups of runs, as tables of rms over the noise.
std::string contrast_table(const diagnose::Diagnosis& diagnosis);
std::string group_table(const diagnose::Diagnosis& diagnosis);

/// Steps where struts turn around, with twice their standard error.
std::string reversal_bars(const diagnose::Diagnosis& diagnosis);

/// Circularity of each run: measured, compensated with the model as given, with what was found.
std::string circularity_bars(const diagnose::Diagnosis& diagnosis);

}  // namespace plumbline::report
