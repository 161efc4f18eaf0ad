// What stands in the brackets of a drilling cycle that is called by name.
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "nc/control/execution.hpp"
#include "nc/language/codes.hpp"

namespace plumbline::nc {

enum CalledCycle {
  kCalledDrill = 81,
  kCalledDrillDwell,
  kCalledDeep,
  kCalledTap,
  kCalledReam,
  kCalledBore,
  kCalledBoreStop,
  kCalledBoreByHand,
  kCalledBoreDwell,
  kCalledFloatingTap = 840
};

/// Places in the brackets [C 2.1.2 to 2.1.11; the order is that of the posts, too].
constexpr int kRetractPlane = 0, kReferencePlane = 1, kSafety = 2, kDepth = 3, kRelativeDepth = 4, kDwell = 5;
constexpr int kFeedDown = 6, kFeedUp = 7;  // of CYCLE85

/// What else stands there; -1: nothing of the kind.
struct Places {
  int code;
  int last;            // beyond it no source says what stands there
  int geometry;        // 1: the depth is that of the diameter
  int plane;           // its last digit other than 0: a plane of its own
  int how;             // its last digit 1: the depth is relative; 2: absolute
  int axis;            // of the tool
  bool keeps = false;  // stays a cycle, shifted: the pecks, the spindle or feeds of its own are its business
};
Places places_of(const CycleCall& call);

inline int last_digit(double value) { return static_cast<int>(std::abs(std::lround(value)) % 10); }

class CalledValues {
 public:
  CalledValues(const Execution& run, const CycleCall& call) : run_(run), call_(call) {}

  [[noreturn]] void refuse(const std::string& message, std::string help) const {
    run_.refuse(codes::kNotInterpreted, call_.row->name + ": " + message, std::move(help));
  }
  /// Nothing: the place is empty, or -1.
  std::optional<double> value(int place) const {
    if (place < 0 || static_cast<std::size_t>(place) >= call_.arguments.size()) return std::nullopt;
    return call_.arguments[static_cast<std::size_t>(place)].value;
  }
  double number(int place) const { return value(place).value_or(0); }
  double length_mm(int place) const { return number(place) * run_.control.length_unit(); }
  /// Where the place is empty or 0: `otherwise`.
  double length_mm(int place, double otherwise) const { return number(place) > 0 ? length_mm(place) : otherwise; }

 private:
  const Execution& run_;
  const CycleCall& call_;
};

/// mm; 0: no such thread. Of those that MPIT names by their diameter: M3 to M48, coarse [C 2.1.5; ISO 261].
double pitch_of_thread(double diameter);

/// CYCLE83: how deep its first stroke goes below the reference plane (FDEP or FDPR), mm. Refuses where neither says so,
/// and where they say different depths.
double first_depth_mm(const CalledValues& given);
/// CYCLE83: it goes back a little after each stroke (VARI 0), else out of the hole (VARI 1) [C 2.1.4].
bool breaks_chips(const CalledValues& given);
/// CYCLE83: by how much the feed of its first peck is less (FRF). Refuses what no source explains.
double first_share(const CalledValues& given);
/// CYCLE83: s, or turns of the spindle where it is negative: DTB, DTS, DTD. `unit`: of the digit of the last value that
/// says which; refuses those that it counts in turns.
double dwell_of_deep_hole(const CalledValues& given, int place, long unit);

}  // namespace plumbline::nc
