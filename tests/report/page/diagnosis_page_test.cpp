#include "report/page/diagnosis_page.hpp"

#include <algorithm>

#include <catch2/catch.hpp>

#include "support/diagnosis.hpp"

using namespace plumbline;

namespace {

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

}  // namespace

TEST_CASE("a page says what was found, with its numbers in the units of files") {
  const std::string page = report::diagnosis_page(testing::small_diagnosis(), "Diagnosis of <mine>");
  CHECK(page.starts_with("<!doctype html>"));
  CHECK(contains(page, "<title>Diagnosis of &lt;mine&gt;</title>"));
  CHECK(contains(page, "The model misses: one of backlash, cyclic."));
  CHECK(contains(page, "<td>fitted runs</td><td>3.10</td><td>0.60</td><td>0.060</td><td>0.050</td>"));
  CHECK(contains(page, "bar 0.50 um, torque 0.050 N m"));
  CHECK(contains(page, "<td>width_um 1</td><td>4.1</td><td>0.1</td>"));
  CHECK(contains(page, "<td>width_um 2</td><td>0</td><td>not fitted</td>"));
  CHECK(contains(page, "No data of this plan tell it from cyclic."));
}

TEST_CASE("a page shows where the gap lives, what poses left out say, and what compensation gains") {
  const std::string page = report::diagnosis_page(testing::small_diagnosis(), "t");
  CHECK(contains(page, "<title>bar, 90 to 120 deg: 10.00 times the noise</title>"));
  CHECK(contains(page, "<title>bar, order 2: 10.00 times the noise</title>"));
  CHECK(contains(page, "<td>direction</td><td>2</td>"));
  CHECK(contains(page, ">4.00</td>"));  // differs with direction: 2 um of 0.5
  CHECK(contains(page, "<td>tilt 0 to 5 deg</td><td>2</td>"));
  CHECK(contains(page, "the widest reaches 5.00 um"));
  CHECK(contains(page, "<td>backlash</td><td>50.0</td><td>31.5</td><td>33.5</td>"));
  CHECK(contains(page, ">20.0</text>"));
  CHECK(contains(page, ">4.0</text>"));
}

TEST_CASE("a page needs nothing else, and text of files cannot break it") {
  const std::string page = report::diagnosis_page(testing::small_diagnosis(), "t");
  for (const char* const from_elsewhere : {"http", "src=", "href", "<script", "@import", "url("}) {
    INFO(from_elsewhere);
    CHECK_FALSE(contains(page, from_elsewhere));
  }
  CHECK_FALSE(contains(page, "<last>"));
  CHECK(contains(page, "&lt;last&gt; &amp; &quot;best&quot; (left out)"));
  for (const char* const tag : {"svg", "table", "div", "tr", "td", "p", "g", "text", "style", "title"}) {
    INFO(tag);
    const std::string name(tag);
    CHECK(count(page, "<" + name + ">") + count(page, "<" + name + " ") == count(page, "</" + name + ">"));
  }
  CHECK(count(page, "<polygon") == 4);
}

TEST_CASE("what was not measured has no numbers") {
  diagnose::Diagnosis d = testing::small_diagnosis();
  d.noise.channels[identify::kRadial] = {};
  d.fit.before.radial = d.fit.after.radial = d.held_out.before.radial = d.held_out.after.radial = std::nullopt;
  for (diagnose::RunGap& run : d.runs) {
    run.channels.erase(run.channels.begin());
    run.radial_before = run.radial_after = run.angle = Eigen::VectorXd();
  }
  const std::string page = report::diagnosis_page(d, "t");
  CHECK(contains(page, "bar not measured, torque 0.050 N m"));
  CHECK(contains(page, "<td>fitted runs</td><td>-</td><td>-</td><td>0.060</td>"));
  CHECK(count(page, "<polygon") == 0);
  CHECK_FALSE(contains(page, "Rings"));
}
