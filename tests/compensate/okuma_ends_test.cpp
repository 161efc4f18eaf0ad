// How programs end where they are written out: RTS of a subprogram's file, RET, and the % of an archive.
#include <algorithm>
#include <string>
#include <tuple>

#include <catch2/catch.hpp>

#include "compensate/play.hpp"

using namespace plumbline;

namespace {

const std::string kOspHeader = "O1\nG15 H1\nG90 G94 G0 X0 Y0 Z50. A0 B0 C0\n";

bool warns_of_no_end(const Result& result) { return warnings_of(result.summary, "compensate-no-end") > 0; }

void check_end(const std::string& control, const std::string& text, const std::string& end) {
  const Result result = run(text, job_of_control(control));
  INFO(control << "\n" << text << "\n" << result.text);
  CHECK(result.text.ends_with(end));
  CHECK_FALSE(warns_of_no_end(result));
}

}  // namespace

TEST_CASE("a file that ends as subprograms do still does where it is written out") {
  check_end("okuma", kOspHeader + "VC1=0\nNL G1 X=VC1 F300\nVC1=VC1+1\nIF [VC1 LT 3] NL\nRTS\n", "\nRTS\n");
  check_end("okuma", kOspHeader + "CALL OA\nRTS\nOA\nG1 X5. F300\nRTS\n", "\nRTS\n");
  check_end("okuma", kOspHeader + "CALL OA Q2\nG1 Y7. F300\nN9 RTS (BACK)\nOA\nG1 X5. F300\nX0\nRTS\n",
            "\nN9 RTS (BACK)\n");
  check_end("okuma", kOspHeader + "G1 X5. F300\nRTS\n", "\nRTS\n");
  const std::string siemens = "G90 G94 G17 G71 G54 G64\nG0 X0 Y0 Z50. A0 B0 C0\n";
  check_end("siemens", siemens + "R1=0\nLOOP:\nG1 X5. F100\nX0\nR1=R1+1\nIF R1<1 GOTOB LOOP\nRET\n", "\nRET\n");
  check_end("siemens", siemens + "G1 X5. F100\nRET\n", "\nRET\n");
  check_end("siemens", siemens + "PART: G1 X5. F100\nREPEATB PART P=2\nM17\n", "\nM17\n");
  check_end("fanuc",
            "O1\nG90 G94 G21 G17 G54 G0 X0. Y0. Z50. A0. B0. C0.\nM98 P2\nG1 X1. F100.\nM99\nO2\nG1 X5. F100.\nM99\n",
            "\nM99\n");
}

TEST_CASE("an alarm of the program is an end of it") {
  const std::string fanuc = "O1\nG90 G94 G21 G17 G54 G0 X0. Y0. Z50. A0. B0. C0.\nG1 X1. F100.\n";
  const auto warned = [&](const std::string& rest) {
    return warns_of_no_end(run(fanuc + rest, job_of_control("fanuc")));
  };
  CHECK_FALSE(warned("#3000=100 (TOOL BROKEN)\nM30\n"));
  CHECK_FALSE(warned("#3000=1\n"));
  CHECK_FALSE(warned("#1=2\nIF [#1 EQ 3] GOTO 5\n#3000=7(LOOK)\nN5 M30\n"));
  CHECK(warned("#1=2\nIF [#1 EQ 2] GOTO 5\n#3000=7(LOOK)\nN5 G1 X2.\n"));
}

TEST_CASE("a missing end is told with how a subprogram ends") {
  for (const auto& [control, text, end] :
       {std::tuple{"okuma", kOspHeader + "G1 X5. F300\n", "RTS"},
        std::tuple{"siemens", std::string("G90 G94 G17 G71 G54 G64\nG0 X0 Y0 Z50. A0 B0 C0\nG1 X5. F100\n"), "RET"},
        std::tuple{"fanuc", std::string("O1\nG90 G94 G21 G17 G54 G0 X0. Y0. Z50. A0. B0. C0.\nG1 X5. F100.\n"),
                   "M99"}}) {
    const Result result = run(text, job_of_control(control));
    REQUIRE(warns_of_no_end(result));
    const auto& warnings = result.summary.warnings;
    CHECK(std::any_of(warnings.begin(), warnings.end(), [&](const Diagnostic& warning) {
      return warning.code == "compensate-no-end" && warning.help.find(end) != std::string::npos;
    }));
  }
}

TEST_CASE("a program of an OSP that is written out ends with % where it did before") {
  const Job job = job_of_control("okuma");
  const std::string loop = "VC1=0\nNL G1 X=VC1 F300\nVC1=VC1+1\nIF [VC1 LT 3] NL\nM2\n";
  CHECK(run("$POCKET.MIN%\n" + kOspHeader + loop, job).text.ends_with("\nM2\n"));
  CHECK(run("$POCKET.MIN%\n" + kOspHeader + loop + "%\n", job).text.ends_with("\nM2\n%\n"));
  CHECK(run("$POCKET.MIN%\n" + kOspHeader + loop + " %", job).text.ends_with("\nM2\n%\n"));
  CHECK(run(kOspHeader + loop, job).text.ends_with("\nM2\n"));
  CHECK(run("%\n" + kOspHeader + loop + "%\n", job).text.ends_with("\nM2\n%\n"));
}

TEST_CASE("that --start cannot say where an OSP stands is said") {
  Job job = job_of_control("okuma");
  for (const std::string text :
       {"O1\nG15 H1\nG1 X5. F300\nM2\n", "G15 H2\nG1 Y5. F300\nM2\n", "O1\nG15 H1\nG0 X5. Z50.\nG1 X9. F300\nM2\n",
        "O1\nG15 H1\nG0 X5. Y0 Z50. A0 C0\nG1 X9. F300\nG0 B0\nM2\n"}) {
    job.program.start.fill(0);
    try {
      run(text, job);
      CHECK(false);
    } catch (const Refusal& refusal) {
      INFO(refusal.diagnostic().help);
      CHECK(refusal.diagnostic().code == "compensate-position-unknown");
      CHECK(refusal.diagnostic().help.find("--start cannot say it") != std::string::npos);
    }
  }
}

TEST_CASE("what a program of an OSP calls is named as the control writes it, where it is written out") {
  const Job job = job_of_control("okuma");
  const auto names = [&](const std::string& rest, const char* part) {
    const std::string text = run(kOspHeader + rest, job).text;
    INFO(text);
    CHECK(text.find(part) != std::string::npos);
  };
  const std::string body = "VC1=3\nG1 X=VC1 F300\nRTS\n";
  names("CALL OA\nM2\nOA\n" + body, "(OA called in line 4)");
  names("CALL O0012 Q2\nM2\nO0012\n" + body, "(O0012 called in line 4, pass 2)");
  names("CALL OPKT PX=2\nM2\nOPKT\nG1 X=PX F300\nRTS\n", "(OPKT called in line 4)");
}
