// What no single key of a model file can say: whether the machine makes sense as a whole.
#pragma once

#include "machine/model.hpp"

namespace plumbline::machine {

/// Refuses with model-gravity, model-unit, model-coincident-joints, model-limit-order, model-length-order or
/// model-singular-home, at the value that is most likely wrong.
void check_model(const MachineModel& model);

}  // namespace plumbline::machine
