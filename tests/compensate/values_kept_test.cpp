// What a control keeps beside positions (F, the motion code, modes) has in the output the value that the original has,
// wherever a program looks at it.
#include <catch2/catch.hpp>

#include "compensate/play.hpp"

using namespace plumbline;

namespace {

const std::string kSpinning = "G21 G90 G54 G94 G17\nM3 S500\nG0 X0 Y0 Z5 A0 B0 C0\n";

}  // namespace

TEST_CASE("a program that reads F, the motion code or the way back is written out with what it reads") {
  const Job job = without_friction();
  const auto text_of = [&](const std::string& text) { return run(kSpinning + text, job).text; };
  CHECK(text_of("G1 Y1 F100\nX1\nG10 L2 P2 X[#<_feed>]\nG1 X2\nM2\n").find("G10 L2 P2 X100\n") != std::string::npos);
  CHECK(
      text_of("F100\nG81 X1 Y1 Z4 R5\n#1=#<_motion_mode>\nG10 L2 P2 Z[#1/100]\nG1 X3\nM2\n").find("G10 L2 P2 Z8.1\n") !=
      std::string::npos);
  CHECK(
      text_of("F100 G99\nG81 X1 Y1 Z4 R5\nG80\nG10 L2 P2 Z[#<_retract_r_plane>]\nG1 X3\nM2\n").find("G10 L2 P2 Z1\n") !=
      std::string::npos);
  for (const std::string tail :
       {"#<old>=#<_feed>\nF50\nG1 Y2\nF#<old>\nG1 X4 Y4\nX5 Y5\nM2\n", "G4 P[#<_feed>/100]\nG1 X3\nM2\n",
        "S[#<_feed>*10]\nG1 X[#<_feed>/100]\nM2\n", "F[#<_feed>*2]\nG1 X4\nM2\n"}) {
    INFO(tail);
    const std::string text = kSpinning + "F100\nG1 X1 Y1\n" + tail;
    const Result result = run(text, job);
    CHECK(result.summary.unrolled);
    CHECK(play(text, result.text, job).time_change <= 1e-3);
  }
}

TEST_CASE("modes that M70 keeps are those of the original, F with all its decimals") {
  const Job job;  // friction makes F of pieces differ
  for (const std::string feed : {"12.345", "333.33", "12.35", "80.55", "120.45"}) {
    INFO(feed);
    const std::string text = kSpinning + "F" + feed + "\nG1 X5 Y-3\nM70\nX7\nM72\nX8 Y2\nM2\n";
    const Result result = run(text, job);
    INFO(result.text);
    CHECK(play(text, result.text, job).time_change <= 1e-3);
    const std::size_t kept = result.text.find("M70\n");
    const std::size_t before = result.text.rfind('F', kept);
    CHECK(result.text.substr(before, feed.size() + 2) == "F" + feed + "\n");
  }
}

TEST_CASE("a cycle that begins below R where nobody knows where the tool stands is refused") {
  Job job = without_friction();
  job.program.keeps_position = {6};
  for (const std::string unknown : {"M60\nG0 Z5\n", "G38.2 X3 F10\nG0 Z5\n", "M60\nG0 Z5 A0 B0 C0\nG0 X2\n"}) {
    INFO(unknown);
    std::size_t line = 0;
    CHECK(code_of(kSpinning + unknown + "F100\nG98 G81 X-3 Y-5 Z-1 R10\nX20\nG80\nM2\n", job, &line) ==
          "nc-position-unknown");
    CHECK(line == 5 + static_cast<std::size_t>(std::count(unknown.begin(), unknown.end(), '\n')));
    CHECK(code_of(kSpinning + unknown + "G0 X1 Y1 Z5 A0 B0 C0 F100\nG98 G81 X-3 Y-5 Z-1 R10\nX20\nG80\nM2\n", job)
              .empty());
  }
}

TEST_CASE("a program that reaches (ABORT, text) is refused, one that goes past it is not") {
  const std::string loop = "#1=3\no1 while [#1 GT 0]\nG1 X#1 F100\no2 if [#1 EQ 2]\n";
  CHECK(code_of(kSpinning + loop + "(ABORT, too deep)\no2 endif\n#1=[#1-1]\no1 endwhile\nM2\n", without_friction()) ==
        "nc-not-interpreted");
  CHECK(code_of(kSpinning + "G1 X1 F100 ( abort,x)\nM2\n", without_friction()) == "nc-not-interpreted");
  CHECK(code_of(kSpinning + "G1 X1 F100\n(one) (Abort, two)\nM2\n", without_friction()) == "nc-not-interpreted");
  for (const std::string goes_on : {"(ab ort, x)\n", "; abort, x\n", "(abort, x) (y)\n", "(aborted)\n",
                                    "#1=3\no2 if [#1 EQ 2]\n(ABORT, too deep)\no2 endif\n"}) {
    INFO(goes_on);
    CHECK(code_of(kSpinning + goes_on + "G1 X1 F100\nM2\n", without_friction()).empty());
  }
}

