// The points of a path that a picture of it is drawn from: few of many, none of its extremes lost.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "compensate/loaded_machine.hpp"
#include "compensate/move.hpp"
#include "compensate/recorded/decimated.hpp"
#include "nc/control/state/motion.hpp"

namespace plumbline::compensate {

enum class WayKind : std::uint8_t {
  gap,  // from the point before it nobody knows how the machine went
  rapid,
  line,
  arc,
};

/// Of a motion that goes somewhere.
constexpr WayKind way_kind(nc::MotionKind kind) {
  if (kind == nc::MotionKind::rapid) return WayKind::rapid;
  return kind == nc::MotionKind::arc ? WayKind::arc : WayKind::line;
}

/// The end of a way, or a point on it.
struct RecordedPoint {
  WayKind kind = WayKind::line;
  std::size_t line = 0;
  int tool = -1;                                 // in the spindle; -1: not known
  std::optional<ToolInSpindle> in_spindle;       // nothing: none came into it, the model has its own
  double time_s = 0;                             // of cuts, since the start
  std::optional<double> piece_s;                 // that the block of the output takes, whose end or part this is
  std::optional<double> mm_s;                    // speed of the tip
  Target asked;                                  // by the original, in W
  AxisWords commanded;                           // in W
  std::string text;                              // of its block
  std::string file;                              // that it stands in
  std::string after;                             // of what replaced it, at most kMostText characters
  std::uint64_t after_begin = 0, after_end = 0;  // its bytes in the output; equal: it was left as it stands
};

inline constexpr std::size_t kMostText = 160;

/// A point of a path that takes `seconds` (of a rapid nothing is known) and begins `begin_s` after the start; what the
/// machine is told there is for the caller to say.
RecordedPoint recorded_point(const MovePath& path, WayKind kind, double fraction, std::optional<double> seconds,
                             double begin_s);

/// How far the strut that is nearest to a limit is from it, m; negative beyond it.
double least_room(const machine::Limits& limits, const machine::PerStrut<double>& lengths);

/// Takes every point of a path and keeps those that show it: of each stretch the first and those where the place, the
/// orientation, the correction, the speed, the time of a block, the nearest limit of a strut or a strut's tension is at
/// an extreme.
class PathRecord {
 public:
  /// Model and settings must outlive it.
  PathRecord(const machine::MachineModel& model, const Settings& settings)
      : model_(&model), settings_(&settings), machine_(std::in_place, model, settings), points_(kStretches, kWhole) {}
  /// Of a machine that nobody knows: its struts are left out.
  PathRecord() : points_(kStretches, kWhole) {}

  /// `number` of the tool; -1: not known.
  void set_tool(const ToolInSpindle& tool, int number);
  struct Texts {
    std::string_view before, after, file;
  };
  void add(RecordedPoint point, const Texts& texts);
  /// Nobody knows how the machine comes to the next point.
  void leave() { gap_ = true; }
  bool has_left() const { return gap_; }
  void restart();

  bool has_machine() const { return machine_.has_value(); }
  std::uint64_t count() const { return points_.count() + waiting_.size(); }
  std::vector<RecordedPoint> take();

 private:
  static constexpr std::size_t kStretches = 400;
  static constexpr std::size_t kWhole = 4096;  // points of a program that is drawn whole
  static constexpr std::size_t kFigures = 13;
  static constexpr std::size_t kWaiting = 256;

  struct Load {                                              // at what the machine is told
    double room = std::numeric_limits<double>::quiet_NaN();  // of the strut that is nearest to a limit, m
    double least_tension = std::numeric_limits<double>::quiet_NaN();
    double largest_tension = std::numeric_limits<double>::quiet_NaN();
  };
  // A point whose loads are yet to be computed, with others; its texts are parts of texts_.
  struct Waiting {
    RecordedPoint point;
    std::size_t before = 0, after = 0, file = 0, end = 0;
  };
  Load load_of(std::size_t waiting) const;
  using Points = Decimated<RecordedPoint, kFigures>;
  static Points::Figures figures_of(const RecordedPoint& point, const Load& load);
  RecordedPoint kept(Waiting& waiting) const;
  void settle();

  const machine::MachineModel* model_ = nullptr;
  const Settings* settings_ = nullptr;
  std::optional<LoadedMachine> machine_;
  std::optional<ToolInSpindle> tool_;
  int number_ = -1;
  bool gap_ = true;
  std::vector<Waiting> waiting_;
  std::string texts_;
  exact::PoseBatch batch_;                // of what waits
  std::vector<Points::Figures> figures_;  // the same
  Points points_;
};

}  // namespace plumbline::compensate
