#include "jobs/check.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "compensate/corrector.hpp"
#include "compensate/guard.hpp"
#include "jobs/path_walk.hpp"
#include "jobs/program_dialect.hpp"
#include "jobs/text_table.hpp"
#include "machine/model_file.hpp"

namespace plumbline::jobs {
namespace {

constexpr std::size_t kFindingsShown = 20;
using Json = nlohmann::ordered_json;

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

std::string message_of(const machine::Violation& violation) {
  return violation.what == "reach" ? "no command puts the tool there" : machine::to_text(violation);
}

}  // namespace

CheckSummary check_file(const std::string& program, const Options& options, const Progress& progress) {
  const machine::MachineModel model = machine::read_model(options.model);
  const nc::ProgramSettings settings = program_settings(options, model);
  const InputFile source(program);
  const nc::Dialect& dialect = dialect_of(options, source);
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

std::string check_text(const CheckSummary& summary) {
  std::string text;
  const std::size_t shown = std::min(kFindingsShown, summary.findings.size());
  for (std::size_t i = 0; i < shown; ++i) {
    const CheckFinding& finding = summary.findings[i];
    text += fmt::format("{}:{}: {}\n", finding.file, finding.line, message_of(finding.violation));
  }
  if (summary.violations > shown) text += fmt::format("and {} more\n", count_text(summary.violations - shown));
  TextTable table;
  table.add("blocks", fmt::format("{}, {} looked at", count_text(summary.blocks), count_text(summary.points, "point")));
  if (summary.passed_moves > 0) {
    table.add("not looked at", fmt::format("{}: machine coordinates, probing, or from where nobody knows",
                                           count_text(summary.passed_moves, "move")));
  }
  if (summary.violations == 0) table.add("limits", "all kept");
  for (const auto& [kind, count] : summary.kinds) {
    table.add(kind, fmt::format("beyond its limit in {}", count_text(count, "block")));
  }
  return text + table.text();
}

std::string check_json(const CheckSummary& summary) {
  Json findings = Json::array();
  for (const CheckFinding& f : summary.findings) {
    findings.push_back({{"file", f.file},
                        {"line", f.line},
                        {"what", f.violation.what},
                        {"value", f.violation.value},
                        {"limit", f.violation.limit},
                        {"by_how_much", f.violation.by_how_much},
                        {"unit", f.violation.unit},
                        {"message", message_of(f.violation)}});
  }
  Json kinds = Json::object();
  for (const auto& [kind, count] : summary.kinds) kinds[kind] = count;
  const Json json{{"plumbline", "check 1"},
                  {"blocks", summary.blocks},
                  {"points", summary.points},
                  {"passed_moves", summary.passed_moves},
                  {"violations", summary.violations},
                  {"blocks_by_kind", kinds},
                  {"findings", findings}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace plumbline::jobs
