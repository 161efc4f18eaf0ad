#include "report/program/batch_text.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using namespace plumbline;
using State = jobs::BatchItem::State;

namespace {

constexpr const char* kSummary =
    R"({"blocks":1234,"points":5678,"largest_correction_mm":{"value":0.08671,"line":3},"worst_residual_um":{"value":0.4567,"line":4},"time_after_s":61.5})";

}  // namespace

TEST_CASE("a line of the table has the figures below their names") {
  const std::string head = report::batch_heading();
  const std::string line = report::batch_line({"a.nc", "out/a.nc", State::done, kSummary, {}});
  CHECK(line == "     1,234      5,678      0.0867 mm      0.46 um         1 min 01.5 s  out/a.nc\n");
  CHECK(head.find("output") == line.find("out/a.nc"));
  CHECK(head.find("points") + 6 == line.find("5,678") + 5);
  const std::string refused = report::batch_line({"a.nc", "", State::failed, "", {}});
  CHECK(refused.find("a.nc") == line.find("out/a.nc"));
  CHECK(refused.find("refused") != std::string::npos);
}

TEST_CASE("the total names what there was, and no more") {
  jobs::BatchSummary summary;
  summary.seconds = 2;
  CHECK(report::batch_total(summary) == "no programs in 2.00 s\n");
  summary.done = 1200;
  summary.failed = 1;
  CHECK(report::batch_total(summary) == "1,200 compensated, 1 refused in 2.00 s\n");
  summary.vanished = {"x"};
  CHECK(report::batch_total(summary) == "1,200 compensated, 1 refused in 2.00 s; 1 output whose program is gone\n");
}

TEST_CASE("a line of the table is one line, whatever the names are") {
  CHECK(
      report::batch_line({"a\nb\x1b[2J.nc", "out", State::failed, "", {}}).ends_with("refused  a\\x0ab\\x1b[2J.nc\n"));
  CHECK(report::batch_line({"a", "out/a\nb.nc", State::done, kSummary, {}}).ends_with("  out/a\\x0ab.nc\n"));
}

TEST_CASE("each line of JSON is an object, whatever the names are") {
  jobs::BatchItem item{"a\n\"\xff.nc", "out", State::done, kSummary, {}};
  item.diagnostics.push_back({"nc-x", "wrong", "do this", {"a", 2}, Severity::warning});
  const std::string line = report::batch_json_line(item);
  CHECK(line.find('\n') == line.size() - 1);
  const nlohmann::json read = nlohmann::json::parse(line);
  CHECK(read.at("plumbline") == "batch 1");
  CHECK(read.at("state") == "done");
  CHECK(read.at("summary").at("points") == 5678);
  CHECK(read.at("diagnostics").at(0).at("code") == "nc-x");
  CHECK(nlohmann::json::parse(report::batch_json_line({"a", "", State::failed, "", {}})).at("summary").is_null());
  CHECK(nlohmann::json::parse(report::batch_json_line({"a", "", State::subprogram, "", {}})).at("state") ==
        "subprogram");
  CHECK(nlohmann::json::parse(report::batch_json_line({"a", "", State::compensated, "", {}})).at("state") ==
        "compensated");
  jobs::BatchSummary summary;
  summary.unchanged = 3;
  summary.compensated = 2;
  summary.passed_over = {"n.txt"};
  const nlohmann::json total = nlohmann::json::parse(report::batch_json_total(summary));
  CHECK(total.at("plumbline") == "batch total 1");
  CHECK(total.at("unchanged") == 3);
  CHECK(total.at("compensated") == 2);
  CHECK(total.at("passed_over").at(0) == "n.txt");
}
