#include "report/program/expected_text.hpp"

#include <algorithm>

#include <catch2/catch.hpp>

using namespace plumbline;

namespace {

jobs::ExpectedError some_error() {
  jobs::ExpectedError expected;
  expected.made_by = "plumbline identify";
  expected.from_data = true;
  expected.poses = 300;
  expected.stands = {5.2e-6, 9.4e-6, 11.3e-6, 812, {4.9e-6, 0, 0.6e-6, 0, 0, 0}};
  expected.touched_off = jobs::ExpectedFigures{1.2e-6, 2.4e-6, 3.3e-6, 0, {}};
  return expected;
}

}  // namespace

TEST_CASE("what is expected is said with its causes and the worst line") {
  const std::string text = report::expected_text(some_error());
  CHECK(text.find("expected at the tip") != std::string::npos);
  CHECK(text.find("5.2 um on average, 95 % within 9.4 um, at the worst within 11.3 um (line 812)\n") !=
        std::string::npos);
  CHECK(text.find("rms by geometry 4.9, friction 0.6 um\n") != std::string::npos);
  CHECK(text.find("1.2 um on average, 95 % within 2.4 um, at the worst within 3.3 um\n") != std::string::npos);
  CHECK(text.find("known from plumbline identify\n") != std::string::npos);
  CHECK(report::expected_text(std::nullopt).empty());
}

TEST_CASE("the same as JSON, null where nothing is known") {
  CHECK(report::expected_json(std::nullopt).is_null());
  const nlohmann::json json = report::expected_json(some_error());
  CHECK(json["stands"]["largest_within_95_um"]["line"] == 812);
  CHECK(json["stands"]["rms_by_cause_um"]["geometry"].get<double>() == Approx(4.9));
  CHECK(json["stands"]["rms_by_cause_um"].size() == jobs::kCauses);
  CHECK(json["touched_off"]["within_95_um"].get<double>() == Approx(2.4));
  CHECK(json["zero"]["x_mm"] == 0);
}

TEST_CASE("a table has as many columns where nothing is known") {
  const auto commas = [](std::string_view text) { return std::count(text.begin(), text.end(), ','); };
  std::string empty;
  report::append_expected(empty, std::nullopt);
  std::string full;
  report::append_expected(full, jobs::PoseDoubt{{}, jobs::TipDoubt{}});
  CHECK(commas(report::expected_columns()) == 22);
  CHECK(commas(empty) == 22);
  CHECK(commas(full) == 22);
}
