// Arcs as they can be written: their centre as the control keeps it, and what a control takes beside and inside an arc.
#pragma once

#include <array>
#include <optional>

#include "base/axes.hpp"
#include "nc/control/state/arc_shape.hpp"
#include "nc/control/step.hpp"
#include "nc/language/dialect.hpp"
#include "nc/rewrite/output/emit_state.hpp"
#include "nc/rewrite/word_grid.hpp"

namespace plumbline::nc {

/// What the arcs of a block may be that are written in its place.
struct ArcForm {
  AxisSet beside;             // axes whose words may stand beside those of the plane
  double radii_apart_mm = 0;  // by which the radius may change from its start to its end, evenly with the angle
  double half_centre_mm = 0;  // that rounding may put on each word of the centre, or take off it
  double least_radius_mm = 0;
  bool may_close = false;  // a whole circle may end where it begins: its start is what words can say
};

/// The centre of an arc in words of the plane's axes.
struct ArcWords {
  Arc arc;                        // as the control keeps it, work system
  std::array<char, 2> letters{};  // of the first and second axis of the plane
  std::array<double, 2> value{};  // from the start, or under G90.1 in the work system; in the program's unit
  std::array<int, 2> digits{};    // decimals of each
};

/// Nothing where the arc of the block cannot be written as arcs: another control's words, or what they do there is not
/// known. `control`: where it stands before the block.
std::optional<ArcForm> arc_form(const Dialect& dialect, const WordGrid& words, const Step& step,
                                const OutputState& control);

/// The words of an arc that begins at `start` in the work system.
ArcWords arc_words(const WordGrid& words, const Step& step, const Arc& arc, const AxisWords& start);

}  // namespace plumbline::nc
