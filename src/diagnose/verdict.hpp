// From the numbers of a search to names: what is named, what cannot be told apart, what is not ruled out.
#pragma once

#include "diagnose/diagnose.hpp"

namespace plumbline::diagnose {

/// Effects whose signatures agree with that of the effect at `place` to |cos| > 0.9999, nuisances and the other effects
/// taken out: computed from the design. Both signs count where bounds allow them.
std::vector<std::string> alternatives_of(const Workbench& bench, const Model& model, std::size_t place,
                                         const VerdictOptions& options);

/// |cos| between the signatures of the effects at two places, nuisances taken out: near one where each takes away
/// much of what the other adds, so that the two together can shape what neither of them is.
double resemblance(const Workbench& bench, const Model& model, std::size_t one, std::size_t other);

/// Every effect that the data do not rule out as the strongest one.
std::vector<std::string> confidence_set_of(const Model& model, const std::vector<NamedEffect>& effects,
                                           const VerdictOptions& options);

/// The numbers of an effect as the fit has them.
std::vector<NamedParameter> parameters_of(const Workbench& bench, const Pick& pick, const Refit& fit);

}  // namespace plumbline::diagnose
