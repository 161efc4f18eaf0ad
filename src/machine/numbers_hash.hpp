// A fingerprint of the numbers of a model: what a posterior belongs to.
#pragma once

#include <cstdint>

#include "machine/model.hpp"

namespace plumbline::machine {

/// A hash of the numbers that say how the machine is built and what acts on it. Comments, limits, the control and
/// what is known of the numbers ([uncertainty], [posterior]) leave it as it is.
std::uint64_t numbers_hash(const MachineModel& model);

}  // namespace plumbline::machine
