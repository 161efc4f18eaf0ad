// Where the lines of a guard stand in a program that begins with definitions.
#include <catch2/catch.hpp>

#include "compensate/play.hpp"

using namespace plumbline;

namespace {

std::string guarded(const std::string& text) {
  Job job = job_of_control("siemens");
  job.emit.guard = {"; plumbline guard begins", "IF R1>2", "M0", "M30", "ENDIF", "; plumbline guard ends"};
  return run(text, job).text;
}

const std::string kCuts = "G710 G90 G17 G54 G64 G94\nG0 X0 Y0 Z50 A0 B0 C0\nG1 X10 F600\nM30\n";

}  // namespace

TEST_CASE("a guard stands behind PROC and DEF, and before the first other block") {
  for (const std::string head :
       {"DEF REAL DEPTH=-15\n", "PROC PART\n", "PROC PART\nDEF INT ZAEHL\nDEF REAL WERT1,WERT2\n",
        "; made by hand\nDEF REAL WERT1=3 ; of the part\nDEF INT COUNT\n",
        "%_N_PART_MPF\n;$PATH=/_N_WKS_DIR\nN10 DEF REAL WERT1\nN20 DEF REAL WERT2\n"}) {
    INFO(head);
    const std::string out = guarded(head + kCuts);
    INFO(out);
    CHECK(out.starts_with(head + "; plumbline 0 compensated this program\n; plumbline guard begins\n"));
    CHECK(out.find("; plumbline guard ends\nG710 ") != std::string::npos);
  }
}

TEST_CASE("a guard stands at the begin where nothing is defined, and of a program that is written out") {
  CHECK(guarded(kCuts).starts_with("; plumbline 0 compensated this program\n; plumbline guard begins\n"));
  const std::string out = guarded(
      "DEF INT ZAEHL\nG710 G90 G17 G54 G64 G94\nG0 X0 Y0 Z50 A0 B0 C0\nFOR ZAEHL=1 TO 2\nG1 X=ZAEHL "
      "F600\nENDFOR\nM30\n");
  INFO(out);
  CHECK(out.starts_with("; plumbline 0 compensated this program\n; plumbline guard begins\n"));
  CHECK(out.find("DEF") == std::string::npos);
}

TEST_CASE("without a guard the stamp stands where it stood, before the definitions") {
  const std::string text = "DEF REAL DEPTH=-15\n" + kCuts;
  CHECK(run(text, job_of_control("siemens")).text.starts_with("; plumbline 0 compensated this program\nDEF "));
}
