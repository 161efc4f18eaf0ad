// A place in the file of a subprogram is told with that file.
#include <algorithm>

#include <catch2/catch.hpp>

#include "compensate/play.hpp"

using namespace plumbline;

namespace {

struct Done {
  compensate::Summary summary;
  std::string refused;  // "FILE:LINE message"
};

Done compensate_files(const std::string& main, const std::string& sub, const Job& job) {
  const Folder folder;
  write_text(folder / "MAIN.MPF", main);
  write_text(folder / "SUB1.SPF", sub);
  const InputFile source(folder / "MAIN.MPF");
  Done done;
  try {
    OutputFile out(folder / "OUT.MPF");
    done.summary =
        compensate::Stream(source, surveyed(source, job), job.program, job.model, job.settings, job.emit, out).run();
    out.commit();
  } catch (const Refusal& refusal) {
    const Place& place = refusal.diagnostic().place;
    done.refused = std::filesystem::path(place.file).filename().string() + ":" + std::to_string(place.line) + " " +
                   refusal.diagnostic().message;
  }
  return done;
}

bool is_of(const std::string& file, const std::string& name) { return file.ends_with(name); }

const std::string kMain = "G710 G90 G17 G54 G64 G94\nG0 X0 Y0 Z50 A0 B0 C0\n";

}  // namespace

TEST_CASE("figures and warnings of a subprogram's file name it") {
  const Job job = job_of_control("siemens");
  const std::string sub = "; one\n; two\n; three\n; four\nPROC SUB1\nG1 X1 F6000\nY20 Z10\nX1.01\nM17\n";
  const Done done = compensate_files(kMain + "SUB1\nM30\n", sub, job);
  REQUIRE(done.refused.empty());
  const compensate::Summary& s = done.summary;
  CHECK(is_of(s.correction_mm.file, "SUB1.SPF"));
  CHECK(s.zero_error_line == 6);
  CHECK(is_of(s.zero_error_file, "SUB1.SPF"));
  CHECK(s.short_pieces.line == 8);
  CHECK(is_of(s.short_pieces.file, "SUB1.SPF"));
  const auto warning = std::find_if(s.warnings.begin(), s.warnings.end(),
                                    [](const Diagnostic& w) { return w.code == "compensate-short-pieces"; });
  REQUIRE(warning != s.warnings.end());
  CHECK(is_of(warning->place.file, "SUB1.SPF"));
  CHECK(warning->place.line == 8);
}

TEST_CASE("figures of the program's own file name none") {
  const Job job = job_of_control("siemens");
  const Done done = compensate_files(kMain + "G1 X20 Y30 Z20 F600\nSUB1\nG1 X.01 F6000\nM30\n",
                                     "PROC SUB1\nG0 X0 Y0 Z50\nM17\n", job);
  REQUIRE(done.refused.empty());
  CHECK(done.summary.zero_error_line == 3);
  CHECK(done.summary.zero_error_file.empty());
  CHECK(done.summary.short_pieces.line == 5);
  CHECK(done.summary.short_pieces.file.empty());
  CHECK(done.summary.condition.file.empty());
}

TEST_CASE("a call with values is told with the file of its line, at the first block of what it calls") {
  const Job job = job_of_control("siemens");
  const std::string few = compensate_files(kMain + "SUB1(1,2)\nM30\n", "PROC SUB1(REAL WERT)\nX1\nM17\n", job).refused;
  INFO(few);
  CHECK(few.starts_with("SUB1.SPF:1 SUB1 is called in line 3 of "));
  CHECK(few.find("MAIN.MPF with 2 values, and takes 1") != std::string::npos);
  const std::string none = compensate_files(kMain + "SUB1(1)\nM30\n", "; a\nG0 X1\nX2\nM17\n", job).refused;
  INFO(none);
  CHECK(none.starts_with("SUB1.SPF:2 SUB1 is called in line 3 of "));
  CHECK(none.find("MAIN.MPF with values, and has no PROC") != std::string::npos);
}

TEST_CASE("an axis that one file leaves beyond its limit is told with the file that goes on") {
  const Job job = job_of_control("siemens");
  const std::string refused =
      compensate_files(kMain + "SUPA G0 Z=5000\nSUB1\nM30\n", "PROC SUB1\nG0 X1\nG1 Y2 F100\nM17\n", job).refused;
  INFO(refused);
  CHECK(refused.starts_with("MAIN.MPF:3 "));
  CHECK(refused.find("where this block leaves it and line 2 of ") != std::string::npos);
  CHECK(refused.find("SUB1.SPF goes on") != std::string::npos);
}
