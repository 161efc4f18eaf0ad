// Lines of whole programs are in tests/jobs/trace_test.cpp.
#include "report/program/trace_text.hpp"

#include <catch2/catch.hpp>

#include "support/scratch.hpp"

using namespace plumbline;

namespace {

std::string trace_line(const nc::Motion& motion) {
  std::string line;
  report::append_trace_line(line, motion);
  return line;
}

nc::Motion to_x(double x, nc::MotionKind kind) {
  nc::Motion motion;
  motion.kind = kind;
  motion.line = 12;
  motion.to[Axis::X] = x;
  return motion;
}

std::string until_feed(double x) {
  return R"({"line": 12, "motion": "rapid", "to": [)" + (x == 0 ? "0" : std::to_string(static_cast<int>(x))) +
         R"(, 0, 0, 0, 0, 0], "machine": [0, 0, 0, 0, 0, 0], )";
}

}  // namespace

TEST_CASE("a rapid has no feed, and its place in both systems") {
  nc::Motion motion = to_x(5, nc::MotionKind::rapid);
  CHECK(trace_line(motion) == until_feed(5) + "\"feed\": 0, \"feed_mode\": \"G94\"}\n");
  motion.machine = {{5.5, -1, 0.25, 0, 90, -180}};
  CHECK(trace_line(motion).find("\"machine\": [5.5, -1, 0.25, 0, 90, -180]") != std::string::npos);
}

TEST_CASE("motion, feed mode and plane have the names of their codes") {
  for (const auto& [kind, name] : {std::pair{nc::MotionKind::feed, "feed"},
                                   {nc::MotionKind::arc, "arc"},
                                   {nc::MotionKind::probe, "probe"},
                                   {nc::MotionKind::dwell, "dwell"}}) {
    CHECK(trace_line(to_x(1, kind)).find(std::string("\"motion\": \"") + name + "\"") != std::string::npos);
  }
  nc::Motion arc = to_x(1, nc::MotionKind::arc);
  arc.arc = {nc::Plane::yz, {1, 2.5, -3}, -2};
  arc.feed = 0.2;
  arc.feed_mode = nc::FeedMode::per_revolution;
  CHECK(trace_line(arc).ends_with(
      "\"feed\": 0.2, \"feed_mode\": \"G95\", \"plane\": \"G19\", \"centre\": [1, 2.5, -3], \"turns\": -2}\n"));
  arc.feed_mode = nc::FeedMode::inverse_time;
  arc.arc.plane = nc::Plane::xy;
  CHECK(trace_line(arc).find("\"feed_mode\": \"G93\", \"plane\": \"G17\"") != std::string::npos);
}

TEST_CASE("a dwell says its seconds and nothing of a plane") {
  nc::Motion dwell = to_x(0, nc::MotionKind::dwell);
  dwell.dwell_s = 2.5;
  CHECK(trace_line(dwell).ends_with("\"feed_mode\": \"G94\", \"seconds\": 2.5}\n"));
  CHECK(trace_line(to_x(0, nc::MotionKind::rapid)).find("seconds") == std::string::npos);
}

TEST_CASE("numbers keep nine decimals, fewer where a double has no more") {
  CHECK(trace_line(to_x(-0.123456789, nc::MotionKind::rapid)).find("[-0.123456789, 0") != std::string::npos);
  CHECK(trace_line(to_x(-1e-10, nc::MotionKind::rapid)).find("[0, 0") != std::string::npos);
  CHECK(trace_line(to_x(12345678.125, nc::MotionKind::rapid)).find("[12345678.125, 0") != std::string::npos);
  CHECK(trace_line(to_x(1e20, nc::MotionKind::rapid)).find("[1e+20, 0") != std::string::npos);
}

TEST_CASE("a writer hands on all of its lines") {
  const testing::Scratch scratch;
  OutputFile file(scratch / "trace.jsonl");
  report::TraceWriter writer(file);
  const nc::Motion motion = to_x(5, nc::MotionKind::rapid);
  const std::string line = trace_line(motion);
  constexpr std::size_t kLines = 1000;  // more than the writer keeps
  for (std::size_t i = 0; i < kLines; ++i) writer.add(motion);
  CHECK(file.size() > 0);
  CHECK(file.size() < kLines * line.size());
  writer.flush();
  file.commit();
  CHECK(scratch.text("trace.jsonl").size() == kLines * line.size());
  CHECK(scratch.text("trace.jsonl").ends_with("}\n" + line));
}
