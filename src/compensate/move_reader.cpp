#include "compensate/move_reader.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "base/units.hpp"
#include "compensate/limits.hpp"
#include "path/duration.hpp"

namespace plumbline::compensate {
namespace {

constexpr double kNoWay = 1e-7;  // mm and deg

void refuse_to_follow(const nc::Step& step, const UnknownPosition& unknown) {
  const Place place = place_of(step);
  if (!unknown.moved.empty()) {
    refuse("walk-position-unknown",
           "an axis was taken to stand at zero, since the program's own file never names it, and moves here",
           "say where the machine stands with --start", place);
  }
  refuse("walk-position-unknown",
         fmt::format("this move cuts, and where some axis stands is not known {}", where_unknown(unknown)),
         way_to_known(unknown, "all axes"), place);
}

// M0 lets people move the axes, M6 takes them to the changer, and what a code of the builder does nobody knows.
// `keeps`: those that do not, as the user says.
std::string code_that_loses(const nc::Step& step, const nc::Dialect& dialect, const std::set<int>& keeps) {
  if (step.stop == nc::StopByVariable::message) return "M0";
  for (const nc::Word& word : step.block->words) {
    if (word.letter != 'M' || keeps.contains(static_cast<int>(word.value))) continue;
    const nc::CodeRow* row = dialect.row_of(word);
    if (row == nullptr || row->action == nc::Action::refused) row = &dialect.user_row;  // --pass
    if (row->loses_position) return fmt::format("M{:g}", word.value);
  }
  return "";
}

// CYCLE800(): the machine turns its axes as its own data say.
bool ends_swivel(const nc::Step& step, const nc::Dialect& dialect) {
  const std::vector<nc::Word>& words = step.block->words;
  return step.role == nc::BlockRole::machine_move && std::any_of(words.begin(), words.end(), [&](const nc::Word& word) {
           const nc::CodeRow* const row = word.letter == nc::kNamedCode ? dialect.row_of(word) : nullptr;
           return row != nullptr && row->action == nc::Action::swivel;
         });
}

// Its words as they stand, with the values of a call: "G74 X0", "CYCLE800()".
std::string words_of(const nc::Block& block) {
  constexpr std::size_t kMost = 40;
  if (block.words.empty()) return "this";
  std::size_t begin = block.text.size();
  std::size_t end = 0;
  for (const nc::Word& word : block.words) {
    begin = std::min<std::size_t>(begin, word.span.begin);
    end = std::max<std::size_t>(end, word.span.end);
  }
  if (end < block.text.size() && block.text[end] == '(')
    end = std::min(block.text.find(')', end), block.text.size() - 1) + 1;
  const std::string_view text = block.text.substr(begin, end - begin);
  return text.size() <= kMost ? std::string(text) : std::string(text.substr(0, kMost)) + "...";
}

}  // namespace

bool sets_mode_alone(const nc::Step& step, const nc::Motion& motion) {
  return motion.kind == nc::MotionKind::feed && step.named.empty() && motion.to == motion.from &&
         !motion.known_before.contains(AxisSet::linear());
}

std::string where_unknown(const UnknownPosition& unknown) {
  return unknown.stop.empty() ? "here" : "after " + unknown.stop;
}

std::string way_to_known(const UnknownPosition& unknown, std::string_view axes) {
  if (unknown.stop.empty() && unknown.no_system) {
    return fmt::format(
        "move {} with G0 to a stated position first, after the first G15 as well: which work system is in force at the "
        "start is not known, so that --start cannot say it; after a tool change say --keeps-position M6 if the axes "
        "stand where they stood",
        axes);
  }
  if (unknown.stop.empty()) {
    return fmt::format(
        "move {} with G0 to a stated position first, or say with --start where the machine stands at the begin", axes);
  }
  if (unknown.by_length) {
    return fmt::format(
        "move {} with G0 to a stated position after it, or change the length while A, B and C stand at zero", axes);
  }
  if (unknown.stop_code.empty()) return fmt::format("move {} with G0 to a stated position after it", axes);
  return fmt::format(
      "move {} with G0 to a stated position after it, or, if the axes stand there where they stood "
      "before, say --keeps-position {}",
      axes, unknown.stop_code);
}

nc::ProgramSettings settings_of_reading(nc::ProgramSettings program, const ReaderSettings& settings) {
  if (!settings.as_it_stands) program.upright_deg = nc::kOwnTiltDeg;
  program.named = settings.named;
  return program;
}

std::optional<ToolInSpindle> SpindleTool::change(const nc::Step& step) {
  const AxisWords& offset = step.frame->tool;
  const bool moves_old_tool = step.tool_change == nc::ToolChange::after_motion;
  const int number = (moves_old_tool ? step.before : step.after)->tool_in_spindle;
  if (offset_ == offset && number == number_) return std::nullopt;
  offset_ = offset;
  number_ = number;
  const nc::Tool* const row = number >= 0 ? tools_.find(number) : nullptr;
  has_mass_ = number < 0 || (row != nullptr && row->mass_kg);
  ToolInSpindle tool{offset[Axis::Z] * kMm, reference_mass_, 0};
  if (row != nullptr && row->mass_kg) {
    tool.mass = *row->mass_kg;
    tool.along = row->centre_of_mass_mm.value_or(0) * kMm;
  }
  return tool;
}

Move move_of(const nc::Step& step, const nc::Motion& motion, const nc::Dialect& dialect, const ReaderSettings& settings,
             AxisSet at_zero) {
  Move move{.step = &step,
            .motion = &motion,
            .path = {path::Curve(motion), *step.frame, settings.touch_off_error, at_zero, fixed_axes(step, at_zero),
                     step.block->line}};
  move.duration = path::duration(motion, move.path.curve, dialect);
  if (motion.feed_mode != nc::FeedMode::per_revolution) move.seconds = move.duration;
  // Where a rapid comes from decides which way friction acts; not known, that is left out.
  move.begin_known = motion.known_before.contains(AxisSet::all() - at_zero);
  return move;
}

bool goes_nowhere(const path::Curve& curve) {
  return curve.linear_mm() < kNoWay && path::largest_turn_deg(curve.delta()) < kNoWay;
}

void forget_time_of_no_way(Move& move) {
  if (goes_nowhere(move.path.curve)) move.duration = move.seconds = std::nullopt;
}

void divide(Move& move, const path::StepSettings& settings) {
  if (move.is_rapid()) {
    if (move.begin_known) move.pieces = chord_steps(move.path.curve.delta());
    return;
  }
  path::StepSettings steps = settings;
  if (move.motion->feed_mode == nc::FeedMode::inverse_time)
    steps.least_time_s = std::max(steps.least_time_s, steps.least_inverse_time_s);
  const path::Subdivision cut =
      path::subdivide(move.path.curve, move.seconds, steps, [&] { return place_of(*move.step); });
  move.pieces = cut.pieces;
  move.widened = cut.widened;
}

const nc::Step* MoveReader::next() {
  const nc::Step* const step = program_.next();
  if (step == nullptr) return nullptr;
  ++blocks_;
  note_away(*step);
  note_stop(*step);
  passed_.take(*step);
  return step;
}

void MoveReader::note_away(const nc::Step& step) {
  if (settings_.named.contains(AxisSet::rotary())) return;
  for (const nc::Motion& motion : step.motions) {
    for (const Axis axis : {Axis::A, Axis::B, Axis::C}) {
      if (motion.known_after.contains(axis) && motion.machine[axis] != 0) away_.insert(axis);
    }
  }
}

void MoveReader::note_stop(const nc::Step& step) {
  stop_.axes = stop_.axes - known_;  // as of this block's begin: what it states itself may be what is missing
  AxisSet lost = std::exchange(known_, step.known) - step.known;
  if (ends_swivel(step, dialect_)) {  // whoever is taken to stand at zero does so no more
    gone_ = AxisSet::rotary() - settings_.named;
    lost = lost | gone_;
  }
  if (lost.empty()) return;
  const std::string code = step.loses_position ? code_that_loses(step, dialect_, keeps_position_) : "";
  const bool by_length = code.empty() && step.tilted_length;
  std::string name = code.empty() ? words_of(*step.block) : code;
  if (by_length) name = "the change of the tool's length under a tilt";
  if (step.stop == nc::StopByVariable::message) name = fmt::format("#{}", dialect_.syntax.message_variable);
  stop_ = {lost, std::move(name), code, step.block->line, std::string(step.block->file), by_length};
  if (ends_swivel(step, dialect_)) swivel_ = stop_;
}

UnknownPosition MoveReader::unknown(const nc::Step& step, AxisSet known) {
  UnknownPosition found;
  found.moved = at_zero_ & step.named;
  if (!found.moved.empty()) return found;
  found.missing = AxisSet::all() - known;
  const Stop& stop = (found.missing & stop_.axes).empty() ? swivel_ : stop_;
  if (!stop.name.empty() && !(found.missing & stop.axes).empty()) {
    const bool here = stop.file == step.block->file;
    found.stop = fmt::format("{} in line {}{}", stop.name, stop.line, here ? "" : fmt::format(" of {}", stop.file));
    found.stop_code = stop.code;
    found.by_length = stop.by_length;
  }
  found.no_system = dialect_.behaviour.no_work_system_at_start;
  if ((found.missing & AxisSet::rotary()).empty()) return found;
  at_zero_ = at_zero_ | ((found.missing & AxisSet::rotary()) - settings_.named - away_ - gone_);
  const AxisWords origin = step.frame->to_pose({});
  for (const Axis axis : kAllAxes) {
    if (!at_zero_.contains(axis) || gone_.contains(axis) || !found.missing.contains(axis)) continue;
    if (origin[axis] != 0) {
      found.turned.insert(axis);
    } else {
      found.missing.erase(axis);
    }
  }
  return found;
}

// True if it can be followed, and move_ is that.
bool MoveReader::take(const nc::Motion& motion) {
  if (motion.kind == nc::MotionKind::dwell) {
    end_s_ += motion.dwell_s;
    return false;
  }
  if (!motion.in_machine_coordinates && motion.kind != nc::MotionKind::probe && !sets_mode_alone(*step_, motion)) {
    const UnknownPosition not_known = unknown(*step_, motion);
    if (!not_known.moved.empty() || (!not_known.none() && path::is_cut(motion.kind)))
      refuse_to_follow(*step_, not_known);
    if (not_known.none()) {
      move_ = move(*step_, motion);
      divide(*move_);
      begin_s_ = end_s_;
      end_s_ += move_->seconds.value_or(0);
      return true;
    }
  }
  ++passed_moves_;
  return false;
}

const Move* MoveReader::next_move(const Progress& progress) {
  while (true) {
    while (step_ != nullptr && motion_ < step_->motions.size()) {
      if (take(step_->motions[motion_++])) return &*move_;
    }
    if (step_ != nullptr && progress && blocks_ % kProgressEvery == 0) progress(step_->block->offset, source_.size());
    step_ = next();
    motion_ = 0;
    if (step_ == nullptr) return nullptr;
    if (std::optional<ToolInSpindle> tool = new_tool(*step_)) changed_tool_ = tool;
  }
}

}  // namespace plumbline::compensate
