#include "jobs/compensate/compensate_file.hpp"

#include <memory>
#include <optional>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "jobs/simulate.hpp"
#include "nc/language/comment_line.hpp"
#include "nc/language/guard_lines.hpp"
#include "nc/rewrite/output/undo.hpp"
#include "nc/sequence/program.hpp"
#include "report/program/summary_text.hpp"
#include "settings/options.hpp"
#include "support/scratch.hpp"

using namespace plumbline;

namespace {

settings::Options options() {
  settings::Options o;
  o.paths.model = testing::source_file("models/pm600-like.toml");
  o.program.work_offsets[0] = nc::WorkOffset{{{0, 0, -1008, 0, 0, 0}}, 0};
  return o;
}

constexpr const char* kProgram = "(PART)\nG0 X0 Y0 Z0 A0 B0 C0\nG1 X50 A10 F1000\nM2\n";

}  // namespace

TEST_CASE("a program is compensated into a stamped one, which is refused the next time") {
  const testing::Scratch scratch;
  const compensate::Summary s =
      jobs::compensate_file(scratch.file("a.ngc", kProgram), scratch.path("b.ngc"), options());
  const std::string text = scratch.text("b.ngc");
  CHECK(text.starts_with("(PART)\n(plumbline "));
  CHECK(s.bytes_after == text.size());
  CHECK(s.changed_blocks == 2);
  const Diagnostic d =
      testing::refusal_of([&] { jobs::compensate_file(scratch.path("b.ngc"), scratch.path("c.ngc"), options()); });
  CHECK(d.code == "compensate-stamped");
  CHECK_FALSE(scratch.has("c.ngc"));
}

TEST_CASE("an unrolled program is stamped, refused the next time, and restored byte for byte") {
  const testing::Scratch scratch;
  const std::string program =
      "(PART)\nG0 X0 Y0 Z0 A0 B0 C0\nG1 X5 F900 (changes before the first loop)\no1 repeat [3]\nG91 G1 X5\no1 "
      "endrepeat\nM2\nnever read";
  settings::Options how = options();
  how.undo = true;
  const compensate::Summary s = jobs::compensate_file(scratch.file("a.ngc", program), scratch.path("b.ngc"), how);
  CHECK(s.unrolled);
  CHECK(s.bytes_after == scratch.text("b.ngc").size());
  CHECK(scratch.text("b.ngc").starts_with("(PART)\n(plumbline "));
  CHECK(report::summary_text(s, how).find("unrolled") != std::string::npos);
  CHECK(nlohmann::json::parse(report::summary_json(s, how)).at("unrolled") == true);
  CHECK(testing::refusal_of([&] { jobs::compensate_file(scratch.path("b.ngc"), scratch.path("c.ngc"), how); }).code ==
        "compensate-stamped");
  OutputFile back(scratch.path("back.ngc"));
  nc::restore(InputFile(scratch.path("b.ngc")), InputFile(scratch.path("b.ngc.undo")), back);
  back.commit();
  CHECK(scratch.text("back.ngc") == program);
}

TEST_CASE("what fails writes nothing") {
  const testing::Scratch scratch;
  const std::string program = scratch.file("a.ngc", std::string(kProgram) + "G1 A60\n");
  scratch.file("b.ngc", "old");
  settings::Options how = options();
  scratch.file("bad.ngc", "G0 X0 Y0 Z0 A0 B0 C0\nG1 A60 F100\n");
  CHECK(testing::refusal_of([&] { jobs::compensate_file(scratch.path("bad.ngc"), scratch.path("b.ngc"), how); }).code ==
        "limit-tilt");
  CHECK(scratch.text("b.ngc") == "old");
  how.paths.model = scratch.path("missing.toml");
  CHECK(testing::refusal_of([&] { jobs::compensate_file(program, scratch.path("b.ngc"), how); }).code ==
        "file-missing");
  CHECK(scratch.text("b.ngc") == "old");
}

