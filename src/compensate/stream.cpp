#include "compensate/stream.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/check.hpp"
#include "base/units.hpp"
#include "compensate/guard.hpp"
#include "path/curve.hpp"
#include "path/duration.hpp"
#include "path/subdivide.hpp"

namespace plumbline::compensate {
namespace {

constexpr double kChordStepMm = 10;  // at which the limits are checked along a rapid
constexpr double kChordStepDeg = 1;
constexpr std::uint64_t kReplayEvery = 16;  // corrected moves
constexpr double kOffsetProbeMm = 1;
constexpr std::string_view kStampMark = " compensated this program";

double length_mm(const AxisWords& d) {
  return std::sqrt(d[Axis::X] * d[Axis::X] + d[Axis::Y] * d[Axis::Y] + d[Axis::Z] * d[Axis::Z]);
}

double largest_turn_deg(const AxisWords& d) {
  return std::max({std::abs(d[Axis::A]), std::abs(d[Axis::B]), std::abs(d[Axis::C])});
}

std::string axis_list(AxisSet axes) {
  std::string list;
  for (const Axis axis : kAllAxes) {
    if (axes.contains(axis)) list += fmt::format("{}{}", list.empty() ? "" : ", ", letter(axis));
  }
  return list;
}

// Under G95 the speed is the spindle's to say.
std::optional<double> clock_seconds(const nc::Motion& motion, std::optional<double> duration) {
  return motion.feed_mode == nc::FeedMode::per_revolution ? std::nullopt : duration;
}

bool is_feed(nc::MotionKind kind) { return kind == nc::MotionKind::feed || kind == nc::MotionKind::arc; }

}  // namespace

Stream::Stream(const InputFile& source, const nc::Dialect& dialect, const nc::ProgramSettings& program,
               const machine::MachineModel& model, const Settings& settings, nc::EmitSettings emit, OutputFile& out)
    : source_(source),
      dialect_(dialect),
      program_settings_(program),
      model_(model),
      settings_(settings),
      program_(source, dialect, program),
      emitter_(source, dialect, std::move(emit), out),
      corrector_(model, settings) {}

Summary Stream::run(const Progress& progress) {
  set_touch_off();
  while (const nc::Step* step = program_.next()) {
    ++summary_.blocks;
    refuse_stamped(*step->block);
    refuse_flow(*step);
    take_tool(*step);
    if (!is_corrected(*step)) {
      pass(*step);
    } else if (step->motions.front().kind == nc::MotionKind::rapid) {
      correct_rapid(*step);
    } else {
      correct_feed(*step);
    }
    if (progress && summary_.blocks % 4096 == 0) progress(step->block->offset, source_.size());
  }
  emitter_.finish();
  finish_summary();
  return summary_;
}

// A compensated program holds the corrections already; a second helping would double them.
void Stream::refuse_stamped(const nc::Block& block) const {
  for (const nc::Comment& comment : block.comments) {
    const std::string_view text = block.at(comment.span);
    const std::size_t name = text.find("plumbline ");
    if (name == std::string_view::npos || text.find(kStampMark, name) == std::string_view::npos) continue;
    refuse("compensate-stamped", "this program was compensated already", "compensate the original program instead",
           place_of(block, source_.name()));
  }
}

// Corrections depend on the place, so that a loop or a cycle cannot keep its form.
void Stream::refuse_flow(const nc::Step& step) const {
  if (step.role == nc::BlockRole::cycle) {
    refuse("compensate-cycle", "canned cycles are not compensated yet",
           "write the cycle out in G0 and G1 with the CAM system; trace shows its moves",
           place_of(*step.block, source_.name()));
  }
  if (step.polar) {
    refuse("compensate-polar", "polar words (@ and ^) are not compensated yet", "write the end in X and Y",
           place_of(*step.block, source_.name()));
  }
  if (!step.flow) return;
  refuse("compensate-flow", "loops, branches and subprograms are not compensated yet",
         "unroll the program with the CAM system; trace shows its moves", place_of(*step.block, source_.name()));
}

void Stream::set_touch_off() {
  if (!settings_.touch_off) return;
  const std::optional<AxisWords> error = corrector_.error({*settings_.touch_off, {}, std::nullopt});
  if (!error) {
    refuse("compensate-touch-off", "the machine cannot stand at the touch-off pose",
           "give the pose in W at which the work offset was probed: --touch-off X,Y,Z,A,B,C in mm and deg");
  }
  touch_off_error_ = *error;
}

// Length (G43) and load (M6) of the tool.
void Stream::take_tool(const nc::Step& step) {
  const AxisWords& offset = step.frame->tool;
  const int tool = step.after->tool_in_spindle;
  if (offset == tool_offset_ && tool == tool_in_spindle_) return;
  for (const Axis axis : kAllAxes) {
    if (axis == Axis::Z || offset[axis] == 0) continue;
    refuse("compensate-tool-offset", fmt::format("the tool offset has a part in {}", letter(axis)),
           "a tool of a hexapod lies along the spindle: give its length alone", place_of(*step.block, source_.name()));
  }
  tool_offset_ = offset;
  tool_in_spindle_ = tool;
  const nc::Tool* row = tool >= 0 ? program_settings_.tools.find(tool) : nullptr;
  ToolInSpindle in_spindle;
  in_spindle.length = offset[Axis::Z] * kMm;
  if (row != nullptr && row->mass_kg) {
    in_spindle.mass = *row->mass_kg;
    in_spindle.along = row->centre_of_mass_mm.value_or(0) * kMm;
  } else {
    in_spindle.mass = model_.reference_tool_mass;
    if (tool >= 0) warn_of_massless_tool(step, tool);
  }
  corrector_.set_tool(in_spindle);
}

void Stream::warn_of_massless_tool(const nc::Step& step, int tool) {
  massless_tools_.try_emplace(tool, place_of(*step.block, source_.name()));
}

// True for the moves that get a correction; refuses feed moves whose position is not known.
bool Stream::is_corrected(const nc::Step& step) {
  if (step.role != nc::BlockRole::plain || step.motions.size() != 1) return false;
  const nc::Motion& motion = step.motions.front();
  const bool cuts = is_feed(motion.kind);
  if (motion.in_machine_coordinates || (!cuts && motion.kind != nc::MotionKind::rapid)) return false;
  const AxisSet known = cuts ? motion.known_after & motion.known_before : motion.known_after;
  const AxisSet missing = AxisSet::all() - known - assumed_axes(step, AxisSet::all() - known);
  if (missing.empty()) return true;
  if (!cuts) return false;
  refuse("compensate-position-unknown",
         fmt::format("this move cuts, and where {} stands is not known here", axis_list(missing)),
         fmt::format("move {} with G0 to a stated position first, or say where the machine stands: --start at the "
                     "begin, --keeps-position M6 after a tool change",
                     axis_list(missing)),
         place_of(*step.block, source_.name()));
}

// Rotary axes that no word of the program names are taken to stand at zero, and are never written.
AxisSet Stream::assumed_axes(const nc::Step& step, AxisSet unknown) {
  if ((unknown & AxisSet::rotary()).empty()) return {};
  if (!assumed_) {
    assumed_ = AxisSet::rotary() - nc::named_axes(source_, dialect_);
    corrector_.fix_axes(*assumed_);
  }
  for (const Axis axis : kAllAxes) {
    if (!unknown.contains(axis) || !assumed_->contains(axis)) continue;
    if (step.frame->to_pose({})[axis] == 0) continue;
    refuse("compensate-position-unknown",
           fmt::format("the program never says where {} stands, and the work offset turns it", letter(axis)),
           "say where the machine stands with --start", place_of(*step.block, source_.name()));
  }
  return unknown & *assumed_;
}

void Stream::pass(const nc::Step& step) {
  emitter_.copy(step);
  for (const nc::Motion& motion : step.motions) {
    if (motion.kind == nc::MotionKind::dwell) {
      summary_.seconds_before += motion.dwell_s;
      summary_.seconds_after += motion.dwell_s;
    } else {
      ++summary_.passed_moves;
    }
  }
}

Target Stream::target_of(const nc::Step& step, const AxisWords& words, const AxisWords& slope,
                         std::optional<double> seconds) const {
  AxisWords work = words;
  for (const Axis axis : kAllAxes) {
    if (assumed_ && assumed_->contains(axis)) work[axis] = 0;
  }
  nc::Frame turned;
  turned.rotation_deg = step.frame->rotation_deg;
  return {step.frame->to_pose(work) + touch_off_error_, turned.to_pose(slope), seconds};
}

nc::CorrectedPoint Stream::corrected_point(const nc::Step& step, const Target& target, const AxisWords& words) {
  const Pose<double> programmed = corrector_.pose_of(target.pose);
  refuse_violations(machine::check_programmed(model_.limits, programmed), *step.block, source_.name());
  const Corrected corrected = corrector_.correct(target);
  if (!corrected.converged) {
    refuse("compensate-unreachable", "the machine cannot be made to stand here: no strut lengths put the tool there",
           "move the part away from the edge of the workspace", place_of(*step.block, source_.name()));
  }
  refuse_violations(
      machine::check_compensated(model_.limits, corrector_.geometry(), corrector_.pose_of(corrected.pose)), *step.block,
      source_.name());
  AxisWords nominal = words;
  AxisWords shift = step.frame->from_pose(corrected.pose) - nominal;
  for (const Axis axis : kAllAxes) {
    if (!assumed_ || !assumed_->contains(axis)) continue;
    nominal[axis] = 0;
    shift[axis] = 0;
  }
  return {nominal, shift, 1};
}

// Only the end of a rapid is corrected; the control goes there as it likes, so the limits are checked on the chord.
void Stream::correct_rapid(const nc::Step& step) {
  const nc::Motion& motion = step.motions.front();
  const AxisWords shift_before = emitter_.control().work_shift(*step.frame);
  // Where it comes from decides which way friction acts; not known, it is left out.
  const bool start_known = motion.known_before.contains(writable());
  const AxisWords slope = start_known ? motion.to - motion.from : AxisWords{};
  const Target target = target_of(step, motion.to, slope, std::nullopt);
  points_.assign(1, corrected_point(step, target, motion.to));
  if (start_known) {
    check_chord(step, motion.from + shift_before, motion.to + points_.front().shift);
  }
  note_point(step, points_.front());
  note_move(step, emitter_.move(step, points_, writable(), std::nullopt), std::nullopt);
}

void Stream::check_chord(const nc::Step& step, const AxisWords& from, const AxisWords& to) const {
  const AxisWords delta = to - from;
  const double steps = std::max(length_mm(delta) / kChordStepMm, largest_turn_deg(delta) / kChordStepDeg);
  const int count = static_cast<int>(std::ceil(steps));
  for (int i = 1; i < count; ++i) {
    AxisWords words;
    for (const Axis axis : kAllAxes) words[axis] = from[axis] + delta[axis] * i / count;
    const Pose<double> pose = corrector_.pose_of(target_of(step, words, {}, std::nullopt).pose);
    refuse_violations(machine::check_compensated(model_.limits, corrector_.geometry(), pose), *step.block,
                      source_.name());
  }
}

void Stream::correct_feed(const nc::Step& step) {
  const nc::Motion& motion = step.motions.front();
  const path::Curve curve(motion);
  const std::optional<double> duration = path::duration(motion, curve, dialect_);
  const std::optional<double> seconds = clock_seconds(motion, duration);
  const path::Subdivision cut = path::subdivide(curve, seconds, settings_.step);
  points_.clear();
  for (int i = 1; i <= cut.pieces; ++i) {
    const double fraction = static_cast<double>(i) / cut.pieces;
    const AxisWords words = curve.at(fraction);
    const Target target = target_of(step, words, curve.slope(fraction), seconds);
    points_.push_back(corrected_point(step, target, words));
    points_.back().share = 1.0 / cut.pieces;
    note_point(step, points_.back());
    if (i == cut.pieces) note_end(step, target);
  }
  if (cut.widened) note_widened(step, curve, seconds);
  note_move(step, emitter_.move(step, points_, writable(), duration), seconds);
}

// What pieces longer than the steps cost: how far the middle of each lies from where it should be commanded.
void Stream::note_widened(const nc::Step& step, const path::Curve& curve, std::optional<double> seconds) {
  const std::size_t line = step.block->line;
  const auto count = static_cast<double>(points_.size());
  ++summary_.widened_blocks;
  summary_.widened_step_mm.take(curve.linear_mm() / count, line);
  AxisWords begin = step.motions.front().from + emitter_.control().work_shift(*step.frame);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const double middle = (static_cast<double>(i) + 0.5) / count;
    const Target target = target_of(step, curve.at(middle), curve.slope(middle), seconds);
    const AxisWords wanted = step.frame->from_pose(corrector_.correct(target).pose);
    const AxisWords end = points_[i].nominal + points_[i].shift;
    AxisWords off;
    for (const Axis axis : kAllAxes) off[axis] = (begin[axis] + end[axis]) / 2 - wanted[axis];
    summary_.widening_mm.take(length_mm(off), line);
    begin = end;
  }
}

