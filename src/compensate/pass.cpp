#include "compensate/pass.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/check.hpp"
#include "base/units.hpp"
#include "compensate/block_effects.hpp"
#include "compensate/figures.hpp"
#include "compensate/guard.hpp"
#include "compensate/stamp_mark.hpp"
#include "path/curve.hpp"
#include "path/duration.hpp"
#include "path/subdivide.hpp"

namespace plumbline::compensate {
namespace {

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
      plain_(dialect,
             nc::written_number(nc::kept_of_axis_word(dialect.behaviour, true, false, emit.increment_ratio, false),
                                emit.digits_deg, emit.increment_deg)),
      written_(dialect, emit.increment_ratio),
      emitter_(source, dialect, emit, out, form),
      corrector_(model, settings),
      intention_(source, dialect, emit, form == nc::Form::unrolled, settings.read_back),
      spindle_(program.tools, model.reference_tool_mass),
      pose_(source, dialect),
      between_(corrector_) {
  if (settings.read_back) read_back_.emplace(source, dialect, program, emit, out, form == nc::Form::unrolled);
  pose_.on_fixed = [this](AxisSet axes) { corrector_.fix_axes(axes); };
}

bool Pass::run(const Progress& progress) {
  touch_off_error_ = touch_off_error(corrector_, settings_);
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
  pose_.take(step);
  take_tool(step);
  if (form_ == nc::Form::in_text_order) return process(step);
  if (step.flow && (step.alarms || step.shows_message)) {
    refuse("compensate-flow",
           fmt::format("the program stops here with {}, on a condition that the output does not hold",
                       step.alarms ? "an alarm" : "a message"),
           "look at the condition: with the offsets and variables given here it holds",
           place_of(*step.block, step.block->file));
  }
  if (step.flow || step.saves_modes) return steer(step);
  if (step.passes_variables) {
    refuse("compensate-flow", "this block hands variables to the control, and the program, written out, sets none",
           "write their values in their place", place_of(*step.block, step.block->file));
  }
  const nc::Step* const plain = plain_.plain(step, false);
  if (plain == nullptr) return;
  if (!plain->nurbs_point) return process(*plain);
  for (const nc::Step* const rest : written_.of(*plain)) process(*rest);  // its curve is written out at its end
}

// What stands beside a call comes before it, and so do comments.
void Pass::steer(const nc::Step& step) {
  const bool acts = acts_beside_flow(step, dialect_);
  if (const nc::Step* const rest = plain_.beside_flow(step, acts)) process(*rest);
  nc::Step steering = step;
  if (acts && step.entry.kind != nc::FlowEntry::Kind::none) steering.before = step.after;  // that is done
  emitter_.steer(steering);
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
  between_.leave();
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

void Pass::pass(const nc::Step& step) {
  copy(step, step.motions.size() == 1 && step.motions.front().kind == nc::MotionKind::dwell);
  const bool moves = std::any_of(step.motions.begin(), step.motions.end(),
                                 [](const nc::Motion& motion) { return motion.kind != nc::MotionKind::dwell; });
  if (moves || step.loses_position) between_.leave();
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
  const Command command = compensate::command(corrector_, model_.limits, target);
  refuse_violations(command.violations, *step.block, step.block->file);
  const Corrected& corrected = command.corrected;
  if (!corrected.converged) {
    refuse("compensate-unreachable", "the machine cannot be made to stand here: no strut lengths put the tool there",
           "move the part away from the edge of the workspace", place_of(*step.block, step.block->file));
  }
  signs_.push_back(corrected.sign);
  AxisWords nominal = words;
  AxisWords shift = step.frame->from_pose(corrected.pose) - nominal;
  for (const Axis axis : kAllAxes) {
    if (!pose_.assumed().contains(axis)) continue;
    nominal[axis] = 0;
    shift[axis] = 0;
  }
  if (!pose_.tilted()) return {nominal, shift, 1};
  const AxisWords standing = emitter_.control().work_shift(*step.frame);
  for (const Axis axis : {Axis::A, Axis::B, Axis::C}) shift[axis] = standing[axis];
  return {nominal, shift, 1};
}

// Only the end of a rapid is corrected; the control goes there as it likes, so the limits are checked on the chord.
void Pass::rapid_point(const nc::Step& step) {
  const nc::Motion& motion = step.motions.front();
  // Where it comes from decides which way friction acts; not known, it is left out.
  const bool start_known = motion.known_before.contains(writable());
  const AxisWords slope = start_known ? motion.to - motion.from : AxisWords{};
  const Target target = target_of(step, {motion.to, slope, {}}, std::nullopt);
  signs_.clear();
  points_.assign(1, corrected_point(step, target, motion.to));
  if (!start_known) return;
  const Target from = target_of(step, {motion.from, {}, {}}, std::nullopt);
  const AxisWords commanded = step.frame->to_pose(points_.front().nominal + points_.front().shift);
  refuse_violations(check_way(corrector_, model_.limits, from, target, commanded), *step.block, step.block->file);
}

void Pass::correct_rapid(const nc::Step& step) {
  rapid_point(step);
  between_.rapid(signs_.back());
  note_point(step, points_.front());
  note_move(step, write_move(step, std::nullopt), std::nullopt);
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
  signs_.clear();
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
  const AxisWords begin = motion.from + emitter_.control().work_shift(*step.frame);
  const nc::EmittedMove move = write_move(step, duration);
  follow_cut(step, curve, begin, move.changed, seconds);
  if (move.changed && seconds) note_short_pieces(step, *seconds);
  note_move(step, move, seconds);
}

OriginalPath Pass::path_of(const nc::Step& step, const path::Curve& curve) const {
  return {curve, *step.frame, touch_off_error_, pose_.assumed(), step.block->line};
}

// What was written for a move, as the control keeps it.
void Pass::follow_cut(const nc::Step& step, const path::Curve& curve, const AxisWords& begin, bool changed,
                      std::optional<double> seconds) {
  const auto in_W = [&](AxisWords words) {
    for (const Axis axis : kAllAxes) {
      if (pose_.assumed().contains(axis)) words[axis] = 0;
    }
    return step.frame->to_pose(words);
  };
  sent_.clear();
  if (!changed) {
    const AxisWords end = in_W(step.motions.front().to);
    sent_.push_back({end, end, 1, signs_.back()});
  } else {
    const std::span<const nc::Piece> pieces = emitter_.pieces().pieces();
    const std::span<const AxisWords> ends = emitter_.pieces().ends();
    double share = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      share += pieces[i].share;
      const double at = std::round(share * static_cast<double>(points_.size()));
      const std::size_t point = std::clamp<std::size_t>(static_cast<std::size_t>(at), 1, points_.size()) - 1;
      const AxisWords wanted = in_W(points_[point].nominal + points_[point].shift);
      sent_.push_back({in_W(ends[i]), wanted, pieces[i].share, signs_[point]});
    }
  }
  between_.cut(path_of(step, curve), seconds, in_W(begin), sent_, !changed);
}

// Axes that may get words.
AxisSet Pass::writable() const { return AxisSet::all() - pose_.fixed(); }

}  // namespace plumbline::compensate