TEST_CASE("a guard stands after the stamp") {
  const testing::Scratch scratch;
  settings::Options how = options();
  how.guard = true;
  jobs::compensate_file(scratch.file("a.ngc", kProgram), scratch.path("b.ngc"), how);
  const std::string text = scratch.text("b.ngc");
  const std::size_t guard = text.find("(guard:");
  REQUIRE(guard != std::string::npos);
  CHECK(text.find("(plumbline ") < guard);
  CHECK(guard < text.find("G0 X"));
}

TEST_CASE("guards of other controls are passed over by who reads the output, and refused where they were changed") {
  const std::string fanuc = "O0001 (PART)\nG21 G90 G54\nG0 X0. Y0. Z0. A0. B0. C0.\nG1 X50. A10. F1000.\nM30\n";
  const std::string siemens = "; part\nG54 G90 G710\nG0 X0 Y0 Z0 A0 B0 C0\nG1 X50 A10 F1000\nM30\n";
  for (const auto& [name, program] : {std::pair{"fanuc", fanuc}, {"siemens", siemens}}) {
    INFO(name);
    const testing::Scratch scratch;
    settings::Options how = options();
    how.dialect = name;
    how.guard = how.undo = true;
    how.program.feed_rule = nc::FeedRule::xyz_first;
    const compensate::Summary s = jobs::compensate_file(scratch.file("a.nc", program), scratch.path("b.nc"), how);
    const std::string text = scratch.text("b.nc");
    REQUIRE(s.read_back);
    CHECK(s.read_back->guard_lines > 8);
    const nc::Dialect& dialect = nc::dialect(name);
    const auto moves = [&](const std::string& path) {
      const InputFile file(path);
      nc::ProgramSettings settings;
      settings.work_offsets = how.program.work_offsets;
      nc::Program output(file, dialect, settings);
      int count = 0;
      while (const nc::Step* step = output.next()) count += static_cast<int>(step->motions.size());
      return count;
    };
    CHECK(moves(scratch.path("b.nc")) > 40);
    const std::size_t end = text.find(nc::comment_line(nc::kGuardEnds, dialect));
    REQUIRE(end != std::string::npos);
    const std::size_t line = text.rfind('\n', end) + 1;
    const std::string changed = text.substr(0, line) + "G1 X5\n" + text.substr(line);
    CHECK(testing::refusal_of([&] { moves(scratch.file("c.nc", changed)); }).code == "nc-guard");
    OutputFile back(scratch.path("back.nc"));
    nc::restore(InputFile(scratch.path("b.nc")), InputFile(scratch.path("b.nc.undo")), back);
    back.commit();
    CHECK(scratch.text("back.nc") == program);
  }
}

TEST_CASE("a summary has every figure, in words and as JSON") {
  const testing::Scratch scratch;
  const settings::Options how = options();
  const compensate::Summary s = jobs::compensate_file(scratch.file("a.ngc", kProgram), scratch.path("b.ngc"), how);
  const std::string text = report::summary_text(s, how);
  for (const char* const part :
       {"largest correction", "rms correction", "cutting time", "rounding", "work offset",
        "with the friction that turns", "first cutting block (line 3)", "--touch-off", "bytes before"}) {
    INFO(text);
    CHECK(text.find(part) != std::string::npos);
  }
  const auto json = nlohmann::json::parse(report::summary_json(s, how));
  CHECK(json.at("plumbline") == "compensation 1");
  CHECK(json.at("identical") == false);
  CHECK(json.at("moves") == 2);
  CHECK(json.at("largest_correction_mm").at("value") == s.correction_mm.value);
  CHECK(json.at("zero_error").at("z_mm") == s.zero_error->values[2]);
  CHECK(json.at("settings_file").is_null());
}

TEST_CASE("where nothing had to change, the summary says so") {
  const testing::Scratch scratch;
  const settings::Options how = options();
  const compensate::Summary s =
      jobs::compensate_file(scratch.file("a.ngc", "(nothing)\nM2\n"), scratch.path("b.ngc"), how);
  CHECK(s.identical);
  CHECK(scratch.text("b.ngc") == "(nothing)\nM2\n");
  CHECK(report::summary_text(s, how).starts_with("nothing had to change"));
  CHECK(nlohmann::json::parse(report::summary_json(s, how)).at("offset_shift_for_1um_mm").is_null());
}

