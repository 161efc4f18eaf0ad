#include "compensate/limits.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "path/figures.hpp"

namespace plumbline::compensate {
namespace {

constexpr double kChordStepMm = 10;
constexpr double kChordStepDeg = 1;

void append(std::vector<machine::Violation>& all, std::vector<machine::Violation> more) {
  all.insert(all.end(), more.begin(), more.end());
}

struct Kind {
  std::string_view code;
  std::string_view help;
};

Kind kind_of(const machine::Violation& violation) {
  if (violation.what == "tilt") {
    return {"limit-tilt", "re-post the program with less tilt, or correct [limits] tilt_deg of the model"};
  }
  if (violation.what == "condition") {
    return {"limit-condition", "stay away from this pose: the machine is near a singularity and hardly stiff there"};
  }
  if (violation.what.starts_with("strut")) {
    return {"limit-strut",
            "move the part (work offset) or the pose into the workspace; check length_min/max of the model"};
  }
  return {"limit-travel", "check the work offset (--work-offset), or move the part into the workspace"};
}

}  // namespace

Place place_of(const nc::Step& step) {
  const nc::Block& block = *step.block;
  Place place;
  place.file = block.file;
  place.line = block.line;
  place.text = block.text;
  place.column = std::min(block.text.find_first_not_of(" \t"), block.text.size() - 1) + 1;
  place.length = block.text.size();
  return place;
}

int chord_steps(const AxisWords& delta) {
  const double steps = std::max(length_mm(delta) / kChordStepMm, path::largest_turn_deg(delta) / kChordStepDeg);
  return std::max(1, static_cast<int>(std::ceil(steps)));
}

Command command(const Corrector& corrector, const machine::Limits& limits, const Target& target) {
  return command(corrector, limits, target, corrector.correct(target));
}

Command command(const Corrector& corrector, const machine::Limits& limits, const Target& target,
                const Corrected& corrected) {
  Command command{corrected, {}};
  if (corrected.converged && corrected.within_limits) return command;
  command.violations = machine::check_programmed(limits, corrector.pose_of(target.pose));
  if (!corrected.converged) return command;
  append(command.violations,
         machine::check_compensated(limits, corrector.geometry(), corrector.pose_of(command.corrected.pose)));
  return command;
}

std::vector<machine::Violation> check_way(const Corrector& corrector, const machine::Limits& limits, const Target& from,
                                          const Target& to, const AxisWords& commanded_to) {
  std::vector<machine::Violation> broken;
  const int count = chord_steps(to.pose - from.pose);
  if (count == 1) return broken;
  const Corrected start = corrector.correct({from.pose, {}, {}, std::nullopt, from.fixed});
  const AxisWords& commanded_from = start.converged ? start.pose : from.pose;
  for (int i = 1; i < count; ++i) {
    const double fraction = static_cast<double>(i) / count;
    append(broken, machine::check_programmed(limits, corrector.pose_of(path::between(from.pose, to.pose, fraction))));
    append(broken,
           machine::check_compensated(limits, corrector.geometry(),
                                      corrector.pose_of(path::between(commanded_from, commanded_to, fraction))));
  }
  return broken;
}

Diagnostic diagnose(const machine::Violation& violation, const Place& place) {
  const Kind kind = kind_of(violation);
  return {std::string(kind.code), machine::to_text(violation), std::string(kind.help), place, Severity::error};
}

void keep_worst(std::vector<machine::Violation>& kept, const std::vector<machine::Violation>& more) {
  for (const machine::Violation& violation : more) {
    const auto same = std::find_if(kept.begin(), kept.end(),
                                   [&](const machine::Violation& known) { return known.what == violation.what; });
    if (same == kept.end()) {
      kept.push_back(violation);
    } else if (violation.by_how_much > same->by_how_much) {
      *same = violation;
    }
  }
}

void PassedMoves::take(const nc::Step& step) {
  const bool passes = std::any_of(step.motions.begin(), step.motions.end(),
                                  [](const nc::Motion& motion) { return motion.in_machine_coordinates; });
  if (!passes && left_.empty()) return;
  const auto moves = [&](Axis axis) {
    return std::any_of(step.motions.begin(), step.motions.end(),
                       [&](const nc::Motion& motion) { return motion.from[axis] != motion.to[axis]; });
  };
  for (const Axis axis : kAllAxes) {
    const std::string name(1, letter(axis));
    if (moved_.contains(axis)) left_.erase(name);
    if (passes && moves(axis)) left_[name] = place_of(step);
  }
  moved_ = passes ? AxisSet{} : step.named;
}

const Place* PassedMoves::left(const machine::Violation& violation, const nc::Step& step) const {
  const auto found = left_.find(violation.what);
  if (found == left_.end() || step.motions.empty()) return nullptr;
  const std::optional<Axis> axis = axis_of(violation.what.front());
  const double end = step.frame->to_pose(step.motions.back().to)[*axis];
  const bool ends_beyond = violation.value > violation.limit ? end > violation.limit : end < violation.limit;
  return step.named.contains(*axis) && ends_beyond ? nullptr : &found->second;
}

void refuse_violations(const std::vector<machine::Violation>& violations, const nc::Step& step,
                       const PassedMoves& passed) {
  if (violations.empty()) return;
  if (violations.front().what == kOutOfReach) {
    refuse("compensate-unreachable", "the machine cannot be made to stand here: no strut lengths put the tool there",
           "move the part away from the edge of the workspace; with --dynamic, leave that out or lower the feed rate: "
           "drives that lag apart may put the tool further off than can surely be corrected",
           place_of(step));
  }
  const machine::Violation& worst = violations.front();
  Diagnostic refused = diagnose(worst, place_of(step));
  if (const Place* const left = passed.left(worst, step)) {
    const std::string file = left->file == refused.place.file ? "" : " of " + refused.place.file;
    refused.message += fmt::format(", where this block leaves it and line {}{} goes on", refused.place.line, file);
    refused.help = fmt::format(
        "move {} back to where the machine can be corrected first, as with G0 {}.. alone, or check "
        "--work-offset and [limits] of the model",
        worst.what, worst.what);
    refused.place = *left;
  }
  throw Refusal(std::move(refused));
}

}  // namespace plumbline::compensate
