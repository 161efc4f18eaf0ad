// G2 and G3: circles and helices by their centre (I J K) or their radius (R).
#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "base/units.hpp"
#include "nc/control/execution.hpp"
#include "nc/control/state/arc_shape.hpp"
#include "nc/language/codes.hpp"

namespace plumbline::nc {
namespace {

// An arc that ends off its circle: where the control goes there, or at which difference it stops, is a matter of its
// settings. Words of three decimals put both radii some thousandths apart.
constexpr double kUnknownSpiralMm = 0.01;

constexpr double kHalfCircle = 1e-12;  // of the chord over the diameter, from 1
constexpr double kWholeTurns = 1e-3;

// Start, end and centre in the plane: first and second axis.
struct PlaneArc {
  std::array<double, 2> start{}, end{}, centre{};
};

char centre_letter(Axis axis) { return kCentreLetters[index(axis)]; }

void check_words(const Execution& run, const PlaneAxes& axes) {
  const bool by_radius = run.words.has('R');
  const bool by_centre = run.words.has('I') || run.words.has('J') || run.words.has('K');
  if (by_radius == by_centre) {
    run.refuse(run.motion_code(), codes::kArcWords,
               by_radius ? "the arc has both a radius and a centre, and what controls make of that differs"
                         : "the arc has neither a centre nor a radius",
               fmt::format("give either {} or the centre (two of I, J, K)",
                           run.dialect.syntax.word_modes ? "the radius (CR=)" : "R"));
  }
  if (const Word* word = run.words.find(centre_letter(axes.third))) {
    run.refuse(*word, codes::kArcWords, fmt::format("{} is no centre word of the plane in force", word->letter),
               "G17 takes I and J, G18 I and K, G19 J and K");
  }
  for (const Axis axis : {axes.first, axes.second}) {
    if (!by_centre || !run.control.modal.arc_centre_absolute || run.words.has(centre_letter(axis))) continue;
    run.refuse(run.motion_code(), codes::kArcWords,
               fmt::format("an absolute centre (G90.1) needs {}", centre_letter(axis)), "add the word");
  }
  const bool ends = run.axes.contains(axes.first) || run.axes.contains(axes.second);
  if (by_radius && !ends) {
    run.refuse(run.motion_code(), codes::kArcEnds, "an arc by its radius needs an end point in its plane",
               fmt::format("add {} or {}, or give the centre", letter(axes.first), letter(axes.second)));
  }
}

// Half the chord d, radius R, height h over the chord: h^2 = R^2 - d^2. The centre lies left of the chord for a
// counter-clockwise arc of at most half a turn, right for a clockwise one; R < 0 asks for the longer way.
void centre_by_radius(const Execution& run, PlaneArc& arc, bool clockwise) {
  const Word& word = *run.words.find('R');
  const double radius = run.length(word);
  if (radius < 0 && run.dialect.behaviour.radius_positive) {
    run.refuse(word, codes::kNotInterpreted, "which arc a radius below 0 asks for was found in no source",
               "give the centre (I, J, K)");
  }
  const double half = distance(arc.start, arc.end) / 2;
  if (half == 0) {
    run.refuse(word, codes::kArcEnds, "an arc by its radius cannot end where it begins",
               "write a full circle with its centre (I, J, K)");
  }
  double size = std::abs(radius);
  if (half - size > least_radius(run.control.modal.inches)) {
    run.refuse(word, codes::kArcRadius, "the radius is too small to reach the end point",
               fmt::format("half the distance is {:.6f}", half / run.control.length_unit()));
  }
  if (half / size > 1 - kHalfCircle) size = half;
  const double height = std::sqrt(std::max(0.0, size * size - half * half));
  const double side = (radius > 0) == clockwise ? -1 : 1;  // left of the chord is +
  const double x = (arc.end[0] - arc.start[0]) / (2 * half);
  const double y = (arc.end[1] - arc.start[1]) / (2 * half);
  arc.centre = {(arc.start[0] + arc.end[0]) / 2 - side * height * y,
                (arc.start[1] + arc.end[1]) / 2 + side * height * x};
}

std::string_view how_centres_count(const Dialect& dialect) {
  constexpr int kAbsoluteCentres = 901;  // G90.1
  if (dialect.g_code(kAbsoluteCentres) != nullptr) return "G90.1 makes I, J and K absolute";
  if (dialect.syntax.word_modes) return "I=AC(..) and J=AC(..) count from the zero of the work system";
  return "I, J and K count from the start of the arc";
}

void centre_by_words(const Execution& run, PlaneArc& arc, const PlaneAxes& axes) {
  const std::array<Axis, 2> in_plane{axes.first, axes.second};
  for (std::size_t i = 0; i < 2; ++i) {
    const Word* const word = run.words.find(centre_letter(in_plane[i]));
    const double value = word == nullptr ? 0 : run.length(*word);
    const WordMode mode = word == nullptr ? WordMode::modal : word->mode;
    const bool absolute = mode == WordMode::modal ? run.control.modal.arc_centre_absolute : mode == WordMode::absolute;
    arc.centre[i] = absolute ? value : arc.start[i] + value;
  }
  const double at_start = distance(arc.start, arc.centre);
  const double at_end = distance(arc.end, arc.centre);
  if (std::min(at_start, at_end) < least_radius(run.control.modal.inches)) {
    run.refuse(run.motion_code(), codes::kArcRadius, "the arc has no radius", "its centre is its start or its end");
  }
  const bool known = run.dialect.behaviour.even_spirals || std::abs(at_start - at_end) <= kUnknownSpiralMm;
  if (!known || !radii_agree(at_start, at_end, run.control.modal.inches)) {
    const double unit = run.control.length_unit();
    run.refuse(run.motion_code(), codes::kArcRadius,
               fmt::format("the radius is {:.4f} at the start and {:.4f} at the end", at_start / unit, at_end / unit),
               fmt::format("check the centre and the end point; {}", how_centres_count(run.dialect)));
  }
}

// CIP: through a point between (I1 J1 K1). With a = point - start and b = end - start, the centre lies at start + u
// with 2 a.u = a.a, 2 b.u = b.b. Gives the turns: counter-clockwise if b lies left of a.
int centre_by_point(const Execution& run, PlaneArc& arc, const PlaneAxes& axes, const AxisWords& end) {
  const Control& control = run.control;
  const auto between = [&](Axis axis) {
    const Word* const word = run.words.find(static_cast<char>('1' + index(axis)));
    if (word == nullptr) return control.position[axis];
    const bool increments =
        word->mode == WordMode::modal ? control.modal.incremental : word->mode == WordMode::incremental;
    return run.length(*word) + (increments ? control.position[axis] : 0);
  };
  const double level = control.position[axes.third];
  const double tolerance = least_radius(run.control.modal.inches);
  if (std::abs(between(axes.third) - level) > tolerance || std::abs(end[axes.third] - level) > tolerance) {
    run.refuse(run.motion_code(), codes::kNotInterpreted,
               "a circle that is not in the plane in force is not interpreted",
               fmt::format("choose the plane of the circle (G17, G18, G19), or write it in G1"));
  }
  const double ax = between(axes.first) - arc.start[0];
  const double ay = between(axes.second) - arc.start[1];
  const double bx = arc.end[0] - arc.start[0];
  const double by = arc.end[1] - arc.start[1];
  const double cross = ax * by - ay * bx;
  if (std::abs(cross) < tolerance * tolerance) {
    run.refuse(run.motion_code(), codes::kArcEnds, "no circle goes through these three points",
               "they lie on a straight line, or two of them are the same");
  }
  const double aa = (ax * ax + ay * ay) / 2;
  const double bb = (bx * bx + by * by) / 2;
  arc.centre = {arc.start[0] + (aa * by - bb * ay) / cross, arc.start[1] + (bb * ax - aa * bx) / cross};
  return cross > 0 ? 1 : -1;
}

int turns_of(const Execution& run, bool clockwise) {
  const bool counts = (run.motion->word_mask & letter_bit('P')) != 0;  // else it is another code's
  const Word* const word = counts ? run.words.find('P') : nullptr;
  int turns = 1;
  if (word != nullptr) {
    const double extra = run.dialect.behaviour.turns_are_extra ? 1 : 0;  // TURN does not count the one begun [PG 9.5]
    const double whole = std::round(word->value) + extra;
    if (std::abs(word->value + extra - whole) > kWholeTurns || whole < 1 || whole > kNoLimit) {
      run.refuse(*word, codes::kArcTurns, fmt::format("{} is no count of turns", run.text_of(*word)),
                 fmt::format("write {} or a greater whole number", 1 - extra));
    }
    turns = static_cast<int>(whole);
  }
  return clockwise ? -turns : turns;
}

// Each axis of the plane must be known where the arc starts, else the circle is not known.
void check_start(const Execution& run, const PlaneAxes& axes) {
  for (const Axis axis : {axes.first, axes.second}) {
    if (run.control.known.contains(axis)) continue;
    run.refuse(run.motion_code(), codes::kPositionUnknown,
               fmt::format("the arc starts where {} is not known", letter(axis)),
               "move there with a G0 or G1 that names both axes of the plane");
  }
}

}  // namespace

void move_arc(Execution& run) {
  const Control& control = run.control;
  const PlaneAxes axes = axes_of(control.modal.plane);
  const bool clockwise = run.motion->action == Action::arc_cw;
  const bool through_point = run.motion->action == Action::arc_through_point;
  need_offsets(run);
  if (run.dialect.behaviour.inverse_time_arc_unknown && control.modal.feed_mode == FeedMode::inverse_time) {
    run.refuse(run.motion_code(), codes::kNotInterpreted,
               "what F says of an arc under inverse time (G93) was found in no source",
               "write G94 before the arc, with a feed per minute");
  }
  if (!through_point) check_words(run, axes);
  check_start(run, axes);
  Motion motion;
  motion.kind = MotionKind::arc;
  motion.to = end_of_move(run);
  motion.known_after = known_after_move(run);
  PlaneArc arc{{control.position[axes.first], control.position[axes.second]},
               {motion.to[axes.first], motion.to[axes.second]},
               {}};
  motion.feed = feed_of_move(run, true);
  motion.arc.turns = turns_of(run, clockwise);
  if (through_point) {
    motion.arc.turns = centre_by_point(run, arc, axes, motion.to);
  } else if (run.words.has('R')) {
    centre_by_radius(run, arc, clockwise);
  } else {
    centre_by_words(run, arc, axes);
  }
  motion.arc.plane = control.modal.plane;
  motion.arc.centre_mm[index(axes.first)] = arc.centre[0];
  motion.arc.centre_mm[index(axes.second)] = arc.centre[1];
  motion.arc.centre_mm[index(axes.third)] = control.position[axes.third];
  add_motion(run, motion);
}

}  // namespace plumbline::nc
