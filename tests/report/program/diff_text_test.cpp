#include "report/program/diff_text.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "support/summary_row.hpp"

using namespace plumbline;
using testing::summary_row;

namespace {

jobs::DiffSummary two_programs() {
  jobs::DiffSummary s;
  s.moves_a = 1000;
  s.moves_b = 2500;
  s.matched = 999;
  s.points = 2400;
  s.shift[index(Axis::X)] = {0.0123456, 7, 9, 0.004};
  s.shift[index(Axis::B)] = {0.25, 3, 4, 0.125};
  s.seconds_a = 100;
  s.seconds_b = 100.5;
  s.time_change = {0.00123, 8};
  s.out_of_line_a = 1;
  s.out_of_line_b = 1000;
  s.out_of_line = {{3, 3, 0, 0}, {5, 7, 9, 9}};
  return s;
}

}  // namespace

TEST_CASE("the shift of an axis has its unit, its decimals and its lines") {
  const std::string text = report::diff_text(two_programs());
  CHECK(summary_row(text, "moves") == "1,000 in A, 2,500 in B, 999 matched, 2,400 points compared");
  CHECK(summary_row(text, "shift of X") == "   0.01235 mm  largest (line 7 of A, 9 of B), rms 0.00400");
  CHECK(summary_row(text, "shift of B") == "  0.250000 deg largest (line 3 of A, 4 of B), rms 0.125000");
  CHECK(summary_row(text, "shift of Y") == "         0 mm");
  CHECK(summary_row(text, "shift of C") == "         0 deg");
}

TEST_CASE("times are compared where A takes any") {
  jobs::DiffSummary s = two_programs();
  CHECK(summary_row(report::diff_text(s), "cutting time") == "1 min 40.0 s in A, 1 min 40.5 s in B (+0.500 %)");
  CHECK(summary_row(report::diff_text(s), "worst of a move") == "0.123 % (line 8)");
  s.seconds_a = s.seconds_b = 0;
  s.time_change = {};
  CHECK(summary_row(report::diff_text(s), "cutting time") == "0.00 s in A, 0.00 s in B");
  CHECK(summary_row(report::diff_text(s), "worst of a move") == "0.000 %");
}

TEST_CASE("moves without a time are counted where there are any") {
  jobs::DiffSummary s = two_programs();
  CHECK(report::diff_text(s).find("time not known") == std::string::npos);
  s.untimed.add(9);
  s.untimed.add(12);
  CHECK(summary_row(report::diff_text(s), "time not known") ==
        "of 2 moves of A, first in line 9 (feeds per revolution, strokes that a cycle makes in its own "
        "way, or turns without a feed rule)");
  CHECK(nlohmann::json::parse(report::diff_json(s))["moves_without_time"] == 2);
}

TEST_CASE("moves out of line are told by the lines of both programs, twenty places at most") {
  jobs::DiffSummary s = two_programs();
  const std::string text = report::diff_text(s);
  CHECK(summary_row(text, "out of line") == "1 move of A, 1,000 of B");
  CHECK(text.find("  A: line 3, B: nothing\n") != std::string::npos);
  CHECK(text.find("  A: lines 5 to 7, B: line 9\n") != std::string::npos);
  CHECK(text.find("and further ones") == std::string::npos);
  s.out_of_line.assign(20, {1, 1, 2, 2});
  CHECK(report::diff_text(s).find("and further ones") == std::string::npos);
  s.out_of_line.push_back({8, 8, 9, 9});
  CHECK(report::diff_text(s).find("and further ones") != std::string::npos);
  CHECK(report::diff_text(s).find("A: line 8") == std::string::npos);
}

TEST_CASE("a diff as JSON says the unit in its keys") {
  const nlohmann::json json = nlohmann::json::parse(report::diff_json(two_programs()));
  CHECK(json["plumbline"] == "diff 1");
  CHECK(json["shift"]["X"] ==
        nlohmann::json{{"largest_mm", 0.0123456}, {"line_a", 7}, {"line_b", 9}, {"rms_mm", 0.004}});
  CHECK(json["shift"]["B"]["largest_deg"] == 0.25);
  CHECK_FALSE(json["shift"]["B"].contains("largest_mm"));
  CHECK(json["time_difference_s"] == 0.5);
  CHECK(json["worst_move_time_change"] == nlohmann::json{{"value", 0.00123}, {"line", 8}});
  CHECK(json["out_of_line"][1] ==
        nlohmann::json{{"first_line_a", 5}, {"last_line_a", 7}, {"first_line_b", 9}, {"last_line_b", 9}});
}
