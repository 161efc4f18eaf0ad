// How long the control takes for a block.
#pragma once

#include <optional>

#include "nc/control/state/motion.hpp"
#include "nc/language/dialect.hpp"
#include "path/curve.hpp"

namespace plumbline::path {

/// Seconds that the control takes for a feed or arc move at its programmed feed, acceleration left out. Under G95 the
/// unit is revolutions of the spindle. Nothing for rapids (their speed is the control's), for moves without a feed,
/// for strokes that a cycle makes in its own way, and where the dialect's feed rule does not say. Under G93 the
/// dialect's least rate is kept, as the control does.
std::optional<double> duration(const nc::Motion& motion, const Curve& curve, const nc::Dialect& dialect);

}  // namespace plumbline::path
