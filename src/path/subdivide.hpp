// Into how many pieces a move is cut.
#pragma once

#include <functional>
#include <optional>

#include "base/diagnostic.hpp"
#include "path/curve.hpp"

namespace plumbline::path {

/// A piece ends where the first of these is reached.
struct StepSettings {
  double angle_deg = 0.1;             // of arc, or of the turn of the tool [Ibaraki et al., 4: every 0.1 deg]
  double length_mm = 1.0;             // of path
  double least_time_s = 0.0;          // a piece is never shorter: the control's time for a block
  double least_inverse_time_s = 0.0;  // nor under G93: of the largest F
};

struct Subdivision {
  int pieces = 1;
  bool widened = false;  // least_time_s asked for longer pieces than the steps
};

/// Pieces of equal length for a move that takes `seconds` (nothing: not known, no least time). A rapid is never cut:
/// do not ask. Refuses with path-too-many-pieces, and the place of the move, where one would take more than 200,000:
/// only then is the place asked for.
Subdivision subdivide(const Curve& curve, std::optional<double> seconds, const StepSettings& settings,
                      const std::function<Place()>& place = {});

}  // namespace plumbline::path
