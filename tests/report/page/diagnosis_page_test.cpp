#include "report/page/diagnosis_page.hpp"

#include <catch2/catch.hpp>

#include "base/units.hpp"
#include "support/diagnosis.hpp"
#include "support/page_sections.hpp"

namespace plumbline::report {
namespace {

using testing::row_of;
using testing::section_of;

jobs::DiagnoseResult small_result() {
  machine::MachineModel machine = machine::read_model(testing::source_file("models/pm600-like.toml"));
  return {std::move(machine), testing::small_diagnosis(), {}, {}, {}, {{"backlash", 0.8e-6, 2.25e-6}}};
}

Page page_of(const jobs::DiagnoseResult& result, const std::vector<std::string>& programs = {}) {
  return diagnosis_page(result, {}, programs);
}

TEST_CASE("a diagnosis begins with its verdict and what that is at the tip") {
  jobs::DiagnoseResult result = small_result();
  Page page = page_of(result);
  CHECK(page.title == "Diagnosis of pm600-like");
  CHECK(page.lead ==
        "The model misses one of backlash, cyclic: backlash moves the tip by up to 2.2 um in these circles (0.80 um "
        "rms).");
  CHECK(page.verdict == Verdict::warn);
  result.diagnosis.confidence_set = {"backlash"};
  CHECK(page_of(result).lead ==
        "The model misses backlash: it moves the tip by up to 2.2 um in these circles (0.80 um rms).");
  result.at_tip[0].largest = 0;
  CHECK(page_of(result).lead == "The model misses backlash: it does not move the tip and shows in the torques alone.");
  result.at_tip.clear();
  CHECK(page_of(result).lead == "The model misses backlash.");
}

TEST_CASE("the other verdicts say what there is") {
  jobs::DiagnoseResult result = small_result();
  result.diagnosis.verdict = diagnose::Verdict::nothing_missing;
  result.diagnosis.visible = {{"cable", "stiffness_N_m", "N/m", 4.9, true}, {"level", "", "", 0, false}};
  Page page = page_of(result);
  CHECK(page.lead ==
        "Nothing is missing that these runs could show: what model and measurements differ by is noise (bar 0.50 um, "
        "torque 0.050 N m).");
  CHECK(page.verdict == Verdict::good);
  const Json visible = section_of(page, "What these runs could have shown");
  CHECK(row_of(visible, "cable")[1] == "4.9 N/m");
  CHECK(row_of(visible, "level")[1] == "at no size");

  result.diagnosis.verdict = diagnose::Verdict::unknown;
  page = page_of(result);
  CHECK(
      page.lead ==
      "There is a gap of 3.10 um in readings of the bar (rms; noise: bar 0.50 um, torque 0.050 N m), and no effect of "
      "the catalogue explains it.");
  CHECK(page.verdict == Verdict::bad);
  CHECK(section_of(page, "What these runs could have shown").is_null());
}

TEST_CASE("what was found stands with its numbers and errors in the units of files") {
  const Page page = page_of(small_result());
  const Json found = section_of(page, "Found: backlash");
  CHECK(row_of(found, "width_um 1") == Json{"width_um 1", "4.1", "0.1", "um"});
  CHECK(row_of(found, "width_um 2") == Json{"width_um 2", "0", "not fitted", "um"});
  CHECK(testing::says(found, "more than a million times as likely with it as without"));
  CHECK(testing::says(found, "No data of this plan tell it from cyclic."));
  const Json gap = section_of(page, "The gap, before and after");
  CHECK(row_of(gap, "bar, um: fitted runs")[1].get<double>() == Approx(3.1));
  CHECK(row_of(gap, "bar, um: fitted runs")[2].get<double>() == Approx(0.6));
  CHECK(row_of(gap, "torque, N m: runs left out")[1].get<double>() == Approx(0.06));
  CHECK(testing::says(section_of(page, "What else is not ruled out"), "backlash, cyclic"));
  for (const Json& section : page.sections) CHECK_FALSE(testing::says(section, "log odds"));
}

TEST_CASE("the runner-up has a column of the gap") {
  jobs::DiagnoseResult result = small_result();
  result.diagnosis.runner_up = "cyclic";
  result.diagnosis.fit.runner_up = {0.9e-6, 0.055};
  const Json row = row_of(section_of(page_of(result), "The gap, before and after"), "bar, um: fitted runs");
  REQUIRE(row.size() == 4);
  CHECK(row[2].get<double>() == Approx(0.9));
}

TEST_CASE("the next test is drawn with its program, and said where there is none") {
  jobs::DiagnoseResult result = small_result();
  diagnose::NextTest next;
  next.run.centre_W = {0.1, 0, -1};
  next.run.radius = 0.144;
  next.run.feed = 1000 * kMmPerMin;
  next.separation = 471.2;
  result.diagnosis.next = {{"level", {}}, {"cyclic", next}};
  const Page page = page_of(result, {"G3 X1"});
  const Json words = section_of(page, "What next")["paragraphs"];
  REQUIRE(words.size() == 2);
  CHECK(words[0] == "No circular test separates it from level.");
  const Json tests = section_of(page, "The next test")["tests"];
  REQUIRE(tests.size() == 1);
  CHECK(tests[0]["name"] == "backlash or cyclic");
  CHECK(tests[0]["program"] == "G3 X1");
  CHECK(testing::says(tests[0], "471 standard deviations of the noise"));
}

TEST_CASE("what speaks against a diagnosis comes before its numbers") {
  jobs::DiagnoseResult result = small_result();
  result.diagnosis.converged = false;
  result.diagnosis.doubt = diagnose::Doubt{{"backlash"}, diagnose::OneMore{}};
  result.diagnosis.remainder = diagnose::Remainder{12, std::vector<diagnose::Term>{}};
  const Page page = page_of(result);
  CHECK(page.verdict == Verdict::bad);
  CHECK(page.sections[0]["type"] == "warnings");
  CHECK(page.sections[0]["items"].size() == 2);
  CHECK(testing::says(section_of(page, "What the catalogue does not explain"), "12 times the noise"));
}

TEST_CASE("what was not measured has no numbers") {
  jobs::DiagnoseResult result = small_result();
  diagnose::Diagnosis& d = result.diagnosis;
  d.noise.channels[identify::kRadial] = {};
  d.fit.before.radial = d.fit.after.radial = d.held_out.before.radial = d.held_out.after.radial = std::nullopt;
  for (diagnose::RunGap& run : d.runs) {
    run.channels.erase(run.channels.begin());
    run.radial_before = run.radial_after = run.angle = Eigen::VectorXd();
    run.circularity.reset();
  }
  const Page page = page_of(result);
  CHECK(row_of(section_of(page, "At a glance"), "Noise")["value"] == "torque 0.050 N m");
  CHECK(row_of(section_of(page, "The gap, before and after"), "bar, um: fitted runs")[1] == "not measured");
  CHECK(section_of(page, "The gap around the circle, before and after").is_null());
  CHECK(section_of(page, "What it is good for").is_null());
}

TEST_CASE("names from files stay text") {
  const std::string text = page_text(page_of(small_result()));
  CHECK(text.find("<last>") == std::string::npos);
  CHECK(text.find("\\u003clast>") != std::string::npos);
}

}  // namespace
}  // namespace plumbline::report
