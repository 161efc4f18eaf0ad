// SINUMERIK: codes for which the next block waits. A corrected move of several blocks has one place where that is
// right, or none.
#include <string>

#include <catch2/catch.hpp>

#include "compensate/play.hpp"

using namespace plumbline;

namespace {

const std::string kOfSinumerik = "G54 G90 G17 G710 G94 G64\nS1000 M3\nG0 X0 Y0 Z50 A0 B0 C0\nG1 F1000\n";

Job sinumerik() {
  Job job = job_of_control("siemens");
  job.settings.step.length_mm = 1;
  return job;
}

std::string code_of_cut(const std::string& line) { return code_of(kOfSinumerik + line + "\nM30\n", sinumerik()); }

}  // namespace

TEST_CASE("siemens: SPOS beside a cut of several blocks is refused, as M19 is") {
  for (const std::string line : {"X3 SPOS=90", "G1 X30 SPOS[1]=90", "G2 X10 Y0 I5 J0 SPOS=90", "X3 M70", "X3 M19"}) {
    INFO(line);
    CHECK(code_of_cut(line) == "emit-m-code");
  }
  CHECK(code_of_cut("SPOS=90\nX3").empty());
  CHECK(code_of_cut("X0.5 SPOS=90").empty());  // one block
  CHECK(code_of_cut("MCALL CYCLE81(60,50,2,45)\nX5 SPOS=90\nMCALL") == "emit-m-code");
}

TEST_CASE("siemens: WAITS waits where its block ends") {
  for (const std::string line : {"X3 WAITS", "G2 X10 Y0 I5 J0 WAITS", "X3 WAITS(1)"}) {
    const std::string text = run(kOfSinumerik + "Z49.9 SPOSA=90\n" + line + "\nG1 X0\nM30\n", sinumerik()).text;
    INFO(text);
    const std::string word = line.substr(line.find("WAITS"));
    CHECK(text.find("WAITS") == text.rfind("WAITS"));
    CHECK(text.find(word + "\nG1 X") != std::string::npos);  // its last block, and no move behind it but the next one
  }
}

TEST_CASE("siemens: M7 and M8 stand in one block, and a message behind / moves nothing") {
  CHECK(code_of_cut("M7 M8\nX3").empty());
  CHECK(code_of_cut("G1 X3 M7 M8").empty());
  CHECK(code_of_cut("/MSG(\"half way\")\nX3").empty());
  CHECK(code_of_cut("/X5\nX3") == "nc-block-delete");
}
