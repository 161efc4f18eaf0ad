// What the steps of a program mean to the machine: the tool that is in the spindle, and poses where some axes are not
// known.
#pragma once

#include <functional>
#include <optional>

#include "base/axes.hpp"
#include "base/files.hpp"
#include "compensate/corrector.hpp"
#include "nc/sequence/program.hpp"
#include "path/curve.hpp"

namespace plumbline::compensate {

/// Length (G43) and load (M6) of the tool.
class SpindleTool {
 public:
  /// `tools` must outlive it. `reference_mass`: of a tool whose mass nobody gave, kg.
  SpindleTool(const nc::ToolTable& tools, double reference_mass) : tools_(tools), reference_mass_(reference_mass) {}

  /// The tool, where the step brings another one; the first step always does.
  std::optional<ToolInSpindle> change(const nc::Step& step);
  /// False where the table does not give the mass of the tool that is in the spindle.
  bool has_mass() const { return has_mass_; }

 private:
  const nc::ToolTable& tools_;
  double reference_mass_;
  std::optional<AxisWords> offset_;
  int number_ = -1;
  bool has_mass_ = true;
};

/// Poses of a program. Rotary axes that none of its words names are taken to stand at zero.
class ProgramPose {
 public:
  /// Both must outlive it.
  ProgramPose(const InputFile& source, const nc::Dialect& dialect) : source_(source), dialect_(dialect) {}

  std::function<void(AxisSet)> on_fixed;  // told where fixed() becomes another set

  /// A step of the program, before anything is asked of it.
  void take(const nc::Step& step);
  /// Those of `unknown` that are taken to stand at zero: not where the work offset turns them. Looks for them when a
  /// rotary axis is first asked for.
  AxisSet assumed(const nc::Step& step, AxisSet unknown);
  /// All of them, as far as they were looked for.
  AxisSet assumed() const { return assumed_.value_or(AxisSet{}); }
  /// Axes that no correction may write: those that are taken to stand at zero, and on a tilted plane all rotary ones.
  AxisSet fixed() const { return assumed() | (tilted_ ? AxisSet::rotary() : AxisSet{}); }
  bool tilted() const { return tilted_; }
  /// A point of a move, in the work system of the step.
  Target target(const nc::Step& step, const path::CurvePoint& point, std::optional<double> seconds) const;

 private:
  const InputFile& source_;
  const nc::Dialect& dialect_;
  std::optional<AxisSet> assumed_;
  bool tilted_ = false;
};

}  // namespace plumbline::compensate
