#include "report/program/check_text.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "support/summary_row.hpp"

using namespace plumbline;
using testing::summary_row;

namespace {

// X out of its travel in `blocks` blocks, the tool out of reach in one more.
jobs::CheckSummary broken_limits(std::size_t blocks) {
  jobs::CheckSummary summary;
  summary.blocks = 1234;
  summary.points = 1;
  summary.violations = blocks + 1;
  summary.kinds = {{"X", blocks}, {"reach", 1}};
  summary.findings.push_back({"sub.ngc", 7, {"reach", 0, 0, 0, ""}});
  for (std::size_t i = 0; i < blocks; ++i) {
    summary.findings.push_back({"part.ngc", 10 + i, {"X", 801.5, 800, 1.5, "mm"}});
  }
  return summary;
}

}  // namespace

TEST_CASE("a finding is a line that names file, block and limit") {
  const std::string text = report::check_text(broken_limits(1));
  CHECK(
      text.starts_with("sub.ngc:7: no command puts the tool there\n"
                       "part.ngc:10: X would be 801.5 mm, 1.5 mm beyond its limit of 800 mm\n"
                       "  blocks"));
  CHECK(summary_row(text, "blocks") == "1,234, 1 point looked at");
  CHECK(summary_row(text, "X") == "beyond its limit in 1 block");
  CHECK(summary_row(text, "limits").empty());
  CHECK(summary_row(text, "not looked at").empty());
}

TEST_CASE("twenty findings are shown, of the others their number") {
  const std::string twenty = report::check_text(broken_limits(19));
  CHECK(twenty.find(" more\n") == std::string::npos);
  const std::string text = report::check_text(broken_limits(2024));
  CHECK(text.find("\nand 2,005 more\n") != std::string::npos);
  CHECK(text.find("part.ngc:28: ") != std::string::npos);
  CHECK(text.find("part.ngc:29: ") == std::string::npos);
  CHECK(summary_row(text, "X") == "beyond its limit in 2,024 blocks");
}

TEST_CASE("where all limits are kept that is said, and what was not looked at") {
  jobs::CheckSummary summary;
  summary.passed_moves = 2;
  const std::string text = report::check_text(summary);
  CHECK(summary_row(text, "limits") == "all kept");
  CHECK(summary_row(text, "not looked at") == "2 moves: machine coordinates, probing, or from where nobody knows");
}

TEST_CASE("a check as JSON has a finding's numbers, and the refusal or null") {
  jobs::CheckSummary summary = broken_limits(1);
  nlohmann::json json = nlohmann::json::parse(report::check_json(summary));
  CHECK(json["plumbline"] == "check 1");
  CHECK(json["violations"] == 2);
  CHECK(json["blocks_by_kind"] == nlohmann::json{{"X", 1}, {"reach", 1}});
  CHECK(json["findings"][1] == nlohmann::json{{"file", "part.ngc"},
                                              {"line", 10},
                                              {"what", "X"},
                                              {"value", 801.5},
                                              {"limit", 800.0},
                                              {"by_how_much", 1.5},
                                              {"unit", "mm"},
                                              {"message", "X would be 801.5 mm, 1.5 mm beyond its limit of 800 mm"}});
  CHECK(json["refusal"].is_null());
  summary.refusal = Diagnostic{"compensate-line-length", "too long", "allow more", {"part.ngc", 3, 1, 1, ""}};
  json = nlohmann::json::parse(report::check_json(summary));
  CHECK(json["refusal"] == nlohmann::json{{"code", "compensate-line-length"},
                                          {"message", "too long"},
                                          {"help", "allow more"},
                                          {"file", "part.ngc"},
                                          {"line", 3}});
}
