// What measurements cannot tell, a sentence each without its full stop.
#pragma once

#include <string>
#include <vector>

#include "identify/identify.hpp"

namespace plumbline::report {

/// What data cannot tell of the unknowns of a fit.
std::vector<std::string> observability_text(const identify::Fit& fit, const identify::Observability& known);

/// How much of the geometry they show, and which motions of it as a whole they do not.
std::vector<std::string> shown_geometry_text(const identify::ShownGeometry& shown);

/// All of a stage: with what was held back of the tip's shift, and what is to be thought of priors that are refuted.
std::vector<std::string> observability_text(const identify::Stage& stage);

/// "a shift of the base joints along X"
std::string motion_text(const identify::WholeMotion& motion);

}  // namespace plumbline::report
