// The machine's limits: which of them a move breaks, refused by block, axis or strut, and by how much.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.hpp"
#include "compensate/corrector.hpp"
#include "machine/limits.hpp"
#include "nc/control/step.hpp"

namespace plumbline::compensate {

/// The place of the block of a step, the whole of it underlined.
Place place_of(const nc::Step& step);

/// The kind of violation that no command puts the tool there, which no limit says.
inline constexpr std::string_view kOutOfReach = "reach";

/// What a target comes to: where the control is to be sent for it, and each limit that the programmed pose or the
/// commanded one breaks. Not converged: no command puts the tool there.
struct Command {
  Corrected corrected;
  std::vector<machine::Violation> violations;
};
Command command(const Corrector& corrector, const machine::Limits& limits, const Target& target);
/// The same of a target that was corrected before.
Command command(const Corrector& corrector, const machine::Limits& limits, const Target& target,
                const Corrected& corrected);

/// A rapid goes to the command of its end as the control likes: the limits broken along the straight line there from
/// the command of its start, every 10 mm or 1 deg, its ends left out.
std::vector<machine::Violation> check_way(const Corrector& corrector, const machine::Limits& limits, const Target& from,
                                          const Target& to, const AxisWords& commanded_to);

/// Into how many steps the straight line by `delta` (mm and deg) is cut for that.
int chord_steps(const AxisWords& delta);

/// A violation as a diagnostic at a block; code limit-tilt, limit-travel, limit-strut or limit-condition.
Diagnostic diagnose(const machine::Violation& violation, const Place& place);

/// The worst of each kind.
void keep_worst(std::vector<machine::Violation>& kept, const std::vector<machine::Violation>& more);

/// The blocks that go through as they stand (G53, G28, G30), and where they leave an axis: no limit is looked at there,
/// but the next that moves the axis, or leaves it alone, goes on from it.
class PassedMoves {
 public:
  /// Every block, in their order.
  void take(const nc::Step& step);
  /// The block that left the axis of a violation ("Z") where it is broken; null where `step`, which breaks it, takes
  /// the axis there itself.
  const Place* left(const machine::Violation& violation, const nc::Step& step) const;

 private:
  std::map<std::string, Place> left_;  // by the letter of the axis
  AxisSet moved_;                      // by the last block
};

/// Throws the first violation, if there is any; kOutOfReach as compensate-unreachable. Where a block of `passed` left
/// the axis beyond its limit, that is the place.
void refuse_violations(const std::vector<machine::Violation>& violations, const nc::Step& step,
                       const PassedMoves& passed = {});

}  // namespace plumbline::compensate
