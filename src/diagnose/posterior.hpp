// What is known of a machine once it was diagnosed: the posterior of the model that is handed back.
#pragma once

#include "diagnose/conclusion.hpp"
#include "identify/posterior/posterior.hpp"

namespace plumbline::diagnose {

/// The fit, and beside it every other effect of the confidence set that was fitted in the place of the strongest, each
/// as likely as its log odds say; wider where the priors are too narrow, and by what leaving out poses changes. What
/// comes again in the readings of the bar is what no number stands for.
identify::Posterior posterior_of(const Case& of, const Model& model, const Conclusion& conclusion,
                                 const VerdictOptions& options);

/// Of a model that stays as it was given: [uncertainty], and what comes again beside it.
identify::Posterior posterior_as_given(const machine::MachineModel& machine, const std::vector<measure::Run>& runs,
                                       const std::vector<identify::RunEquations>& given);

}  // namespace plumbline::diagnose
