#include "report/program/summary_text.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "base/version.hpp"
#include "support/summary_row.hpp"

using namespace plumbline;
using testing::summary_row;

namespace {

compensate::Summary corrected_program() {
  compensate::Summary s;
  s.blocks = 1200;
  s.moves = 1000;
  s.changed_blocks = 999;
  s.points = 54321;
  s.correction_mm = {0.01234, 17};
  s.correction_deg = {0.00056, 0};
  s.rms_correction_mm = 0.0041;
  s.seconds_before = 200;
  s.seconds_after = 201;
  s.time_change = {0.005, 18};
  s.rounding_mm = {0.00006, 19};
  s.condition = {12.34, 20};
  s.bytes_before = 1000;
  s.bytes_after = 2500;
  s.hash_after = 0xabc;
  s.identical = false;
  return s;
}

}  // namespace

TEST_CASE("a summary has each figure with its unit and its line") {
  const std::string text = report::summary_text(corrected_program(), {});
  CHECK(text.starts_with("  blocks "));
  CHECK(summary_row(text, "blocks") == "1,200 read, 999 moves changed of 1,000");
  CHECK(summary_row(text, "points") == "54,321");
  CHECK(summary_row(text, "largest correction") == "0.0123 mm (line 17), 0.00056 deg");
  CHECK(summary_row(text, "rms correction") == "0.0041 mm");
  CHECK(summary_row(text, "cutting time") == "3 min 20.0 s before, 3 min 21.0 s after (+0.500 %)");
  CHECK(summary_row(text, "worst of a block") == "0.500 % (line 18)");
  CHECK(summary_row(text, "rounding") == "at most 0.060 um (line 19)");
  CHECK(summary_row(text, "condition number") == "at most 12.3 (line 20)");
  CHECK(summary_row(text, "file") == "1,000 bytes before, 2,500 after (2.50 times)");
}

TEST_CASE("what a program has nothing of is left out") {
  const std::string text = report::summary_text(corrected_program(), {});
  for (const char* const name :
       {"form", "subprograms from", "left as they stand", "rounding, subdivision", "wider steps", "short pieces",
        "work offset", "zero", "taken to be zero", "read back", "settings from"}) {
    INFO(name);
    CHECK(summary_row(text, name).empty());
  }
}

TEST_CASE("a program that needs nothing is said to be the input, without figures of moves") {
  compensate::Summary s;
  s.bytes_before = s.bytes_after = 20;
  const std::string text = report::summary_text(s, {});
  CHECK(text.starts_with("nothing had to change: the output is the input\n  blocks"));
  CHECK(summary_row(text, "rounding").empty());
  CHECK(summary_row(text, "file") == "20 bytes before, 20 after (1.00 times)");
}

TEST_CASE("form, offsets, short pieces and what was read back are told where there are any") {
  compensate::Summary s = corrected_program();
  s.unrolled = true;
  s.inlined_files = {{"sub.ngc", 0xabc}};
  s.passed_moves = 1;
  s.offset_shift_for_1um_mm = 0.25;
  s.zero_error = AxisWords{{0.0125, -0.002, 0, 0, 0, 0}};
  s.zero_error_line = 6;
  s.assumed_at_zero = {Axis::A, Axis::C};
  s.short_pieces = {3, 1, 2, 0.0005, 9};
  s.widened_blocks = 1;
  s.widened_step_mm = {2.5, 30};
  s.widening_mm = {0.001, 31};
  s.read_back = compensate::ReadBackFigures{};
  s.read_back->blocks = 1;
  s.read_back->output_blocks = 2000;
  s.read_back->guard_lines = 7;
  settings::Options options;
  options.paths.settings_files = {"plumbline.toml"};
  const std::string text = report::summary_text(s, options);
  CHECK(summary_row(text, "form").starts_with("unrolled: "));
  CHECK(summary_row(text, "subprograms from") == "sub.ngc (hash 0000000000000abc)");
  CHECK(summary_row(text, "left as they stand") == "1 move");
  CHECK(summary_row(text, "work offset") == "good to 0.25 mm: that much off costs 1 um");
  CHECK(summary_row(text, "zero") ==
        "the machine stands X+12.5 Y-2.0 Z+0.0 um off at the first cutting block (line 6)");
  CHECK(summary_row(text, "taken to be zero") == "A, C: no word of the program names them");
  CHECK(summary_row(text, "short pieces") ==
        "3 below 1 ms, 1 below the control's block time, the shortest 0.5 ms (line 9)");
  CHECK(text.find("  2 of them as short in the program itself\n") != std::string::npos);
  CHECK(summary_row(text, "wider steps") == "1 block, up to 2.500 mm (line 30): the control's block time asks for it");
  CHECK(text.find("the tip is up to 1.000 um off (line 31)\n") != std::string::npos);
  CHECK(summary_row(text, "read back") == "1 block, 2,000 of the output: all as meant");
  CHECK(text.find("  7 lines of the guard left out") != std::string::npos);
  CHECK(summary_row(text, "settings from") == "plumbline.toml");
  options.compensation.touch_off.emplace();
  CHECK(summary_row(report::summary_text(s, options), "zero").empty());  // the offset holds it
}