// Axes that may get words.
AxisSet Stream::writable() const { return AxisSet::all() - assumed_.value_or(AxisSet{}); }

void Stream::note_point(const nc::Step& step, const nc::CorrectedPoint& point) {
  ++summary_.points;
  const double correction = length_mm(point.shift);
  sum_of_squares_ += correction * correction;
  summary_.correction_mm.take(correction, step.block->line);
  summary_.correction_deg.take(largest_turn_deg(point.shift), step.block->line);
}

void Stream::note_move(const nc::Step& step, const nc::EmittedMove& move, std::optional<double> seconds) {
  ++summary_.moves;
  if (move.changed) ++summary_.changed_blocks;
  summary_.rounding_mm.take(move.rounding_mm, step.block->line);
  if (!seconds || *seconds <= 0) return;
  const double after = move.seconds.value_or(*seconds);
  summary_.seconds_before += *seconds;
  summary_.seconds_after += after;
  summary_.time_change.take(std::abs(after / *seconds - 1), step.block->line);
}

// Some ends of blocks are played on the model: the figures of the summary are not those of the formula that made them.
void Stream::note_end(const nc::Step& step, const Target& target) {
  if (!sample_) {
    sample_ = target;
    summary_.zero_error = corrector_.error(target);
    summary_.zero_error_line = step.block->line;
  }
  if (corrected_moves_++ % kReplayEvery != 0) return;
  const nc::CorrectedPoint& point = points_.back();
  const AxisWords commanded = step.frame->to_pose(point.nominal + point.shift);
  const std::optional<double> distance = corrector_.tip_distance_mm(target, commanded);
  PLUMBLINE_CHECK(distance.has_value());
  summary_.residual_mm.take(*distance, step.block->line);
  ++summary_.replayed;
  summary_.condition.take(corrector_.condition(target), step.block->line);
  note_offset_sensitivity(target, commanded);
}