TEST_CASE("after M0 and M1 a LinuxCNC stands where it stood, after M60 nobody knows") {
  for (const std::string stop : {"M0 (MEASURE)\n", "M1\n", "M5\nM0\nM3 S500\n"}) {
    INFO(stop);
    CHECK(code_of(kSpinning + stop + "G0 Z2\nG1 Z-2 F100\nM2\n", without_friction()).empty());
  }
  CHECK(code_of(kSpinning + "M60\nG0 Z2\nG1 Z-2 F100\nM2\n", without_friction()) == "compensate-position-unknown");
}

TEST_CASE("a move of no length takes no time under G93 as well") {
  const std::string text = kSpinning + "G93 G1 X0 F0.1\nX5 F10\nX5 F0.1\nG94 F100 X2\nX2\nM2\n";
  for (const bool friction : {false, true}) {
    Job job;
    job.settings.friction = friction;
    const Result result = run(text, job);
    INFO(result.text);
    CHECK(play(text, result.text, job).time_change <= 1e-3);
    CHECK(result.summary.seconds_before < 10);
    CHECK(result.summary.seconds_after < 10);
    CHECK(result.text.find("F0.0") == std::string::npos);
  }
}

TEST_CASE("what stands beside a call or the end of a subprogram is written once, as it stands") {
  struct Case {
    const char* dialect;
    std::string text;
    std::vector<std::string> lines;  // of the output
    const char* none;                // what nobody wrote
  };
  const std::string fanuc = "G54 G0 X0. Y0. Z50. A0. B0. C0. S600 M3\n";
  const std::string siemens = "G54 G17 G90 G710 G94 G64\nG0 X0 Y0 Z60 A0 B0 C0 S500 M3\n";
  for (const Case& of :
       {Case{"fanuc",
             "O0001\nG90 G21 G17 G94 M98 P1000\nM30\nO1000\n" + fanuc + "G1 X10. F300.\nG17 G94 M99\n",
             {"\nG90 G21 G17 G94\n", "\nG17 G94\n"},
             "P0"},
        Case{"fanuc",
             "O0001\nG90 G21 G17\n" + fanuc + "G61\nG64 M98 P50\nG0 X9.\nM30\nO50\nG1 X10. F300.\nS900 G64 M99\n",
             {"\nG61\nG64\n", "\nS900 G64\n"},
             "S900."},
        Case{"siemens",
             siemens + "UPA1\nG1 X60 Y20 F500\nM30\n%_N_UPA1_SPF\nG0 X5\nG642 M19 M17\n",
             {"\nG642 M19\n"},
             "M5"},
        Case{"siemens",
             siemens + "G60\nUPA1\nG1 X60 F500\nM30\n%_N_UPA1_SPF\nG0 X5\nADIS=0.1 G641 M17\n",
             {"\nADIS=0.1 G641\n"},
             "G64 "}}) {
    INFO(of.text);
    Job job;
    job.dialect = of.dialect;
    job.settings.friction = false;
    const std::string out = run(of.text, job).text;
    INFO(out);
    for (const std::string& line : of.lines) CHECK(out.find(line) != std::string::npos);
    const std::string body = out.substr(out.find("X0"));
    CHECK(body.substr(body.find('\n')).find(of.none) == std::string::npos);
  }
}

TEST_CASE("whether S is the speed of the surface comes back where the program is written out") {
  const Job job = without_friction();
  const auto holds = [&](const std::string& text, const std::string& line) {
    const Result result = run(kSpinning + text, job);
    INFO(result.text);
    CHECK(result.summary.unrolled);
    CHECK(result.text.find(line) != std::string::npos);
  };
  holds("F200 S1000\no1 sub\nM73\nD2000 S77 G96 F300\nG1 X5\no1 endsub\no1 call\nG1 X9\nM5\nM2\n", "F200 G97 S1000\n");
  holds("F200\nG96 D2000 S77\nM70\no1 repeat [1]\nG97 S500\nG1 X5\no1 endrepeat\nM72\nG1 X9\nM2\n", "G96 S77\n");
  holds("F300 S900\nM98 P7 L2\nG1 X5\nM2\nO7\nM73\nG96 S50\nG1 X1\nM99\n", "G97 S900\n");
}
