#include "jobs/simulate.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/parallel.hpp"
#include "base/units.hpp"
#include "compensate/limits.hpp"
#include "compensate/loaded_machine.hpp"
#include "compensate/move_reader.hpp"
#include "jobs/program/open_program.hpp"
#include "machine/inverse.hpp"
#include "machine/limits.hpp"
#include "machine/model_file.hpp"

namespace plumbline::jobs {
namespace {

using Take = std::function<void(const SimulatedPoint&)>;

constexpr std::size_t kWaiting = 512;
constexpr double kLeastTime = 1e-9;  // s, that a point counts for

class Player {
 public:
  /// `record` and `known` may be null.
  Player(const machine::MachineModel& model, const compensate::Settings& settings, const Take& take,
         compensate::PathRecord* record, const identify::Posterior* known)
      : machine_(model, settings),
        limits_(model.limits),
        take_(take),
        record_(record),
        settings_(settings),
        known_(known) {
    if (known_ != nullptr) doubts_.emplace(model, *known_, settings);
  }

  void set_tool(const compensate::ToolInSpindle& tool, int number) {
    settle();
    machine_.set_tool(tool);
    if (doubts_) {
      doubts_->set_tool(tool);
      if (zero_) doubts_->touch_off(*zero_);
    }
    if (record_ != nullptr) record_->set_tool(tool, number);
  }

  /// The ends of its pieces; a rapid stands still at each, since nobody knows how fast it is.
  void play(const compensate::Move& move, double begin_s) {
    const compensate::WayKind way = compensate::way_kind(move.motion->kind);
    const bool moves = !compensate::goes_nowhere(move.path.curve);
    if (path::is_cut(move.motion->kind) && !move.seconds && moves) ++summary_.untimed_moves;
    for (int i = 1; i <= move.pieces; ++i) {
      play(move, compensate::recorded_point(move.path, way, move.fraction(i), move.seconds, begin_s));
    }
  }

  SimulationSummary take() {
    settle();
    if (tally_.any()) summary_.expected = tally_.take(*known_, zero_.value_or(AxisWords{}));
    if (summary_.points > 0) summary_.rms_um = std::sqrt(squares_ / static_cast<double>(summary_.points));
    return summary_;
  }

 private:
  void play(const compensate::Move& move, compensate::RecordedPoint at) {
    const physics::Motion<double> motion = machine_.motion(at.asked);
    const physics::TipError<double> error = machine_.error(motion);
    if (!error.converged()) {
      refuse("simulate-unreachable",
             fmt::format("the machine cannot stand here: {}", physics::to_text(error.stopped_because)),
             "check the work offset (--work-offset) and the pose", compensate::place_of(*move.step));
    }
    SimulatedPoint point{at.line,
                         move.motion->kind,
                         at.time_s,
                         at.asked.pose,
                         error.displacement,
                         machine::strut_lengths<double>(machine_.geometry(), motion.pose),
                         error.loads.nut_tension,
                         error.loads.torque,
                         {}};
    note(point);
    note_limits(motion.pose, *move.step);
    doubts_ ? wait(std::move(point), at.asked) : take_(point);
    if (record_ == nullptr) return;
    at.commanded = at.asked.pose;
    at.piece_s = move.seconds;  // the control runs the block as a whole
    record_->add(std::move(at), {move.step->block->text, {}, move.step->block->file});
  }

  // Points wait until there are enough of them to be looked at on all processors.
  void wait(SimulatedPoint point, const compensate::Target& asked) {
    if (!zero_ && point.motion != nc::MotionKind::rapid) {
      zero_ = settings_.touch_off.value_or(point.pose);
      doubts_->touch_off(*zero_);
    }
    waiting_.push_back(std::move(point));
    asked_.push_back(asked);
    if (waiting_.size() >= kWaiting) settle();
  }

  void settle() {
    for_each_index(waiting_.size(), [&](std::size_t i) { waiting_[i].doubt = doubts_->at(asked_[i]); });
    for (const SimulatedPoint& point : waiting_) {
      take_(point);
      if (point.doubt && point.motion != nc::MotionKind::rapid)
        tally_.add(*point.doubt, {point.line}, std::max(point.time_s - tallied_s_, kLeastTime));
      tallied_s_ = point.time_s;
    }
    waiting_.clear();
    asked_.clear();
  }

  void note_limits(const Pose<double>& pose, const nc::Step& step) {
    const std::vector<machine::Violation> broken = machine::check_compensated(limits_, machine_.geometry(), pose);
    if (broken.empty()) return;
    ++summary_.beyond_travel;
    if (summary_.first_beyond) return;
    summary_.first_beyond =
        Diagnostic{"simulate-beyond-travel", fmt::format("{} here", machine::to_text(broken.front())),
                   "the figures hold for a machine that could go there: check the work offset "
                   "(--work-offset), and [limits] and [strut] of the model",
                   compensate::place_of(step), Severity::warning};
  }

  void note(const SimulatedPoint& point) {
    const double um = point.error.head<3>().norm() / kUm;
    ++summary_.points;
    squares_ += um * um;
    summary_.seconds = point.time_s;
    if (um <= summary_.largest_um) return;
    summary_.largest_um = um;
    summary_.largest_line = point.line;
  }

  compensate::LoadedMachine machine_;
  const machine::Limits& limits_;
  const Take& take_;
  compensate::PathRecord* record_;
  SimulationSummary summary_;
  double squares_ = 0;
  const compensate::Settings& settings_;
  const identify::Posterior* known_;
  std::optional<TipDoubts> doubts_;
  std::optional<AxisWords> zero_;
  std::vector<SimulatedPoint> waiting_;
  std::vector<compensate::Target> asked_;
  ExpectedTally tally_;
  double tallied_s_ = 0;
};

}  // namespace

SimulationSummary simulate_program(const Source& program, const settings::Options& options,
                                   const std::function<void(const SimulatedPoint&)>& take, const Progress& progress,
                                   ProgramPicture* picture, const identify::Posterior* known) {
  const machine::MachineModel model = machine::read_model(options.paths.model);
  const auto [source, dialect, settings] = open_program(options, program, model);

  compensate::MoveReader reader(
      source, dialect, settings,
      {nc::named_axes(source, dialect), options.compensation.step, model.reference_tool_mass, {}, true});
  std::optional<compensate::PathRecord> record;
  if (picture != nullptr) record.emplace(model, options.compensation);
  Player player(model, options.compensation, take, record ? &*record : nullptr, known);
  std::uint64_t passed = 0;
  while (const compensate::Move* const move = reader.next_move(progress)) {
    if (record && std::exchange(passed, reader.passed_moves()) != reader.passed_moves()) record->leave();
    if (const auto tool = reader.new_tool()) player.set_tool(*tool, move->step->after->tool_in_spindle);
    player.play(*move, reader.begin_s());
  }
  SimulationSummary summary = player.take();
  summary.passed_moves = reader.passed_moves();
  if (!record) return summary;
  *picture = {model, compensate::drawn_path(*record, model, options.compensation), {}};
  if (summary.expected)
    picture->doubts = doubts_at(model, *known, options.compensation, summary.expected->zero, picture->path);
  return summary;
}

}  // namespace plumbline::jobs
