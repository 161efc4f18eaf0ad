// Rapids of an OSP that only the machine follows, in programs that are compensated.
#include <string>

#include <catch2/catch.hpp>

#include "compensate/play.hpp"

using namespace plumbline;

namespace {

const std::string kHeaderOfOsp = "O1\nG15 H1\nG90 G94 G0 X0 Y0 Z50. A0 B0 C0\n";

Job osp_with_tool() {
  Job job = job_of_control("okuma");
  job.program.tools = one_tool(1);
  return job;
}

bool stands_in(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE(
    "between two sections in tool-tip mode a program of an OSP goes on, and is corrected once its length is known") {
  const Job job = osp_with_tool();
  const std::string section = "G169 X0 Y0 Z50. A0 B0 C0 H1\nG1 Z40. F100\nG0 Z9999\nG170\n";
  const std::string change = "T1 M6\nG15 H1\nG0 A0. B0. C0.\nG0 X5. Y5.\n";
  const std::string text = run(kHeaderOfOsp + section + change + "G0 G56 Z50. H1\nG1 Z40. F100\nM2\n", job).text;
  INFO(text);
  CHECK(stands_in(text, "G170\n" + change + "G0 G56 Z"));
  CHECK_FALSE(stands_in(text, "G56 Z50. H1"));
  CHECK(stands_in(run(kHeaderOfOsp + section + change + section + "M2\n", job).text,
                  "G170\n" + change + "G169 X0 Y0 Z50."));
  const std::string twice = run(kHeaderOfOsp + "CALL OA Q2\nM2\nOA\n" + section + change + "RTS\n", job).text;
  INFO(twice);
  CHECK(twice.rfind("G170\n" + change) > twice.find("G170\n" + change));
  CHECK(stands_in(run(kHeaderOfOsp + section + "G0 A5.\nG56 H1\nG0 X0 Y0 Z50.\nG1 X6. F100\nM2\n", job).text,
                  "G0 A5.\nG56 H1"));
  std::size_t line = 0;
  const std::string tilted = kHeaderOfOsp + section + "G0 X5. Y5. A5.\nG56 H1\nG0 Z50.\nG1 X6. F100\nM2\n";
  CHECK(code_of(tilted, job, &line) == "compensate-position-unknown");
  CHECK(line == 11);
  const std::string little = "G169 X0 Y0 Z50. A0.05 B0 C0 H1\nG1 Z40. F100\nG170\n";
  CHECK(code_of(kHeaderOfOsp + little + "G56 H1\nG0 Z50.\nG1 X6. F100\nM2\n", job, &line) ==
        "compensate-position-unknown");
  CHECK(line == 9);
  CHECK(code_of(kHeaderOfOsp + little + "G56 H1\nG0 X0 Y0 Z50.\nG1 X6. F100\nM2\n", job).empty());
}

TEST_CASE("a header of an OSP that turns A, B and C home before its first work system goes through as it stands") {
  const Job job = osp_with_tool();
  const std::string header = "O1001\nG90 G94 G17\nG90 G00 Z9999.\nG00 A0. B0. C0.\nT1 M06\nG15 H01\n";
  const std::string text =
      run(header + "G00 A0. B0. C0.\nG00 X10. Y10.\nG00 G56 Z50. H01\nG01 Z5. F100.\nM02\n", job).text;
  INFO(text);
  CHECK(stands_in(text, "\nG90 G00 Z9999.\nG00 A0. B0. C0.\nT1 M06\n"));
  CHECK(stands_in(text, "G00 G56 Z50.0"));
  CHECK_FALSE(stands_in(text, "G01 Z5. "));
  std::size_t line = 0;
  CHECK(code_of(header + "G00 X10. Y10.\nG00 G56 Z50. H01\nG01 Z5. F100.\nM02\n", job, &line) ==
        "compensate-position-unknown");
  CHECK(line == 9);
  CHECK(code_of("G0 C90.\nG15 H1\nG0 X0 Y0 Z50. A0 B0\nG1 X5. F100\nM2\n", job) == "compensate-position-unknown");
  CHECK(code_of("G0 C90.\nG15 H1\nG0 X0 Y0 Z50. A0 B0 C0\nG1 X5. F100\nM2\n", job).empty());
}

TEST_CASE(
    "a retract of an OSP to the end of the travel goes through as it stands, and what it leaves unknown is not cut") {
  const Job job = osp_with_tool();
  const std::string cut = "G1 X5. F100\n";
  const std::string change = "M5\nG16 H00 G00 Z=VPSLZ\nT1 M6\nG15 H1\n";
  const std::string text =
      run(kHeaderOfOsp + cut + change + "G0 X5. Y5. A0 B0 C0\nG56 Z50. H1\nG1 Z40. F100\nM2\n", job).text;
  INFO(text);
  CHECK(stands_in(text, "\n" + change));
  CHECK(
      stands_in(run(kHeaderOfOsp + "VC1=5\nG1 X=VC1 F100\nG16 H0 G0 Z=VPSLZ\nIF [VC1 EQ 5] N9\nX9.\nN9 M2\n", job).text,
                "\nG16 H0 G0 Z=VPSLZ\n"));
  const std::string before = "G0 Z=VPSLZ\nG15 H1\nM11\nM27\nG90 G00 A0. B0. C0.\nX0. Y0.\n";
  CHECK(stands_in(run("O1\n" + before + "G0 G56 Z50. H1\n" + cut + "M2\n", job).text, "\n" + before.substr(0, 30)));
  std::size_t line = 0;
  CHECK(code_of(kHeaderOfOsp + "G0 Z=VPSLZ\n" + cut + "M2\n", job, &line) == "compensate-position-unknown");
  CHECK(line == 5);
  CHECK(code_of(kHeaderOfOsp + "G16 H0 G0 Z=VPSLZ\n" + cut + "M2\n", job, &line) == "compensate-position-unknown");
  CHECK(line == 5);
}
