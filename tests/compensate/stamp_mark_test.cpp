#include "compensate/stamp_mark.hpp"

#include <optional>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "base/files/files.hpp"
#include "base/text/characters.hpp"
#include "compensate/play.hpp"

using namespace plumbline;

namespace {

constexpr const char* kMoves =
    "G0 X0 Y0 Z20 A0 B0 C0\n"
    "G1 X20 Y10 Z0 A-12 B5 C3 F900\n"
    "G3 X-20 Y10 I-20 J15 A-5\n"
    "M2\n";

}  // namespace

TEST_CASE("a compensated program is refused") {
  const std::string once = run(kMoves, {}).text;
  CHECK(code_of(once, {}) == "compensate-stamped");
}

TEST_CASE("the mark of a compensated program counts in whatever case and wherever it stands") {
  std::string once = run(kMoves, {}).text;
  std::string loud = once;
  for (char& c : loud) c = upper(c);
  CHECK(code_of(loud, {}) == "compensate-stamped");
  std::string quiet = once;
  for (char& c : quiet) c = lower(c);
  CHECK(code_of(quiet, {}) == "compensate-stamped");
  std::string narrow = once;
  std::erase(narrow, ' ');
  CHECK(code_of(narrow, {}) == "compensate-stamped");
  const std::string mark = "(PLUMBLINE 0.1.0 COMPENSATED THIS PROGRAM)\n";
  CHECK(code_of("G0 X0 Y0 Z0 A0 B0 C0\nM2\n" + mark, {}) == "compensate-stamped");
  CHECK(code_of("o1 if [0]\n" + mark + "o1 endif\nG0 X0 Y0 Z0 A0 B0 C0\nM2\n", {}) == "compensate-stamped");
  CHECK(code_of("(plumbline compensates this program)\nG0 X0 Y0 Z0 A0 B0 C0\nM2\n", {}).empty());
}

TEST_CASE("the stamp says what share of the time of its blocks may have changed") {
  struct Example {
    std::string head;
    std::optional<double> share;
  };
  const std::string mark = "(plumbline 0.1.0 compensated this program)\n";
  const std::vector<Example> examples{
      {mark + "(method exact, friction on, step 1 deg or 1 mm, time tolerance 0.006 of a block)\nG0 X1\n", 0.006},
      {mark + "(step 1 deg or 1 mm, time)\n(.. tolerance)\n(.. 0.0061480 of a)\n(.. block)\nG0 X1\n", 0.006148},
      {"; PLUMBLINE 0.1.0 COMPENSATED THIS PROGRAM\r\n; STEP 1 DEG, TIME TOLERANCE\r\n; .. 1e-05 OF A BLOCK\r\n", 1e-5},
      {mark + "G0 X1\n", std::nullopt},
      {mark + "(time tolerance unknown)\n", std::nullopt},
      {mark + "(time tolerance inf of a block)\n", std::nullopt},
      {"(time tolerance 0.5 of a block)\n", std::nullopt},
      {"", std::nullopt},
  };
  for (const Example& example : examples) {
    INFO(example.head);
    const std::optional<double> found =
        compensate::stamped_time_tolerance(InputFile(Source::held("b.nc", example.head)));
    REQUIRE(found.has_value() == example.share.has_value());
    if (found) CHECK(*found == Approx(*example.share));
  }
}

TEST_CASE("a compensated file of a subprogram is refused in every dialect") {
  struct Example {
    std::string dialect, file, program, subprogram;
  };
  const std::vector<Example> examples{
      {"linuxcnc", "side.ngc", "G21 G90\nG0 X0 Y0 Z5 A0 B0 C0\no<side> call\nM2\n",
       "(PLUMBLINE 0.1.0 COMPENSATED THIS PROGRAM)\no<side> sub\nG1 X1 F500\no<side> endsub\n"},
      {"linuxcnc", "200.ngc", "G21 G90\nG0 X0 Y0 Z5 A0 B0 C0\nM98 P200\nM2\n",
       "O200\nG1 X1 F500\n(Plumbline 0.1.0 Compensated This Program)\nM99\n"},
      {"fanuc", "O2000", "O0001\nG21 G90\nG54 G0 X0. Y0. Z5. A0. B0. C0.\nM98 P2000\nM30\n",
       "O2000\n(PLUMBLINE 0.1.0 COMPENSATED THIS PROGRAM)\nG1 X1. F500.\nM99\n"},
      {"okuma", "OSIDE.SUB", "O1\nG15 H1\nG0 X0 Y0 Z5 A0 B0 C0\nCALL OSIDE\nM2\n",
       "(plumbline 0.1.0 COMPENSATED this program)\nOSIDE\nG1 X1 F500\nRTS\n"},
      {"siemens", "SIDE.SPF", "G54 G90 G0 X0 Y0 Z5 A0 B0 C0\nSIDE\nM30\n",
       "; PLUMBLINE 0.1.0 COMPENSATED THIS PROGRAM\nG1 X1 F500\nM17\n"},
  };
  for (const Example& example : examples) {
    const Folder folder;
    write_text(folder / example.file, example.subprogram);
    write_text(folder / "in", example.program);
    INFO(example.dialect << " " << example.file);
    const InputFile source(folder / "in");
    Job job;
    job.dialect = example.dialect;
    OutputFile out(folder / "out");
    std::string code;
    std::string file;
    try {
      compensate::Stream(source, surveyed(source, job), job.program, job.model, job.settings, job.emit, out).run();
    } catch (const Refusal& refusal) {
      code = refusal.diagnostic().code;
      file = refusal.diagnostic().place.file;
    }
    CHECK(code == "compensate-stamped");
    CHECK(file == folder / example.file);
  }
}
