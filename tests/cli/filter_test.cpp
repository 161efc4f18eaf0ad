// What LinuxCNC's AXIS does with the line [FILTER] nc = plumbline compensate -q -o -: it has a shell run the command
// with the file's name in quotes behind it, without standard input, and takes standard output (filter_program in axis).
#include <catch2/catch.hpp>

#include "cli/program.hpp"

using namespace plumbline::testing;

namespace {

Outcome filter(const Scratch& scratch, const std::string& name) {
  return run(scratch, "compensate -q -o - '" + scratch.path(name) + "' </dev/null", "AXIS_PROGRESS_BAR=1");
}

// A folder of a machine's files, and settings that name them.
void write_machine(const Scratch& scratch) {
  REQUIRE(run(scratch, "control linuxcnc -o . --work-offset G54=0,0,-1008,0,0,0 " + kModel).code == 0);
  scratch.file("hexapod.tbl", "T1 P1 D+6.0 Z+85.0 ;end mill\n");
  scratch.file("plumbline.toml", "plumbline = \"settings 1\"\nmodel = \"" + source_file("models/pm600-like.toml") +
                                     "\"\ntools = \"hexapod.tbl\"\nvariables = \"hexapod.var\"\nguard = true\n");
}

}  // namespace

TEST_CASE("a filter of LinuxCNC's gives the program, with the control's own tools and offsets") {
  const Scratch scratch;
  write_machine(scratch);
  scratch.file("it's a part.nc", "T1 M6\nG43\n" + std::string(kPart));
  const Outcome quoted = run(scratch, "compensate -q -o - 'it'\\''s a part.nc' </dev/null", "AXIS_PROGRESS_BAR=1");
  INFO(quoted.err);
  CHECK(quoted.code == 0);
  CHECK(contains(quoted.out, "(G54 X0 Y0 Z-1008 A0 B0 C0)"));
  CHECK(contains(quoted.out, "85"));
  scratch.file("tools.toml", "plumbline = \"tools 1\"\n[[tool]]\nnumber = 1\nlength_mm = 85\ndiameter_mm = 6\n");
  const Outcome same = run(scratch, "compensate -q -o - --tools tools.toml 'it'\\''s a part.nc'");
  CHECK(same.out == quoted.out);
}

TEST_CASE("a filter tells its progress as AXIS reads it") {
  const Scratch scratch;
  write_machine(scratch);
  std::string program = "G21 G90 G94\nG0 X0 Y0 Z5 A0 B0 C0\nF1000\n";
  for (int i = 0; i < 20000; ++i) program += "G1 X" + std::to_string(i % 7) + ".5 Y" + std::to_string(i % 3) + "\n";
  scratch.file("long.nc", program + "M2\n");
  const Outcome outcome = filter(scratch, "long.nc");
  INFO(outcome.err.substr(0, 2000));
  CHECK(outcome.code == 0);
  CHECK(contains(outcome.err, "FILTER_PROGRESS="));
  CHECK(outcome.err.find("FILTER_PROGRESS=") == 0);
  CHECK_FALSE(contains(outcome.err, "error"));
}

TEST_CASE("a filter that refuses says why, and gives no program") {
  const Scratch scratch;
  write_machine(scratch);
  scratch.file("bad.nc", "G21 G90 G94\nG0 X0 Y0 Z5 A0 B0 C0\nG1 X1 X2 F100\nM2\n");
  const Outcome outcome = filter(scratch, "bad.nc");
  CHECK(outcome.code == 1);
  CHECK(outcome.out.empty());
  CHECK(contains(outcome.err, "bad.nc:3:"));
  scratch.file("again.nc", filter(scratch, "bad.nc").out + "(plumbline 0.1.0 compensated this program)\n" + kPart);
  CHECK(contains(filter(scratch, "again.nc").err, "[compensate-stamped]"));
}
