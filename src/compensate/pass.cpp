#include "compensate/pass.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/check.hpp"
#include "base/units.hpp"
#include "compensate/figures.hpp"
#include "compensate/guard.hpp"
#include "compensate/stamp_mark.hpp"
#include "path/curve.hpp"
#include "path/duration.hpp"
#include "path/subdivide.hpp"

namespace plumbline::compensate {
namespace {

constexpr double kChordStepMm = 10;  // at which the limits are checked along a rapid
constexpr double kChordStepDeg = 1;
constexpr int kManyPieces = 10'000;
constexpr double kNoWay = 1e-7;  // mm and deg

// To where the tool stands already, but for the last digits of an expression: no F could keep its time.
bool is_no_way(const nc::Motion& motion, const path::Curve& curve) {
  return motion.feed_mode != nc::FeedMode::inverse_time && curve.linear_mm() < kNoWay &&
         largest_turn_deg(curve.delta()) < kNoWay;
}

}  // namespace

Pass::Pass(const InputFile& source, const nc::Dialect& dialect, const nc::ProgramSettings& program,
           const machine::MachineModel& model, const Settings& settings, const nc::EmitSettings& emit, OutputFile& out,
           nc::Form form)
    : source_(source),
      dialect_(dialect),
      model_(model),
      settings_(settings),
      out_(out),
      program_(source, dialect, program),
      form_(form),
      plain_(dialect, emit.increment_ratio),
      emitter_(source, dialect, emit, out, form),
      corrector_(model, settings),
      intention_(source, dialect, emit, form == nc::Form::unrolled),
      spindle_(program.tools, model.reference_tool_mass),
      pose_(source, dialect) {
  if (settings.read_back) read_back_.emplace(source, dialect, program, emit, out, form == nc::Form::unrolled);
  pose_.on_assumed = [this](AxisSet axes) { corrector_.fix_axes(axes); };
}

bool Pass::run(const Progress& progress) {
  set_touch_off();
  compensate::refuse_stamped(source_);
  bool jumps = false;
  while (const nc::Step* step = program_.next()) {
    ++summary_.blocks;
    refuse_stamped(step->block->file);
    note_whether_it_ends(*step);
    if (!jumps && step->jumped && form_ == nc::Form::in_text_order) {
      jumps = true;
      emitter_.only_look();
    }
    intention_.begin(*step);
    take(*step);
    if (must_unroll_ || (jumps && emitter_.changed())) return false;
    note_intended();
    if (progress && summary_.blocks % kProgressEvery == 0) progress(step->block->offset, source_.size());
  }
  emitter_.finish();
  if (read_back_ && emitter_.changed()) summary_.read_back = read_back_->finish(intention_, emitter_.guard_span());
  return true;
}

// Subprograms of files of their own are compensated with the program, once.
void Pass::refuse_stamped(std::string_view file) {
  if (file == source_.name() || files_.contains(file)) return;
  files_.emplace(file);
  compensate::refuse_stamped(InputFile(std::string(file)));
}

// As long as nothing changed the output is the original, and what it means is not kept.
void Pass::note_intended() {
  if (!emitter_.changed() || !read_back_) {
    ++unchanged_blocks_;
    return intention_.start_batch();
  }
  intention_.end(out_.size());
  intention_.batch().unchanged_blocks += std::exchange(unchanged_blocks_, 0);
  read_back_->offer(intention_, emitter_.guard_span());
}

// Unrolled, lines that steer are left out, and what depends on parameters is written out.
void Pass::take(const nc::Step& step) {
  if (nc::dwells_first(step) && step.role == nc::BlockRole::plain && step.cycle == nc::CycleForm::none) {
    note_dwell(step.motions.front());
    nc::Step move = step;
    move.motions = step.motions.first(1);
    intention_.keep(move, true);
    move.motions = step.motions.subspan(1);
    return take(move);
  }
  take_tool(step);
  if (form_ == nc::Form::in_text_order) return process(step);
  if (step.flow && step.alarms) {
    refuse("compensate-flow", "the program stops here with an alarm, on a condition that the output does not hold",
           "look at the condition: with the offsets and variables given here it holds",
           place_of(*step.block, step.block->file));
  }
  if (step.flow && !step.motions.empty()) process(*plain_.without_call(step));
  if (step.flow || step.saves_modes) return emitter_.steer(step);
  const nc::Step* const plain = plain_.plain(step, false);
  if (plain == nullptr) return;
  if (!plain->nurbs_point) return process(*plain);
  for (const nc::Step* const rest : plain_.moves(*plain)) process(*rest);  // its curve is written out at its end
}

void Pass::process(const nc::Step& step) {
  refuse_system_of_block(step);
  if (step.cycle != nc::CycleForm::none) {
    process_cycle(step);
  } else if (step.role == nc::BlockRole::synchronised) {
    process_synchronised(step);
  } else if (!is_corrected(step)) {
    pass(step);
  } else if (step.motions.front().kind == nc::MotionKind::rapid) {
    correct_rapid(step);
  } else {
    correct_feed(step);
  }
}

// G16: only the first of the pieces of such a block would be in its work system.
void Pass::refuse_system_of_block(const nc::Step& step) const {
  if (step.motions.empty() || step.role == nc::BlockRole::machine_move) return;
  for (const nc::Word& word : step.block->words) {
    const nc::CodeRow* const row = dialect_.row_of(word);
    if (row == nullptr || row->action != nc::Action::work_system_of_block) continue;
    refuse("compensate-work-system", "this block moves in a work system that is in force for it alone",
           "choose the work system before it and the other one behind it, as with G15 H",
           place_of(*step.block, step.block->file));
  }
}

void Pass::set_touch_off() {
  if (!settings_.touch_off) return;
  const std::optional<AxisWords> error = corrector_.error({*settings_.touch_off, {}, {}, std::nullopt});
  if (!error) {
    refuse("compensate-touch-off", "the machine cannot stand at the touch-off pose",
           "give the pose in W at which the work offset was probed: --touch-off X,Y,Z,A,B,C in mm and deg");
  }
  touch_off_error_ = *error;
}

void Pass::take_tool(const nc::Step& step) {
  const std::optional<ToolInSpindle> tool = spindle_.change(step);
  if (!tool) return;
  const AxisWords& offset = step.frame->tool;
  for (const Axis axis : kAllAxes) {
    if (axis == Axis::Z || offset[axis] == 0) continue;
    refuse("compensate-tool-offset", fmt::format("the tool offset has a part in {}", letter(axis)),
           "a tool of a hexapod lies along the spindle: give its length alone",
           place_of(*step.block, step.block->file));
  }
  if (!spindle_.has_mass()) warn_of_massless_tool(step, step.after->tool_in_spindle);
  corrector_.set_tool(*tool);
}

void Pass::warn_of_massless_tool(const nc::Step& step, int tool) {
  massless_tools_.try_emplace(tool, place_of(*step.block, step.block->file));
}

// True for the moves that get a correction; refuses feed moves whose position is not known.
bool Pass::is_corrected(const nc::Step& step) {
  if (step.role != nc::BlockRole::plain || step.motions.size() != 1) return false;
  const nc::Motion& motion = step.motions.front();
  const bool cuts = is_cut(motion.kind);
  if (motion.in_machine_coordinates || (!cuts && motion.kind != nc::MotionKind::rapid)) return false;
  return has_position(step, cuts ? motion.known_after & motion.known_before : motion.known_after, cuts);
}

// Rotary axes that are taken to stand at zero are never written.
bool Pass::has_position(const nc::Step& step, AxisSet known, bool needed) {
  const auto place = [&] { return place_of(*step.block, step.block->file); };
  if (const AxisSet moved = pose_.assumed() & step.named; !moved.empty()) {
    refuse("compensate-position-unknown",
           fmt::format("{} was taken to stand at zero, since the program's own file never names it, and moves here",
                       axis_list(moved)),
           "say where the machine stands with --start", place());
  }
  const AxisSet unknown = AxisSet::all() - known;
  const AxisSet missing = unknown - pose_.assumed(step, unknown);
  if (missing.empty()) return true;
  if (!needed) return false;
  if (const AxisSet turned = missing & pose_.assumed(); !turned.empty()) {
    refuse("compensate-position-unknown",
           fmt::format("the program never says where {} stands, and the work offset turns it", axis_list(turned)),
           "say where the machine stands with --start", place());
  }
  refuse("compensate-position-unknown",
         fmt::format("this move cuts, and where {} stands is not known here", axis_list(missing)),
         fmt::format("move {} with G0 to a stated position first, or say where the machine stands: --start at the "
                     "begin, --keeps-position M6 after a tool change",
                     axis_list(missing)),
         place());
}

void Pass::copy(const nc::Step& step, bool counts, std::optional<double> seconds) {
  emitter_.copy(step);
  intention_.keep(step, counts, seconds);
}

void Pass::pass(const nc::Step& step) {
  copy(step, step.motions.size() == 1 && step.motions.front().kind == nc::MotionKind::dwell);
  for (const nc::Motion& motion : step.motions) {
    if (motion.kind == nc::MotionKind::dwell) {
      note_dwell(motion);
    } else {
      ++summary_.passed_moves;
    }
  }
}

Target Pass::target_of(const nc::Step& step, const path::CurvePoint& point, std::optional<double> seconds) const {
  Target target = pose_.target(step, point, seconds);
  target.pose = target.pose + touch_off_error_;
  return target;
}

nc::CorrectedPoint Pass::corrected_point(const nc::Step& step, const Target& target, const AxisWords& words) {
  const Pose<double> programmed = corrector_.pose_of(target.pose);
  refuse_violations(machine::check_programmed(model_.limits, programmed), *step.block, step.block->file);
  const Corrected corrected = corrector_.correct(target);
  if (!corrected.converged) {
    refuse("compensate-unreachable", "the machine cannot be made to stand here: no strut lengths put the tool there",
           "move the part away from the edge of the workspace", place_of(*step.block, step.block->file));
  }
  refuse_violations(
      machine::check_compensated(model_.limits, corrector_.geometry(), corrector_.pose_of(corrected.pose)), *step.block,
      step.block->file);
  AxisWords nominal = words;
  AxisWords shift = step.frame->from_pose(corrected.pose) - nominal;
  for (const Axis axis : kAllAxes) {
    if (!pose_.assumed().contains(axis)) continue;
    nominal[axis] = 0;
    shift[axis] = 0;
  }
  return {nominal, shift, 1};
}

// Only the end of a rapid is corrected; the control goes there as it likes, so the limits are checked on the chord.
void Pass::rapid_point(const nc::Step& step) {
  const nc::Motion& motion = step.motions.front();
  // Where it comes from decides which way friction acts; not known, it is left out.
  const bool start_known = motion.known_before.contains(writable());
  const AxisWords slope = start_known ? motion.to - motion.from : AxisWords{};
  const Target target = target_of(step, {motion.to, slope, {}}, std::nullopt);
  points_.assign(1, corrected_point(step, target, motion.to));
  if (!start_known) return;
  const AxisWords shift_before = emitter_.control().work_shift(*step.frame);
  check_chord(step, motion.from + shift_before, motion.to + points_.front().shift);
}

void Pass::correct_rapid(const nc::Step& step) {
  rapid_point(step);
  note_point(step, points_.front());
  note_move(step, write_move(step, std::nullopt), std::nullopt);
}

void Pass::check_chord(const nc::Step& step, const AxisWords& from, const AxisWords& to) const {
  const AxisWords delta = to - from;
  const double steps = std::max(length_mm(delta) / kChordStepMm, largest_turn_deg(delta) / kChordStepDeg);
  const int count = static_cast<int>(std::ceil(steps));
  for (int i = 1; i < count; ++i) {
    AxisWords words;
    for (const Axis axis : kAllAxes) words[axis] = from[axis] + delta[axis] * i / count;
    const Pose<double> pose = corrector_.pose_of(target_of(step, {words, {}, {}}, std::nullopt).pose);
    refuse_violations(machine::check_compensated(model_.limits, corrector_.geometry(), pose), *step.block,
                      step.block->file);
  }
}

path::Subdivision Pass::feed_points(const nc::Step& step, const path::Curve& curve, std::optional<double> seconds) {
  const path::Subdivision cut =
      path::subdivide(curve, seconds, settings_.step, place_of(*step.block, step.block->file));
  if (cut.pieces > kManyPieces) {  // a slip is seen at its end, before all of them are corrected
    const Target end = target_of(step, curve.point(1), seconds);
    refuse_violations(machine::check_programmed(model_.limits, corrector_.pose_of(end.pose)), *step.block,
                      step.block->file);
  }
  points_.clear();
  for (int i = 1; i <= cut.pieces; ++i) {
    const double fraction = static_cast<double>(i) / cut.pieces;
    const path::CurvePoint point = curve.point(fraction);
    points_.push_back(corrected_point(step, target_of(step, point, seconds), point.at));
    points_.back().share = 1.0 / cut.pieces;
  }
  return cut;
}

void Pass::correct_feed(const nc::Step& step) {
  const nc::Motion& motion = step.motions.front();
  const path::Curve curve(motion);
  std::optional<double> duration = path::duration(motion, curve, dialect_);
  if (is_no_way(motion, curve)) duration.reset();
  const std::optional<double> seconds = clock_seconds(motion, duration);
  const path::Subdivision cut = feed_points(step, curve, seconds);
  for (const nc::CorrectedPoint& point : points_) note_point(step, point);
  note_end(step, target_of(step, curve.point(1), seconds));
  if (cut.widened) note_widened(step, curve, seconds);
  note_move(step, write_move(step, duration), seconds);
}

// In text order a block with @ and ^ gets X and Y only where it must change.
nc::EmittedMove Pass::write_move(const nc::Step& step, std::optional<double> duration) {
  nc::EmittedMove move;
  if (!step.polar || emitter_.stays(step, points_, writable())) {
    move = emitter_.move(step, points_, writable(), duration);
    if (move.changed) {
      intention_.divide(step, points_, writable(), duration);
    } else {
      intention_.keep(step, true, duration);
    }
    return move;
  }
  intention_.divide(step, points_, writable(), duration);
  emitter_.begin_group(step);
  move = emitter_.move(*plain_.plain(step, true), points_, writable(), duration);
  emitter_.end_group(step);
  return move;
}

// Axes that may get words.
AxisSet Pass::writable() const { return AxisSet::all() - pose_.assumed(); }

}  // namespace plumbline::compensate
