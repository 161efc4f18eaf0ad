// The values of a fit without what might make the tip worse than the model as given does.
#pragma once

#include <string>

#include "diagnose/search/refit.hpp"
#include "identify/held.hpp"

namespace plumbline::diagnose {

/// Values of the candidates' unknowns: those of `fit`, the nuisances moved back where the tip would not surely be
/// nearer (identify::hold_unsure). What `picks` stand for keeps what was found. `given`: the model before anything was
/// added.
identify::Held held_values(const Workbench& bench, const physics::ForceModel& given, const std::vector<Pick>& picks,
                           const Refit& fit, const identify::HoldOptions& options = {});

/// What was held back, in words.
std::string shift_text(const identify::Held& held);

}  // namespace plumbline::diagnose
