#include "jobs/check.hpp"

#include <algorithm>

#include "compensate/corrector.hpp"
#include "compensate/guard.hpp"
#include "jobs/open_program.hpp"
#include "jobs/path_walk.hpp"
#include "machine/model_file.hpp"

namespace plumbline::jobs {
namespace {

class Checker {
 public:
  Checker(const machine::MachineModel& model, const compensate::Settings& settings)
      : model_(model),
        settings_(settings),
        corrector_(model, settings),
        touch_off_error_(compensate::touch_off_error(corrector_, settings)) {}

  void attach(PathWalk& walk) {
    walk_ = &walk;
    walk.on_tool = [this](const compensate::ToolInSpindle& tool) { corrector_.set_tool(tool); };
    walk.on_fixed_axes = [this](AxisSet axes) { corrector_.fix_axes(axes); };
    walk.on_point = [this](const PathPoint& point) { look_at(point); };
  }

  CheckSummary take() {
    end_block();
    return std::move(summary_);
  }

 private:
  void look_at(const PathPoint& point) {
    ++summary_.points;
    const nc::Block& block = *point.step->block;
    if (block.line != line_ || block.file != file_) end_block();
    line_ = block.line;
    file_ = block.file;
    if (const nc::Hole* const hole = hole_of(point)) return look_at_hole(point, *hole);
    if (point.on_way) return;
    compensate::Target target = touched_off(point.target);
    if (!point.way_from) {
      look_at(target);
      return;
    }
    const compensate::Target from = touched_off(*point.way_from);
    target.slope = target.pose - from.pose;
    const std::optional<AxisWords> commanded = look_at(target);
    if (commanded) note(compensate::check_way(corrector_, model_.limits, from, target, *commanded));
  }

  compensate::Target touched_off(compensate::Target target) const {
    target.pose += touch_off_error_;
    return target;
  }

  // What the control is to be told, if it can be.
  std::optional<AxisWords> look_at(const compensate::Target& target) {
    const compensate::Command command = compensate::command(corrector_, model_.limits, target);
    note(command.violations);
    if (command.corrected.converged) return command.corrected.pose;
    note({{"reach", 0, 0, 0, ""}});
    return std::nullopt;
  }

  // The hole of a cycle that works the spindle, which is shifted as a whole.
  static const nc::Hole* hole_of(const PathPoint& point) {
    if (point.step->cycle != nc::CycleForm::spindle) return nullptr;
    const auto motion = static_cast<std::size_t>(point.motion - point.step->motions.data());
    for (const nc::Hole& hole : point.step->holes) {
      if (motion >= hole.begin && motion < hole.end) return &hole;
    }
    return nullptr;
  }

  void look_at_hole(const PathPoint& point, const nc::Hole& hole) {
    if (point.motion != &point.step->motions[hole.begin] || point.target.pose != end_of(point)) return;
    for (const AxisWords& words :
         compensate::hole_places(*point.step, hole, point.motion->to, settings_.step.length_mm)) {
      look_at(touched_off(walk_->target(*point.step, words)));
    }
  }
  AxisWords end_of(const PathPoint& point) const { return walk_->target(*point.step, point.motion->to).pose; }

  void note(const std::vector<machine::Violation>& violations) {
    for (const machine::Violation& violation : violations) {
      const auto same = std::find_if(of_block_.begin(), of_block_.end(),
                                     [&](const machine::Violation& v) { return v.what == violation.what; });
      if (same == of_block_.end()) {
        of_block_.push_back(violation);
      } else if (violation.by_how_much > same->by_how_much) {
        *same = violation;
      }
    }
  }

  void end_block() {
    for (const machine::Violation& violation : of_block_) {
      ++summary_.violations;
      ++summary_.kinds[violation.what];
      if (summary_.findings.size() < CheckSummary::kMostFindings)
        summary_.findings.push_back({file_, line_, violation});
    }
    of_block_.clear();
  }

  const machine::MachineModel& model_;
  const compensate::Settings& settings_;
  compensate::Corrector corrector_;
  AxisWords touch_off_error_;
  const PathWalk* walk_ = nullptr;
  CheckSummary summary_;
  std::string file_;
  std::size_t line_ = 0;
  std::vector<machine::Violation> of_block_;
};

}  // namespace

CheckSummary check_file(const std::string& program, const settings::Options& options, const Progress& progress) {
  const machine::MachineModel model = machine::read_model(options.paths.model);
  const auto [source, dialect, settings] = open_program(options, program, model);
  compensate::Settings compensation = options.compensation;
  compensation.step.least_time_s = model.control.block_time;

  PathWalk walk(source, dialect, settings, model, compensation.step);
  Checker checker(model, compensation);
  checker.attach(walk);
  walk.run(progress);
  CheckSummary summary = checker.take();
  summary.blocks = walk.blocks();
  summary.passed_moves = walk.passed_moves();
  return summary;
}

}  // namespace plumbline::jobs
