// Refuses what lies outside the machine's limits, by block, axis or strut, and by how much.
#pragma once

#include <string_view>
#include <vector>

#include "base/diagnostic.hpp"
#include "compensate/corrector.hpp"
#include "machine/limits.hpp"
#include "nc/step.hpp"

namespace plumbline::compensate {

/// The place of a block, the whole of it underlined.
Place place_of(const nc::Block& block, std::string_view file);

/// A violation as a diagnostic at a block; code limit-tilt, limit-travel, limit-strut or limit-condition.
Diagnostic diagnose(const machine::Violation& violation, const Place& place);

/// Throws the first violation, if there is any.
void refuse_violations(const std::vector<machine::Violation>& violations, const nc::Block& block,
                       std::string_view file);

}  // namespace plumbline::compensate
