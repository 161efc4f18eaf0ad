#include "compensate/moves_ahead.hpp"

#include <optional>

#include "base/diagnostic.hpp"
#include "path/figures.hpp"

namespace plumbline::compensate {

MovesAhead::MovesAhead(const machine::MachineModel& model, const Settings& settings, const nc::Dialect& dialect,
                       const nc::ToolTable& tools, const ReaderSettings& reader, std::string_view program)
    : dialect_(dialect),
      reader_(reader),
      program_(program),
      corrector_(model, settings),
      spindle_(tools, reader.reference_tool_mass) {}

void MovesAhead::look(const nc::KeptSteps& steps, std::size_t place) {
  PointsAhead& points = points_[place];
  points.number = ++looks_;
  points.tools = tools_;
  points.at_zero = at_zero_.load(std::memory_order_relaxed);
  points.moves.clear();
  points.targets.clear();
  std::optional<ToolInSpindle> next_tool;  // the first change behind a point: what comes after it goes one by one
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const nc::Step& step = steps[i].step;
    if (const std::optional<ToolInSpindle> tool = spindle_.change(step)) {
      ++tools_;
      if (points.targets.empty()) {
        corrector_.set_tool(*tool);
        points.tools = tools_;
      } else {
        next_tool = tool;
      }
    }
    if (!next_tool) add(step, points);
  }
  corrector_.correct(points.targets, points.corrections);
  if (next_tool) corrector_.set_tool(*next_tool);
}

void MovesAhead::add(const nc::Step& step, PointsAhead& points) const {
  if (step.motions.size() != 1 || step.cycle != nc::CycleForm::none || step.role != nc::BlockRole::plain) return;
  const nc::Motion& motion = step.motions.front();
  if (!path::is_cut(motion.kind) || motion.in_machine_coordinates) return;
  points.moves.push_back({compensate::move_of(step, motion, dialect_, reader_, points.at_zero), points.targets.size()});
  if (!program_.empty() && step.block->file != program_) points.moves.back().move.path.file = step.block->file;
  Move& move = points.moves.back().move;
  try {
    forget_time_of_no_way(move);
    divide(move, reader_.step);
  } catch (const Refusal&) {  // for who comes to that move
    move.pieces = kFewPieces + 1;
  }
  if (move.pieces > kFewPieces) return points.moves.pop_back();
  for (int i = 1; i <= move.pieces; ++i) points.targets.push_back(move.path.target(move.fraction(i), move.seconds));
}

void MovesAhead::come_to(const nc::Step& step, std::uint64_t handed_over, std::size_t place) {
  if (handed_over == 0) return;
  if (handed_over_ != handed_over) met_ = 0;
  handed_over_ = handed_over;
  place_ = place;
  const std::vector<MoveAhead>& moves = points().moves;
  here_ = met_ < moves.size() && moves[met_].move.step == &step ? &moves[met_++] : nullptr;
}

const MoveAhead* MovesAhead::move_of(const nc::Step& step, AxisSet at_zero) {
  at_zero_.store(at_zero, std::memory_order_relaxed);
  const bool is_it = here_ != nullptr && here_->move.step == &step && points().at_zero == at_zero;
  return is_it ? here_ : nullptr;
}

}  // namespace plumbline::compensate