TEST_CASE("what is left at the tip is told if it was played") {
  compensate::Summary s = corrected_program();
  s.residual_mm = {0.0005, 12};
  s.residual_deg = {0.00002, 13};
  CHECK(nlohmann::json::parse(report::summary_json(s, {}))["worst_residual_um"].is_null());
  s.replayed = 1000;
  CHECK(summary_row(report::summary_text(s, {}), "rounding, subdivision")
            .starts_with("at most 0.500 um (line 12), 0.00002 deg, between its points too"));
  const nlohmann::json json = nlohmann::json::parse(report::summary_json(s, {}));
  CHECK(json["worst_residual_um"]["value"].get<double>() == Approx(0.5));
  CHECK(json["worst_residual_um"]["line"] == 12);
}

TEST_CASE("where a bound chose the points the summary says how it is kept, and where it is not") {
  compensate::Summary s = corrected_program();
  settings::Options options;
  CHECK(nlohmann::json::parse(report::summary_json(s, options))["bound"].is_null());
  options.compensation.bound.tolerance_mm = 0.0005;
  s.bound.emplace();
  s.bound->kept_mm = {0.00048, 7};
  s.bound->kept_deg = {0.00001, 8};
  std::string text = report::summary_text(s, options);
  CHECK(
      summary_row(text, "bound").starts_with("0.5 um and 0.000286 deg asked for; kept with at most 0.480 um (line 7)"));
  CHECK(text.find("but on") == std::string::npos);
  s.bound->at_turns = {3, 0.0031, {0.023, 9}, {0.001, 9}};
  s.bound->by_time = {1, 2.5, {0.002, 10}, {}};
  text = report::summary_text(s, options);
  CHECK(text.find("but on 3 pieces, for 3.1 ms: ") != std::string::npos);
  CHECK(text.find("up to 23.000 um (line 9)") != std::string::npos);
  CHECK(text.find("but on 1 piece, for 2.50 s: ") != std::string::npos);
  const nlohmann::json json = nlohmann::json::parse(report::summary_json(s, options))["bound"];
  CHECK(json["tolerance_um"].get<double>() == Approx(0.5));
  CHECK(json["yields"] == "bound");
  CHECK(json["kept_um"]["line"] == 7);
  CHECK(json["not_kept_where_friction_turns"]["pieces"] == 3);
  CHECK(json["not_kept_where_friction_turns"]["worst_um"]["value"].get<double>() == Approx(23));
  CHECK(json["not_kept_for_block_time"]["time_s"] == 2.5);
}

TEST_CASE("a summary as JSON has every figure, and null for what there is not") {
  compensate::Summary s = corrected_program();
  nlohmann::json json = nlohmann::json::parse(report::summary_json(s, {}));
  CHECK(json["plumbline"] == "compensation 1");
  CHECK(json["version"] == version());
  CHECK(json["identical"] == false);
  CHECK(json["largest_correction_mm"] == nlohmann::json{{"value", 0.01234}, {"line", 17}});
  CHECK(json["worst_rounding_um"]["value"].get<double>() == Approx(0.06));
  CHECK(json["hash_after"] == "0000000000000abc");
  for (const char* const key :
       {"offset_shift_for_1um_mm", "zero_error", "zero_error_line", "read_back", "settings_file", "widest_step_mm"}) {
    INFO(key);
    CHECK(json.at(key).is_null());
  }
  CHECK(json["short_pieces"]["shortest_ms"].is_null());
  CHECK(json["warnings"] == nlohmann::json::array());
  s.zero_error = AxisWords{{0.0125, 0, 0, 0, 0, 0.5}};
  s.assumed_at_zero = {Axis::B};
  s.made_of.program = "part.ngc";
  s.warnings = {{"compensate-slow", "slow", "go on", {"part.ngc", 4, 1, 1, ""}, Severity::warning},
                {"compensate-slow", "slow", "go on", {"SUB1.SPF", 4, 1, 1, ""}, Severity::warning}};
  json = nlohmann::json::parse(report::summary_json(s, {}));
  CHECK(json["zero_error"]["x_mm"] == 0.0125);
  CHECK(json["zero_error"]["c_deg"] == 0.5);
  CHECK(json["assumed_at_zero"] == nlohmann::json{"B"});
  CHECK(json["warnings"][0] ==
        nlohmann::json{{"code", "compensate-slow"}, {"message", "slow"}, {"help", "go on"}, {"line", 4}});
  CHECK(json["warnings"][1]["file"] == "SUB1.SPF");
}
