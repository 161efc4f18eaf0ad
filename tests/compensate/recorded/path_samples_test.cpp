#include "compensate/recorded/path_samples.hpp"

#include <cmath>

#include <catch2/catch.hpp>

using namespace plumbline;
using namespace plumbline::compensate;

namespace {

nc::Motion line_motion(double from, double to) {
  nc::Motion motion;
  motion.kind = nc::MotionKind::feed;
  motion.from[Axis::X] = from;
  motion.to[Axis::X] = to;
  return motion;
}

void add_line(PathSamples& samples, double from, double to, std::size_t line, std::size_t pieces) {
  const nc::Motion motion = line_motion(from, to);
  compensate::Move move{nullptr, &motion, {path::Curve(motion), {}, {}, {}, {}, line}};
  move.seconds = 1;
  samples.add(move, pieces);
}

}  // namespace

TEST_CASE("of few moves all ends of pieces are kept, with their times and the tool") {
  PathSamples samples;
  add_line(samples, 0, 8, 1, 4);
  samples.set_tool({100, 2, 0});
  add_line(samples, 8, 10, 2, 1);
  const std::vector<PathSample> kept = samples.take();
  REQUIRE(kept.size() == 6);
  CHECK(kept[0].target.pose[Axis::X] == 0);
  CHECK(kept[1].target.pose[Axis::X] == 2);
  CHECK(kept[1].time_s == Approx(0.25));
  CHECK_FALSE(kept[4].in_spindle);
  CHECK(kept[5].line == 2);
  CHECK(kept[5].time_s == Approx(2));
  CHECK(kept[5].in_spindle.has_value());
}

TEST_CASE("of many moves few are kept, the extremes among them") {
  PathSamples samples(16);
  double x = 0;
  for (std::size_t i = 1; i <= 20000; ++i) {
    const double next = i == 7777 ? 500 : 10 * std::sin(0.01 * static_cast<double>(i));
    add_line(samples, x, next, i, 1);
    x = next;
  }
  const std::vector<PathSample> kept = samples.take();
  CHECK(kept.size() < 500);
  CHECK(kept.size() > 16);
  CHECK(std::any_of(kept.begin(), kept.end(), [](const PathSample& s) { return s.line == 7777; }));
  samples.restart();
  CHECK(samples.take().empty());
}
