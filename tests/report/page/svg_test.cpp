#include "report/page/svg.hpp"

#include <catch2/catch.hpp>

#include "support/diagnosis.hpp"

using namespace plumbline;

TEST_CASE("text is escaped for HTML") {
  CHECK(report::escaped("a < b & \"c\" > d") == "a &lt; b &amp; &quot;c&quot; &gt; d");
}

TEST_CASE("a gap map is white at the noise and full at ten times") {
  diagnose::Diagnosis d = testing::small_diagnosis();
  d.runs.resize(1);
  d.runs[0].channels = {{identify::kRadial, 5e-6, 0, 0.5e-6}};
  const std::string map = report::gap_map(d);
  CHECK(map.find("fill=\"rgb(205,50,50)\" stroke=\"#fff\"><title>first radial: 10.00 times") != std::string::npos);
  CHECK(map.find("fill=\"rgb(245,245,245)\" stroke=\"#fff\"><title>first radial: 1.00 times") != std::string::npos);
}

TEST_CASE("readings and noise of nothing are no numbers that a browser cannot read") {
  diagnose::Diagnosis d = testing::small_diagnosis();
  d.noise.channels[identify::kRadial].sigma = 0;
  for (diagnose::RunGap& run : d.runs) run.channels[0] = {};
  CHECK(report::gap_map(d).find("nan") == std::string::npos);
}

TEST_CASE("a polar plot turns from +X towards +Y, and residuals of a whole scale reach the next ring") {
  diagnose::RunGap run;
  run.id = "r";
  run.angle = Eigen::Vector2d(0, 1.5707963267948966);
  run.radial_before = Eigen::Vector2d(0, 2e-6);
  run.radial_after = Eigen::Vector2d(-2e-6, 0);
  const std::string plot = report::polar_plot(run, 2e-6);
  CHECK(plot.find("points=\"145.0,90.0 90.0,10.0 \"") != std::string::npos);
  CHECK(plot.find("points=\"120.0,90.0 90.0,35.0 \"") != std::string::npos);
}

TEST_CASE("evidence is drawn to scale, what is not ruled out in blue") {
  const std::string bars = report::evidence_bars(testing::small_diagnosis());
  CHECK(bars.find("width=\"340.0\" height=\"16\" fill=\"#1f5fa8\"") != std::string::npos);
  CHECK(bars.find("width=\"0.0\" height=\"16\" fill=\"#b9c4d0\"") != std::string::npos);
  CHECK(bars.find("50 nats") != std::string::npos);
}
