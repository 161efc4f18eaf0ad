#include "compensate/recorded/path_samples.hpp"

#include <algorithm>

#include "compensate/recorded/path_record.hpp"

namespace plumbline::compensate {

void PathSamples::add(const Move& move, std::size_t pieces) {
  const std::size_t parts = std::clamp<std::size_t>(pieces, 1, kMostOfMove);
  for (std::size_t i = points_.count() == 0 ? 0 : 1; i <= parts; ++i) {
    const double fraction = static_cast<double>(i) / static_cast<double>(parts);
    const AxisWords pose = move.path.pose(fraction);
    Decimated<PathSample, 6>::Figures figures{};
    for (const Axis axis : kAllAxes) figures[index(axis)] = pose[axis];
    points_.add(figures, [&] {
      const RecordedPoint point =
          recorded_point(move.path, way_kind(move.motion->kind), fraction, move.seconds, time_s_);
      return PathSample{point.line, std::string(move.path.file), point.time_s, point.asked, tool_};
    });
  }
  time_s_ += move.seconds.value_or(0);
}

void PathSamples::restart() {
  points_.clear();
  tool_.reset();
  time_s_ = 0;
}

}  // namespace plumbline::compensate
