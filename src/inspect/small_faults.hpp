// Faults so small that what the model lacks may look like them.
#pragma once

#include "inspect/fault.hpp"
#include "inspect/inspect.hpp"

namespace plumbline::inspect {

/// Several runs are a little off, each as if the same setting were wrong, or runs about which nothing is said are off
/// by as much: what the model lacks is likelier than mistakes, which is told and blocks nothing. A setting of one run
/// alone must be sure; else it is left out.
void doubt_small_faults(Inspection& found, const InspectOptions& options);

}  // namespace plumbline::inspect