// How far the offset may be off: the change of the correction with the place of the part.
void Stream::note_offset_sensitivity(const Target& target, const AxisWords& commanded) {
  const AxisWords correction = commanded - target.pose;
  double squares = 0;
  for (const Axis axis : {Axis::X, Axis::Y, Axis::Z}) {
    Target moved = target;
    moved.pose[axis] += kOffsetProbeMm;
    const AxisWords there = corrector_.correct(moved).pose - moved.pose;
    const double change = length_mm(there - correction) / kOffsetProbeMm;
    squares += change * change;
  }
  if (squares == 0) return;
  summary_.offset_shift_for_1um_mm = std::min(summary_.offset_shift_for_1um_mm, kUm / kMm / std::sqrt(squares));
}

void Stream::finish_summary() {
  summary_.identical = !emitter_.changed();
  summary_.bytes_before = source_.size();
  if (summary_.points > 0)
    summary_.rms_correction_mm = std::sqrt(sum_of_squares_ / static_cast<double>(summary_.points));
  summary_.assumed_at_zero = assumed_.value_or(AxisSet{});
  for (const auto& [tool, place] : massless_tools_) {
    const std::optional<double> per_kg = sample_ ? corrector_.error_per_kg_mm(*sample_) : std::nullopt;
    summary_.warnings.push_back(
        {"compensate-tool-mass",
         fmt::format("tool {} has no mass{}", tool,
                     per_kg ? fmt::format(": each kg moves the tip by {:.2g} um", *per_kg * kMm / kUm) : std::string()),
         "state mass_kg and centre_of_mass_mm in the tool table (--tools)", place, Severity::warning});
  }
}

}  // namespace plumbline::compensate
