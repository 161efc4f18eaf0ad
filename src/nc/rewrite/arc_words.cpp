#include "nc/rewrite/arc_words.hpp"

#include <algorithm>
#include <cmath>

#include "nc/language/block_words.hpp"

namespace plumbline::nc {
namespace {

constexpr double kSpiralShare = 0.5;   // of the spiral that the control takes: rounding comes on top
constexpr double kLeastRadius = 0.05;  // mm: words of a micrometre's tenth say its direction to 0.1 deg

bool is_through_point(const Block& block) {
  return std::any_of(block.words.begin(), block.words.end(),
                     [](const Word& word) { return word.letter >= '1' && word.letter <= '3'; });
}

}  // namespace

std::optional<ArcForm> arc_form(const Dialect& dialect, const WordGrid& words, const Step& step,
                                const OutputState& control) {
  const Motion& motion = step.motions.front();
  const bool by_radius = motion.feed_mode == FeedMode::inverse_time && dialect.behaviour.inverse_time_by_radius;
  if (motion.kind != MotionKind::arc || !dialect.behaviour.even_spirals || by_radius || is_through_point(*step.block))
    return std::nullopt;
  const PlaneAxes plane = axes_of(motion.arc.plane);
  ArcForm form;
  form.beside = dialect.behaviour.arcs_turn ? AxisSet::all() : AxisSet{plane.third} | step.named;
  const bool inches = step.after->inches;
  form.radii_apart_mm = kSpiralShare * spiral_taken(inches);
  form.least_radius_mm = std::max(kLeastRadius, least_radius(inches));
  const AxisWords stands = motion.from + control.work_shift(*step.frame);
  const WordGrid::AxisGrids grids = words.grids(step);
  form.may_close = true;
  for (const Axis axis : {plane.first, plane.second}) {
    const WordGrid::Grid& centre = words.centre_grid(step, axis);
    form.half_centre_mm = std::max(form.half_centre_mm, centre.quantum * centre.per_unit / 2);
    const WordGrid::Grid& end = *grids[index(axis)];
    const double word = end.kept(stands[axis] / end.per_unit) * end.per_unit;
    form.may_close = form.may_close && (step.after->incremental || std::abs(stands[axis] - word) <= kSamePlace);
  }
  return form;
}

ArcWords arc_words(const WordGrid& words, const Step& step, const Arc& arc, const AxisWords& start) {
  const PlaneAxes plane = axes_of(arc.plane);
  ArcWords written{arc, {}, {}, {}};
  for (std::size_t i = 0; i < 2; ++i) {
    const Axis axis = i == 0 ? plane.first : plane.second;
    const WordGrid::Grid& grid = words.centre_grid(step, axis);
    const double from = step.after->arc_centre_absolute ? 0 : start[axis];
    double& centre = written.arc.centre_mm[index(axis)];
    const double wanted = (centre - from) / grid.per_unit;
    WordGrid::check_word(step, wanted);
    written.letters[i] = kCentreLetters[index(axis)];
    written.value[i] = grid.kept(wanted);
    written.digits[i] = grid.digits;
    words.check_digits(step, written.value[i], grid.digits);
    centre = from + written.value[i] * grid.per_unit;
  }
  return written;
}

}  // namespace plumbline::nc
