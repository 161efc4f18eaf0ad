// Runs with a payload, judged by those without: all of them may have the same wrong mass, and then agree with each
// other.
#pragma once

#include <optional>

#include "inspect/inspect.hpp"
#include "inspect/looked.hpp"

namespace plumbline::inspect {

/// The payloads of all runs that had one were misstated by one factor; `values` of the fault: the mass of the first.
/// Nothing: there are no two such runs, none without, or they are as the others predict them. `wide`: the prior before
/// any spread is fitted.
std::optional<Fault> payload_of_loaded_runs(const Looked& looked, const Bench& bench, const Prior& wide,
                                            const Outliers& outliers, const InspectOptions& options);

}  // namespace plumbline::inspect
