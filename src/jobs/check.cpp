#include "jobs/check.hpp"

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "compensate/corrector.hpp"
#include "compensate/hole_corrector.hpp"
#include "compensate/limits.hpp"
#include "compensate/move_corrector.hpp"
#include "compensate/move_reader.hpp"
#include "jobs/compensate/compensate_file.hpp"
#include "jobs/program/open_program.hpp"
#include "jobs/program/survey_program.hpp"
#include "machine/model_file.hpp"
#include "nc/rewrite/arc_words.hpp"

namespace plumbline::jobs {
namespace {

class Checker {
 public:
  Checker(const nc::Dialect& dialect, const machine::MachineModel& model, const compensate::Settings& settings,
          nc::EmitSettings emit, compensate::PathRecord* record)
      : dialect_(dialect),
        emit_(std::move(emit)),
        words_(dialect, emit_),
        corrector_(model, settings),
        touch_off_error_(compensate::touch_off_error(corrector_, model.limits, settings)),
        moves_(corrector_, model.limits, compensate::MoveCorrector::AtViolation::go_on, settings.bound),
        holes_(dialect, corrector_, model.limits, settings, moves_),
        by_bound_(settings.bound.is_asked()),
        record_(record) {}

  const AxisWords& touch_off_error() const { return touch_off_error_; }
  void set_tool(const compensate::ToolInSpindle& tool, int number) {
    corrector_.set_tool(tool);
    if (record_ != nullptr) record_->set_tool(tool, number);
  }

  void look_at(const compensate::Move& move, const compensate::PassedMoves& passed) {
    const nc::Block& block = *move.step->block;
    if (block.line != line_ || block.file != file_) end_block();
    line_ = block.line;
    file_ = block.file;
    const nc::Hole* const hole = hole_of(move);
    auto points = static_cast<std::size_t>(move.pieces);
    if (hole == nullptr) {
      const compensate::CorrectedMove& corrected =
          moves_.correct(move, {}, {{}, nc::arc_form(dialect_, words_, *move.step, {})});
      if (by_bound_ && !move.is_rapid()) points = corrected.points.size();
      compensate::keep_worst(of_block_, corrected.violations);
      if (record_ != nullptr) record(corrected);
    } else if (move.motion == &move.step->motions[hole->begin]) {
      compensate::keep_worst(of_block_, holes_.correct(move, *hole, {}).at->violations);
    }
    for (const machine::Violation& violation : of_block_) {
      const Place* const left = passed.left(violation, *move.step);
      if (left != nullptr) left_by_.try_emplace(violation.what, *left);
    }
    summary_.points += points;
  }

  CheckSummary take() {
    end_block();
    return std::move(summary_);
  }

 private:
  // The hole of a cycle that works the spindle, which is shifted as a whole.
  static const nc::Hole* hole_of(const compensate::Move& move) {
    if (move.step->cycle != nc::CycleForm::spindle) return nullptr;
    const auto motion = static_cast<std::size_t>(move.motion - move.step->motions.data());
    for (const nc::Hole& hole : move.step->holes) {
      if (motion >= hole.begin && motion < hole.end) return &hole;
    }
    return nullptr;
  }

  void record(const compensate::CorrectedMove& corrected) {
    const compensate::Move& move = corrected.move;
    double fraction = 0;
    for (std::size_t i = 0; i < corrected.points.size(); ++i) {
      fraction = move.is_rapid() || i + 1 == corrected.points.size() ? 1 : fraction + corrected.points[i].share;
      compensate::RecordedPoint point = compensate::recorded_point(move.path, compensate::way_kind(move.motion->kind),
                                                                   fraction, move.seconds, begin_s_);
      point.commanded = corrected.commanded(i);
      if (move.seconds) point.piece_s = corrected.points[i].share * *move.seconds;
      record_->add(std::move(point), {move.step->block->text, {}, move.step->block->file});
    }
    begin_s_ += move.seconds.value_or(0);
  }

  void end_block() {
    for (const machine::Violation& violation : of_block_) {
      ++summary_.violations;
      ++summary_.kinds[violation.what];
      if (summary_.findings.size() >= CheckSummary::kMostFindings) continue;
      const Place& left = left_by_[violation.what];
      summary_.findings.push_back({file_, line_, violation, left.line, left.file == file_ ? "" : left.file});
    }
    of_block_.clear();
    left_by_.clear();
  }

  const nc::Dialect& dialect_;
  nc::EmitSettings emit_;
  nc::WordGrid words_;
  compensate::Corrector corrector_;
  AxisWords touch_off_error_;
  compensate::MoveCorrector moves_;
  compensate::HoleCorrector holes_;
  bool by_bound_;
  compensate::PathRecord* record_;
  double begin_s_ = 0;  // of the move, where a path is recorded
  CheckSummary summary_;
  std::string file_;
  std::size_t line_ = 0;
  std::vector<machine::Violation> of_block_;
  std::map<std::string, Place> left_by_;  // the block that left the axis of a violation there
};

}  // namespace

CheckSummary check_file(const Source& program, const settings::Options& options, const Progress& progress,
                        ProgramPicture* picture) {
  const machine::MachineModel model = machine::read_model(options.paths.model);
  const OpenedProgram opened = open_program(options, program, model);
  const auto& [source, dialect, settings] = opened;
  const compensate::Settings compensation = compensation_settings(model.control, dialect, options);

  const compensate::ProgramSurvey survey = survey_program(opened);
  std::optional<compensate::PathRecord> record;
  if (picture != nullptr) record.emplace(model, compensation);
  Checker checker(dialect, model, compensation, emit_settings(model.control, dialect, options),
                  record ? &*record : nullptr);
  compensate::MoveReader reader(
      source, dialect, settings,
      {survey.named, compensate::divided_by(compensation), model.reference_tool_mass, checker.touch_off_error()});
  ExpectedAlong along(model, compensation, true);
  std::uint64_t passed = 0;
  while (const compensate::Move* const move = reader.next_move(progress)) {
    if (record && std::exchange(passed, reader.passed_moves()) != reader.passed_moves()) record->leave();
    if (const auto tool = reader.new_tool()) {
      checker.set_tool(*tool, move->step->after->tool_in_spindle);
      along.samples().set_tool(*tool);
    }
    checker.look_at(*move, reader.passed());
    if (along.asks() && !move->is_rapid()) along.samples().add(*move, static_cast<std::size_t>(move->pieces));
  }
  CheckSummary summary = checker.take();
  summary.blocks = reader.blocks();
  summary.passed_moves = reader.passed_moves();
  if (record) *picture = {model, compensate::drawn_path(*record, model, compensation), {}};
  summary.expected = along.take(picture != nullptr ? &picture->path : nullptr);
  if (picture != nullptr) picture->doubts = std::move(summary.expected.drawn);
  if (summary.violations == 0) summary.refusal = refusal_of_writing(opened, survey, model, options);
  // Its output may be looked at, too.
  if (summary.refusal && summary.refusal->code == "compensate-stamped") summary.refusal.reset();
  return summary;
}

}  // namespace plumbline::jobs
