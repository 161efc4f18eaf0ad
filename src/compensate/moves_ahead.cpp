#include "compensate/moves_ahead.hpp"

#include <optional>

#include "base/diagnostic.hpp"
#include "path/figures.hpp"

namespace plumbline::compensate {

MovesAhead::MovesAhead(const machine::MachineModel& model, const Settings& settings, const nc::Dialect& dialect,
                       const nc::ToolTable& tools, const ReaderSettings& reader)
    : dialect_(dialect), reader_(reader), corrector_(model, settings), spindle_(tools, reader.reference_tool_mass) {}

void MovesAhead::look(const nc::KeptSteps& steps, std::size_t place) {
  PointsAhead& points = points_[place];
  points.number = ++looks_;
  points.tools = tools_;
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
    if (!next_tool) add(step, points.targets);
  }
  corrector_.correct(points.targets, points.corrections);
  if (next_tool) corrector_.set_tool(*next_tool);
}

void MovesAhead::add(const nc::Step& step, std::vector<Target>& targets) const {
  if (step.motions.size() != 1 || step.cycle != nc::CycleForm::none) return;
  const nc::Motion& motion = step.motions.front();
  if (!path::is_cut(motion.kind) || motion.in_machine_coordinates) return;
  try {
    Move move = move_of(step, motion, dialect_, reader_, at_zero_.load(std::memory_order_relaxed));
    divide(move, reader_.step);
    if (move.pieces > kFewPieces) return;
    for (int i = 1; i <= move.pieces; ++i) targets.push_back(move.path.target(move.fraction(i), move.seconds));
  } catch (const Refusal&) {  // for who comes to that move
  }
}

}  // namespace plumbline::compensate
