#include "compensate/pipeline.hpp"

#include <algorithm>
#include <cstdlib>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "base/diagnostic.hpp"
#include "compensate/limits.hpp"
#include "compensate/place_in_file.hpp"
#include "nc/sequence/program_ends.hpp"
#include "path/figures.hpp"

namespace plumbline::compensate {
namespace {

void refuse_unknown(const nc::Step& step, const UnknownPosition& unknown) {
  if (unknown.none()) return;
  constexpr std::string_view kCode = "compensate-position-unknown";
  const auto say_start = [] { return std::string("say where the machine stands with --start"); };
  if (!unknown.moved.empty()) {
    refuse(kCode,
           fmt::format("{} was taken to stand at zero, since the program's own file never names it, and moves here",
                       axis_list(unknown.moved)),
           say_start(), place_of(step));
  }
  if (!unknown.turned.empty()) {
    refuse(
        kCode,
        fmt::format("the program never says where {} stands, and the work offset turns it", axis_list(unknown.turned)),
        say_start(), place_of(step));
  }
  const std::string missing = axis_list(unknown.missing);
  refuse(kCode, fmt::format("this move cuts, and where {} stands is not known {}", missing, where_unknown(unknown)),
         way_to_known(unknown, missing), place_of(step));
}

// G16: only the first of the pieces of such a block would be in its work system.
void refuse_system_of_block(const nc::Step& step, const nc::Dialect& dialect) {
  if (step.motions.empty() || step.role == nc::BlockRole::machine_move) return;
  for (const nc::Word& word : step.block->words) {
    const nc::CodeRow* const row = dialect.row_of(word);
    if (row == nullptr || row->action != nc::Action::work_system_of_block) continue;
    refuse("compensate-work-system", "this block moves in a work system that is in force for it alone",
           "choose the work system before it and the other one after it, as with G15 H", place_of(step));
  }
}

// G4 P2 I3 while an arc is in force: P is the wait and the turns of the arc, and stays in the block with the wait.
void refuse_turns_of_wait(const nc::Step& step) {
  const bool turns = std::any_of(step.motions.begin(), step.motions.end(), [](const nc::Motion& motion) {
    return motion.kind == nc::MotionKind::arc && std::abs(motion.arc.turns) != 1;
  });
  if (!turns) return;
  refuse("emit-shared-words",
         "P is the seconds of the wait and the turns of the arc at once, which becomes several blocks",
         "put G4 and its P into a block of their own before the arc", place_of(step));
}

// A tool of a hexapod lies along the spindle.
void refuse_offset_beside_spindle(const nc::Step& step) {
  for (const Axis axis : kAllAxes) {
    if (axis == Axis::Z || step.frame->tool[axis] == 0) continue;
    refuse("compensate-tool-offset", fmt::format("the tool offset has a part in {}", letter(axis)),
           "a tool of a hexapod lies along the spindle: give its length alone", place_of(step));
  }
}

bool names_its_cycle(const nc::Step& step, const nc::Dialect& dialect) {
  return std::any_of(step.block->words.begin(), step.block->words.end(), [&](const nc::Word& word) {
    const nc::CodeRow* const row = nc::is_code(word) ? dialect.row_of(word) : nullptr;
    return row != nullptr && row->action == nc::Action::cycle;
  });
}

// A rigid tap ends at any other motion: its blocks stay as they are, their holes shifted. A block of an OSP states all
// words of its cycle again, and goes on from none.
void refuse_unless_in_place(const nc::Step& step, bool goes_on, const nc::Dialect& dialect) {
  if (step.cycle != nc::CycleForm::spindle || !dialect.behaviour.fanuc_cycles) return;
  if (goes_on && !dialect.behaviour.return_levels) {
    refuse("compensate-cycle", "this cycle goes on from one that is written out as moves",
           "write G80 before it, and state all of its words", place_of(step));
  }
  if (nc::WrittenMoves::is_one_hole(step)) return;
  refuse("compensate-cycle",
         "a cycle that works the spindle is shifted hole by hole, and this block makes several, or counts from the one "
         "before it (G91, K, L)",
         "write each hole into a block of its own, with G90", place_of(step));
}

// A block of which each point was shifted alike, and the bytes that stand for it.
void record_shifted(OutputRecord& record, MoveReader& reader, const nc::Step& step, const AxisWords& shift,
                    std::uint64_t after_begin, std::uint64_t after_end) {
  for (const nc::Motion& motion : step.motions) {
    if (motion.kind == nc::MotionKind::dwell) continue;
    if (reader.unknown(step, motion).none()) {
      record.shifted(reader.move(step, motion), shift, after_begin, after_end);
    } else {
      record.leave();
    }
  }
}

// A control that loads an archive stores each of its programs.
void carry_over_programs_behind(Rewriter& rewriter, const InputFile& source, const nc::Dialect& dialect) {
  const std::optional<nc::ProgramsBehind> behind = nc::programs_behind(source, dialect);
  if (!behind) return;
  if (behind->main) {
    refuse("compensate-flow",
           "the program is written out, and this main program that it calls would stand behind it as it is",
           "end its name with _SPF, or put it into a file of its own", *behind->main);
  }
  rewriter.carry_over(behind->begin);
}

}  // namespace

Pipeline::Pipeline(const InputFile& source, const ProgramSurvey& survey, const nc::ProgramSettings& program,
                   const machine::MachineModel& model, const Settings& settings, const nc::EmitSettings& emit,
                   OutputFile& out, nc::Form form)
    : source_(source),
      dialect_(survey.dialect),
      settings_(settings),
      corrector_(model, settings),
      reading_{survey.named, divided_by(settings), model.reference_tool_mass,
               touch_off_error(corrector_, model.limits, settings)},
      ahead_(model, settings, dialect_, program.tools, reading_, source.name()),
      reader_(source, dialect_, program, reading_, settings.bound.is_asked() ? nullptr : &ahead_),
      moves_(corrector_, model.limits, MoveCorrector::AtViolation::stop, settings.bound),
      holes_(dialect_, corrector_, model.limits, settings, moves_),
      steps_(dialect_, emit, form),
      rewriter_(source, dialect_, program, emit, out, steps_, settings.read_back),
      play_(model, settings),
      tally_(source, dialect_, model, settings, corrector_),
      stamps_(source) {}

bool Pipeline::run(const Progress& progress) {
  stamps_.look_at_program();
  bool values_alone = false;  // what changes is written unrolled
  while (const nc::Step* const step = reader_.next()) {
    stamps_.look_at(step->block->file);
    ahead_.come_to(*step, reader_.handed_over(), reader_.place());
    tally_.take_block(*step);
    if (!values_alone && (reader_.jumped() || reader_.position_read()) && !steps_.unrolled()) {
      values_alone = true;
      rewriter_.only_look();
    }
    rewriter_.begin(*step);
    take_block(*step);
    if (must_unroll_ || (values_alone && rewriter_.changed())) return false;
    rewriter_.end();
    if (progress && reader_.blocks() % kProgressEvery == 0) progress(step->block->offset, source_.size());
  }
  if (steps_.unrolled() && reader_.jumped()) carry_over_programs_behind(rewriter_, source_, dialect_);
  rewriter_.finish();
  return true;
}

void Pipeline::take_block(const nc::Step& step) {
  if (nc::dwells_first(step) && step.role == nc::BlockRole::plain && step.cycle == nc::CycleForm::none) {
    nc::Step part = step;
    part.motions = step.motions.first(1);
    tally_.take_dwell(part.motions.front());
    rewriter_.keep_wait(part);
    part.motions = step.motions.subspan(1);
    if (settings_.bound.is_asked()) refuse_turns_of_wait(part);
    return take_block(part);
  }
  follow_tool(step);
  const WrittenSteps::OfBlock written = steps_.of(step);
  for (const std::string& line : steps_.restated_variables(step)) rewriter_.add_line(step, line);
  for (const nc::Step* const part : written.steps) {
    try {
      take(*part);
    } catch (const Refusal& refusal) {
      refuse_in_file(refusal, *part->block, *step.block);
    }
  }
  if (written.steering) rewriter_.steer(*written.steering);
}

void Pipeline::follow_tool(const nc::Step& step) {
  const std::optional<ToolInSpindle> tool = reader_.new_tool(step);
  if (!tool) return;
  refuse_offset_beside_spindle(step);
  if (!reader_.tool_has_mass()) tally_.take_massless_tool(step);
  play_.set_tool(*tool);
  if (recorded_) recorded_->set_tool(*tool, step.after->tool_in_spindle);
  if (samples_ != nullptr) samples_->set_tool(*tool);
  tally_.before_other_tool();
  corrector_.set_tool(*tool);
  ++tools_;
}

void Pipeline::take(const nc::Step& step) {
  refuse_system_of_block(step, dialect_);
  if (step.cycle != nc::CycleForm::none) {
    take_cycle(step);
  } else if (step.role == nc::BlockRole::synchronised) {
    take_synchronised(step);
  } else if (is_corrected(step)) {
    take_move(step);
  } else {
    copy_through(step);
  }
}

// True for the moves that get a correction; refuses feed moves whose position is not known.
bool Pipeline::is_corrected(const nc::Step& step) {
  if (step.role != nc::BlockRole::plain || step.motions.size() != 1) return false;
  const nc::Motion& motion = step.motions.front();
  const bool cuts = path::is_cut(motion.kind);
  if (motion.in_machine_coordinates || (!cuts && motion.kind != nc::MotionKind::rapid)) return false;
  if (sets_mode_alone(step, motion)) return false;
  const UnknownPosition unknown = reader_.unknown(step, motion);
  if (unknown.moved.empty() && !cuts) return unknown.none();
  refuse_unknown(step, unknown);
  return true;
}

void Pipeline::copy_through(const nc::Step& step) {
  rewriter_.copy(step, nc::dwells_alone(step));
  const bool moves = std::any_of(step.motions.begin(), step.motions.end(),
                                 [](const nc::Motion& motion) { return motion.kind != nc::MotionKind::dwell; });
  if (moves || step.loses_position) {  // to where nobody follows the machine
    play_.leave();
    if (recorded_) recorded_->leave();
  }
  for (const nc::Motion& motion : step.motions) {
    if (motion.kind == nc::MotionKind::dwell) {
      tally_.take_dwell(motion);
    } else {
      tally_.take_passed_move();
    }
  }
}

// Of the move `ahead`, where that is known, the points that were corrected with the tool that is in the spindle.
const CorrectedMove& Pipeline::corrected(const Move& move, const MoveAhead* ahead) {
  if (ahead_.looks()) moves_.expect(ahead_.points().tools == tools_ ? &ahead_.points() : nullptr, ahead);
  const WordsOfMove words = settings_.bound.is_asked() ? rewriter_.words_of(*move.step) : WordsOfMove{};
  const CorrectedMove& corrected = moves_.correct(move, rewriter_.standing(*move.step), words);
  refuse_violations(corrected.violations, *move.step, reader_.passed());
  return corrected;
}

void Pipeline::take_move(const nc::Step& step) {
  const MoveAhead* const ahead = ahead_.looks() ? ahead_.move_of(step, reader_.at_zero()) : nullptr;
  if (ahead == nullptr) {
    move_ = reader_.move(step, step.motions.front());
    forget_time_of_no_way(move_);
    reader_.divide(move_);
  }
  const Move& move = ahead != nullptr ? ahead->move : move_;
  const CorrectedMove& corrected = this->corrected(move, ahead);
  const std::uint64_t begin = rewriter_.written_bytes();
  const WrittenMove& written = rewriter_.write(corrected);
  if (recorded_) recorded_->move(corrected, written, begin, rewriter_.written_bytes());
  if (move.is_rapid()) {
    play_.rapid(corrected.signs.back());
    tally_.take_rapid(corrected, written);
  } else {
    if (samples_ != nullptr) samples_->add(move, corrected.points.size());
    play_.cut({&move.path, move.seconds, written.begin, written.pieces, !written.changed});
    tally_.take_cut(corrected, written);
  }
}

// The spindle leads: such a block cannot be divided, and its K would have to follow the corrections.
void Pipeline::take_synchronised(const nc::Step& step) {
  bool stays = rewriter_.stands_true(step, reader_.writable(step));
  for (const nc::Motion& motion : step.motions) {
    refuse_unknown(step, reader_.unknown(step, motion.known_before & motion.known_after));
    const CorrectedMove& end =
        moves_.correct_places(reader_.move(step, motion), {&motion.to, 1}, rewriter_.standing(step));
    refuse_violations(end.violations, step);
    stays = stays && rewriter_.are_none(step, end);
  }
  if (stays) return copy_through(step);
  refuse("compensate-synchronised", "a move that follows the spindle (G33, G33.1) is not compensated",
         "tap with G84, which is shifted as a whole, or mill the thread", place_of(step));
}

// Left as it is, written out move by move, or kept with its holes shifted.
void Pipeline::take_cycle(const nc::Step& step) {
  const bool goes_on = rewriter_.goes_on_from_written_out(step);
  const bool anew = goes_on && dialect_.behaviour.return_levels && !names_its_cycle(step, dialect_);
  const std::span<const nc::Step* const> moves = steps_.of_cycle(step, anew);
  const bool point_by_point = step.nurbs == nc::NurbsBlock::end && steps_.unrolled();  // its points were left out
  if (!goes_on && !point_by_point && cycle_stays(step, moves)) {
    rewriter_.copy(step, true);
    const std::uint64_t end = rewriter_.written_bytes();
    for (const nc::Step* const move : moves) {
      if (recorded_) record_shifted(*recorded_, reader_, *move, {}, end, end);
    }
    return tally_.take_cycle(step);
  }
  if (step.nurbs == nc::NurbsBlock::end && !point_by_point) {
    must_unroll_ = true;  // the blocks of its points are written already
    return;
  }
  refuse_unless_in_place(step, goes_on, dialect_);
  rewriter_.begin_cycle(step);
  holes_.begin(step);
  for (const nc::Step* const move : moves) {
    if (move->cycle != nc::CycleForm::none) {
      take_hole(*move);
    } else {
      take(*move);
    }
  }
  rewriter_.end_cycle(step);
}

bool Pipeline::cycle_stays(const nc::Step& step, std::span<const nc::Step* const> moves) {
  if (!rewriter_.stands_true(step, reader_.writable(step))) return false;
  return std::all_of(moves.begin(), moves.end(), [&](const nc::Step* const move) {
    if (move->cycle != nc::CycleForm::none) return rewriter_.are_none(*move, *corrected_hole(*move).at);
    if (!is_corrected(*move)) return true;
    Move part = reader_.move(*move, move->motions.front());
    reader_.divide(part);
    return rewriter_.stays(corrected(part));
  });
}

CorrectedHole Pipeline::corrected_hole(const nc::Step& step) {
  const nc::Motion& down = HoleCorrector::way_down(step);
  refuse_unknown(step, reader_.unknown(step, down.known_before & down.known_after));
  const CorrectedHole hole = holes_.correct(reader_.move(step, down), step.holes.front(), rewriter_.standing(step));
  refuse_violations(hole.at->violations, step);
  return hole;
}

void Pipeline::take_hole(const nc::Step& step) {
  const CorrectedHole hole = corrected_hole(step);
  holes_.check(hole);
  const AxisWords shift = hole.shift;
  const std::uint64_t begin = rewriter_.written_bytes();
  tally_.take_hole(hole, rewriter_.write_hole(step, shift));
  if (recorded_) record_shifted(*recorded_, reader_, step, shift, begin, rewriter_.written_bytes());
  tally_.take_cycle(step);
}

Summary Pipeline::summary() {
  const BetweenPoints& played = play_.finish();
  if (recorded_) recorded_->finish();
  Summary summary = tally_.summary();
  summary.residual_mm = played.tip_mm();
  summary.residual_deg = played.turned_deg();
  summary.replayed = played.plays();
  summary.assumed_at_zero = reader_.at_zero();
  rewriter_.describe(summary);
  return summary;
}

}  // namespace plumbline::compensate