TEST_CASE("tools that only a subprogram in another file uses stand in stamp and guard") {
  const testing::Scratch scratch;
  scratch.file("drill.ngc", "o<drill> sub\nT2 M6\nG43 H2\nG0 X0 Y0 Z0 A0 B0 C0\nG1 X5 F500\nG49\no<drill> endsub\n");
  settings::Options how = options();
  how.paths.tools = scratch.file("tools.toml",
                                 "plumbline = \"tools 1\"\n[[tool]]\nnumber = 1\nlength_mm = 80\nmass_kg = 1\n"
                                 "[[tool]]\nnumber = 2\nlength_mm = 60\nmass_kg = 1\n");
  how.guard = true;
  how.undo = true;
  const std::string program = scratch.file("a.ngc", "G0 X0 Y0 Z0 A0 B0 C0\no<drill> call\nM2\n");
  const compensate::Summary s = jobs::compensate_file(program, scratch.path("b.ngc"), how);
  const std::string text = scratch.text("b.ngc");
  CHECK(s.bytes_after == text.size());
  CHECK(text.find("(tool 2: length 60 mm, mass 1 kg at 0 mm)") != std::string::npos);
  CHECK(text.find("(tool 1:") == std::string::npos);
  CHECK(text.find("\no<plumbline_tool2> if ") != std::string::npos);
  OutputFile back(scratch.path("back.ngc"));
  nc::restore(InputFile(scratch.path("b.ngc")), InputFile(scratch.path("b.ngc.undo")), back);
  back.commit();
  CHECK(scratch.text("back.ngc") == scratch.text("a.ngc"));

  const Diagnostic d = testing::refusal_of([&] { jobs::compensate_file(program, scratch.path("drill.ngc"), how); });
  CHECK(d.code == "file-overwrites-input");
  CHECK(scratch.text("drill.ngc").starts_with("o<drill> sub"));
}

TEST_CASE("of axes that no word names only those are taken to stand at zero that nobody placed") {
  const testing::Scratch scratch;
  const std::string program = scratch.file("a.ngc", "G0 X0 Y0 Z0\nG1 X30 F500\nY20\nM2\n");
  const auto with = [&](std::optional<double> a, std::optional<double> b, std::optional<double> c) {
    settings::Options how = options();
    how.program.start = {0.0, 0.0, 0.0, a, b, c};
    return jobs::compensate_file(program, scratch.path("b.ngc"), how).assumed_at_zero;
  };
  const auto writes = [&](const char* word) {
    const std::string text = scratch.text("b.ngc");
    return text.find(word, text.find("\nG0 X")) != std::string::npos;
  };
  CHECK(with({}, {}, {}) == AxisSet::rotary());
  CHECK_FALSE(writes(" A"));
  CHECK(with(5, {}, {}) == AxisSet{Axis::B, Axis::C});
  CHECK(writes(" A4.99"));
  CHECK(with({}, -7, {}) == AxisSet{Axis::A, Axis::C});
  CHECK(writes(" B-6.99"));
  CHECK(with(5, -7, 0).empty());
}

TEST_CASE("an axis that stood elsewhere and may have been moved since is not taken to stand at zero") {
  const testing::Scratch scratch;
  settings::Options how = options();
  how.program.start = {0.0, 0.0, 0.0, 5.0, 0.0, 0.0};
  for (const char* const program :
       {"G0 X0 Y0 Z0\nM60\nG0 X0 Y0 Z0\nG1 X30 F500\nM2\n", "M60\nG0 X0 Y0 Z0\nG1 X30 F500\nM2\n",
        "G0 X0 Y0 Z0\nG1 X10 F500\nM60\nG0 X0 Y0 Z0\nG1 Y30\nM2\n"}) {
    INFO(program);
    const std::string path = scratch.file("a.ngc", program);
    CHECK(testing::refusal_of([&] { jobs::compensate_file(path, scratch.path("b.ngc"), how); }).code ==
          "compensate-position-unknown");
    const auto ignore = [](const jobs::SimulatedPoint&) {};
    CHECK(testing::refusal_of([&] { jobs::simulate_program(path, how, ignore); }).code == "walk-position-unknown");
  }
}
