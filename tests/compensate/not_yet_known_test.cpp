// Rapids before the control's state is settled: the edge after a change of tools, the motion code, where home is.
#include <regex>

#include <catch2/catch.hpp>

#include "compensate/play.hpp"

using namespace plumbline;

namespace {

Job kept_over_changes(const std::string& dialect) {
  Job job;
  job.dialect = dialect;
  job.settings.friction = false;
  job.program.keeps_position = {6};
  job.program.tool_in_spindle = 1;
  job.program.tools = one_tool(0);
  return job;
}

bool finds(const std::string& text, const std::string& pattern) {
  return std::regex_search(text, std::regex(pattern, std::regex::multiline));
}

// From the first cut on.
std::string cuts_of(const std::string& text) { return text.substr(text.find("\nG1 ")); }

}  // namespace

TEST_CASE("until D is written after a change of tools, rapids in X and Y go through as they stand") {
  const Job job = kept_over_changes("siemens");
  const std::string start = "G54 G17 G710 G90 G94\nG0 X0 Y0 Z80 A0 B0 C0\n";
  const std::string rest = "G1 Z30 F300\nX40 F800\nG0 Z60\nM30\n";
  const std::string settled = run(start + "T1\nM6\nD1\nG0 X10 Y5.5\nZ40\n" + rest, job).text;
  for (const std::string change :
       {"D0\nT1\nM6\nS800 M3\nN22 G0 X10 Y5.5\nM8\nG0 Z40 D1\n",
        "G0 SUPA Z-900 D0\nT1 M6\nX3\nN22 G0 X10 Y5.5\nG0 Z40 D1\n", "D0\nT1\nM6\nN22 G0 X10 Y5.5\nD1\nG0 Z40\n"}) {
    INFO(change);
    const std::string out = run(start + change + rest, job).text;
    INFO(out);
    CHECK(finds(out, "^N22 G0 X10 Y5.5$"));
    CHECK(finds(out, "^G0 Z[0-9.]+ X[0-9.]+ Y[0-9.]+ "));
    CHECK(cuts_of(out) == cuts_of(settled));
  }
  CHECK(code_of(start + "D0\nT1\nM6\nG1 X10 F300\nM30\n", job) == "compensate-position-unknown");
  const std::string turned = run(start + "D0\nT1\nM6\nN22 G0 A0 B0 C0\nX10 Y5.5\nG0 Z40 D1\n" + rest, job).text;
  CHECK(finds(turned, "^N22 G0 A0 B0 C0$"));
  CHECK(cuts_of(turned) == cuts_of(settled));
}

TEST_CASE("until G43 is written after a way home, rapids of X, Y and the turns go through as they stand") {
  Job job = kept_over_changes("fanuc");
  for (auto& axis : job.program.start) axis = 0;
  const std::string start = "O0001\nG21 G90 G40 G49 G80\nG54 G0 X0 Y0 A0 B0 C0\nG43 H1 Z80.\nG91 G28 Z0\nG90\n";
  const std::string rest = "G1 Z30. F300.\nX40. F800.\nG0 Z60.\nM30\n";
  const std::string settled = run(start + "G43 H1 Z50.\nG0 X10. Y5.5 A2. B0 C0\nZ40.\n" + rest, job).text;
  for (const std::string change :
       {"N22 G0 X10. Y5.5 A2. B0 C0\nG43 H1 Z40.\n", "N22 G0 A2. B0 C0\nX10. Y5.5\nG43 H1 Z40.\n",
        "G0 X3. A1.\nN22 X10. Y5.5 A2. B0 C0\nS1000 M3\nG43 H1 Z40.\n"}) {
    INFO(change);
    const std::string out = run(start + change + rest, job).text;
    INFO(out);
    CHECK(finds(out, "^N22 (G0 )?(X10. Y5.5 )?A2. B0 C0$"));
    CHECK(cuts_of(out) == cuts_of(settled));
  }
  CHECK(code_of(start + "G1 A2. F300.\nM30\n", job) == "nc-not-interpreted");
  CHECK(code_of(start + "G0 Z20.\nM30\n", job) == "nc-not-interpreted");
}

TEST_CASE("a change of the length of a tilted tool leaves X, Y and Z to be stated") {
  const Job job = kept_over_changes("siemens");
  const std::string start = "G54 G17 G710 G90 G94\nG0 X0 Y0 Z80 A5 B0 C0 D0\n";
  for (const std::string cut : {"D1\nG1 Y5 F100\nM30\n", "D1\nG0 X0 Y0\nG1 Y5 F100\nM30\n",
                                "D1\nG0 Z30\nG1 Y5 F100\nM30\n", "G0 X0 D1\nG1 X5 Y0 F100\nM30\n"}) {
    INFO(cut);
    CHECK(code_of(start + cut, job) == "compensate-position-unknown");
  }
  for (const std::string tilt : {"A0.05 B0", "A0 B-0.09", "A0.002 B0.001"}) {  // the program's own, however small
    INFO(tilt);
    const std::string head = "G54 G17 G710 G90 G94\nG0 X0 Y0 Z80 " + tilt + " C0 D0\nD1\n";
    CHECK(code_of(head + "G1 Y5 F100\nM30\n", job) == "compensate-position-unknown");
    CHECK(code_of(head + "G0 X0 Y0\nG1 Y5 F100\nM30\n", job) == "compensate-position-unknown");
    CHECK(code_of(head + "G0 X0 Y0\nZ30\nG1 Y5 F100\nM30\n", job).empty());
  }
  CHECK(code_of("G54 G17 G710 G90 G94\nG0 X0 Y0 Z80 A0 B0 C0 D0\nD1\nG1 Y5 F100\nM30\n", job).empty());
  const std::string out = run(start + "D1\nN9 G0 X1 Y2\nZ30\nG1 Y5 F100\nM30\n", job).text;
  CHECK(finds(out, "^N9 G0 X1 Y2$"));
  CHECK(finds(out, "^Z[0-9.]+ "));
}

TEST_CASE("axis words before the first motion code and F are rapids, in the output too") {
  Job job = kept_over_changes("fanuc");
  for (auto& axis : job.program.start) axis = 0;
  const std::string start = "O0001\nG21 G90 G40 G49 G80\n";
  const std::string rest = "G1 Z5. F300.\nX20. F600.\nM30\n";
  for (const std::string head : {"G90 G43 H1 Z50.\nG0 X-60. Y0.\n", "G54 X10. Y20. S2000 M3\nG43 H1 Z50.\nX12. A1.\n",
                                 "G80 Z5.\nG90 X5.\nG43 H1 Z40.\n"}) {
    INFO(head);
    const std::string out = run(start + head + rest, job).text;
    INFO(out);
    CHECK(cuts_of(out) == cuts_of(run(start + "G0\n" + head + rest, job).text));
    CHECK(moves_of(out, job.program, job.dialect).front().motion.kind == nc::MotionKind::rapid);
  }
  CHECK(code_of(start + "F200.\nG43 H1 Z50.\nM30\n", job) == "nc-axes-unused");
  CHECK(code_of(start + "G43 H1 Z50.\nZ5. F200.\nM30\n", job) == "nc-axes-unused");
  job.dialect = "okuma";
  CHECK(code_of("G15 H1\nG56 H1 Z50\nM2\n", job) == "nc-axes-unused");
}

TEST_CASE("after G28 without axes nobody knows where they stand") {
  const Job job = kept_over_changes("fanuc");
  const std::string start = "O0001\nG21 G90 G17 G40 G49 G80\n";
  const std::string rest = "G0 X-10. Y-10. S2000 M3\nG43 H1 Z20.\nG1 Z-2. F300.\nX20. F600.\nG0 Z20.\nG49 M9\nM30\n";
  for (const std::string home : {"G28", "G30", "G28 M5"}) {
    INFO(home);
    const std::string out = run(start + home + "\n" + rest, job).text;
    INFO(out);
    CHECK(finds(out, "^" + home + "$"));
    CHECK(finds(out, "^G0 X-10. Y-10. S2000 M3$"));  // Z is not known yet
    CHECK(cuts_of(out) == cuts_of(run(start + rest, job).text));
    const std::string placed = start + "G0 X0. Y0. Z20. A0. B0. C0.\n";
    CHECK(code_of(placed + home + "\nG1 X5. F100.\nM30\n", job) == "compensate-position-unknown");
    CHECK(code_of(placed + "G43 H1 Z20.\n" + home + "\nG0 X5.\nM30\n", job) == "nc-axes-missing");
  }
}

TEST_CASE("a cut may begin where a turn of the coordinates left the axes, if it names X and Y") {
  const auto check_same = [](const std::string& turned, const std::string& plain, const Job& job) {
    INFO(turned);
    const auto after_turn = moves_of(run(turned, job).text, job.program, job.dialect);
    const auto unturned = moves_of(run(plain, job).text, job.program, job.dialect);
    REQUIRE(after_turn.size() == unturned.size());
    CHECK(after_turn.size() > 8);
    for (std::size_t i = 0; i < after_turn.size(); ++i) {
      for (const Axis axis : kAllAxes) {
        CHECK(after_turn[i].motion.machine[axis] == Approx(unturned[i].motion.machine[axis]).margin(0.004));
      }
    }
  };
  Job job = kept_over_changes("siemens");
  const std::string start = "G54 G17 G710 G90 G94\nG0 X10 Y10 Z80 A0 B0 C0\n";
  for (const std::string turn : {"AROT RPL=30\n", "TRANS X0\nROT Z30\n", "ROT RPL=20\nAROT Z10\n"}) {
    check_same(start + turn + "G1 X5 Y5 F300\nX9 Y-2\nTRANS\nX1 Y2 F500\nM30\n",
               start + "G1 X1.830127 Y6.830127 F300\nX8.794229 Y2.767949\nX1 Y2 F500\nM30\n", job);
  }
  CHECK(code_of(start + "AROT RPL=30\nG1 X5 F300\nM30\n", job) == "compensate-position-unknown");
  CHECK(code_of(start + "AROT RPL=30\nM0\nG1 X5 Y5 F300\nM30\n", job) == "compensate-position-unknown");
  CHECK(code_of(start + "AROT RPL=30\nG0 X3\nG1 X5 Y5 F300\nM30\n", job) == "compensate-position-unknown");
  job.dialect = "fanuc";
  const std::string head = "O1\nG54 G90\nG0 X10. Y10. Z80. A0. B0. C0.\n";
  check_same(head + "G68 X0. Y0. R30.\nG1 X5. Y5. F300.\nX9. Y-2.\nG69\nX1. Y2. F500.\nM30\n",
             head + "G1 X1.830 Y6.830 F300.\nX8.794 Y2.768\nX1. Y2. F500.\nM30\n", job);
}

TEST_CASE("until G43 is written after G28, G30 and G53 of Z, rapids in X and Y go through as they stand") {
  const Job job = kept_over_changes("fanuc");
  const std::string start = "O0001\nG21 G90 G17 G40 G49 G80\nG54 G0 X0. Y0. A0. B0. C0.\nG43 H1 Z60.\n";
  const std::string rest = "G43 H1 Z20.\nG1 Z-2. F300.\nX20. F600.\nG0 Z20.\nM30\n";
  const std::string settled = run(start + "G0 X10. Y5.5\n" + rest, job).text;
  for (const std::string home : {"G91 G28 Z0.\nG90", "G91 G30 Z0.\nG90", "G53 Z-850.", "G53 G0 Z-850.\nM8"}) {
    INFO(home);
    const std::string out = run(start + home + "\nN22 G0 X10. Y5.5\n" + rest, job).text;
    INFO(out);
    CHECK(finds(out, "^N22 G0 X10. Y5.5$"));
    CHECK(finds(out, "^G43 H1 Z20\\.0[0-9]+ X"));
    CHECK(cuts_of(out) == cuts_of(settled));
    CHECK(code_of(start + home + "\nG0 X10. Y5.5 Z20.\nM30\n", job) == "nc-not-interpreted");
    CHECK(code_of(start + home + "\nG1 A5. F300.\nM30\n", job) == "nc-not-interpreted");
    CHECK(code_of(start + home + "\nG1 X10. F300.\nM30\n", job) == "compensate-position-unknown");
  }
  // a Haas ends it at any G28
  CHECK(code_of(start + "G91 G28 X0. Y0.\nG90 G0 X10. Y5.5 Z20.\nM30\n", job) == "nc-not-interpreted");
  const std::string aside = run(start + "G91 G28 X0. Y0.\nG90 G0 X10. Y5.5\nG43 H1 Z20.\nM30\n", job).text;
  CHECK(finds(aside, "^G43 H1 Z20.0[0-9]+ X9.99[0-9] Y5.49[0-9] "));
}

TEST_CASE(
    "a cut after a stop is refused with the stop as its cause, and read where the option says that nothing moves") {
  Job job = kept_over_changes("fanuc");
  const std::string start = "G21 G90 G94 G54\nG0 X0 Y0 Z50. A0 B0 C0\n";
  const std::string cut = "G1 X5. F100.\nM30\n";
  const auto said = [&](const std::string& text) {
    try {
      run(text, job);
    } catch (const Refusal& refusal) {
      return refusal.diagnostic().message + " | " + refusal.diagnostic().help;
    }
    return std::string();
  };
  struct Stopped {
    std::string blocks, stop, option;
  };
  for (const Stopped& c : {Stopped{"M0\n", "after M0 in line 3", "--keeps-position M0"},
                           {"X3.\nM1\n", "after M1 in line 4", "--keeps-position M1"},
                           {"#3006=1(LOOK)\n", "after #3006 in line 3", "--keeps-position M0"},
                           {"M0\nG0 X5. Y5.\nZ3. A0\n", "B, C stands is not known after M0 in line 3", "M0"}}) {
    INFO(c.blocks);
    job.program.keeps_position = {6};
    const std::string text = start + c.blocks + cut;
    INFO(said(text));
    CHECK(said(text).find(c.stop) != std::string::npos);
    CHECK(said(text).find(c.option) != std::string::npos);
    job.program.keeps_position = {0, 1};
    CHECK(said(text).empty());
  }
  job.program.keeps_position = {};
  CHECK(said(start + "T1 M6\n" + cut).find("after M6 in line 3") != std::string::npos);
  CHECK(said(start + "M0\nG0 X0 Y0 Z50. A0 B0 C0\n" + cut).empty());
  CHECK(said("G21 G90 G94 G54\nG0 X0 Y0 A0 B0 C0\nM0\n" + cut).find("M0") != std::string::npos);
  CHECK(said("G21 G90 G94 G54\nG0 X0 Y0 A0 B0 C0\n" + cut).find("not known here") != std::string::npos);
}

TEST_CASE("a refusal names what lost the position on a SINUMERIK, and a way out that is one") {
  Job job = kept_over_changes("siemens");
  const std::string head = "G54 G17 G710 G90 G94\nG0 X0 Y0 Z60 A0 B0 C0\nG1 X5 F100\n";
  struct Lost {
    std::string text, cause, way;
  };
  job.program.passed_m_codes = {88};
  for (const Lost& c :
       {Lost{"G54 G17 G710 G90 G94\nT1 M6\nD1\nG0 X0 Y0 Z50 A5 B0 C0\nD0\nG1 X8 F100\nM30\n",
             "after the change of the tool's length under a tilt in line 5", "while A, B and C stand at zero"},
        Lost{head + "M88\nX8\nM30\n", "after M88 in line 4", "--keeps-position M88"},
        Lost{head + "M88\nG1 X8 Y1 Z5 A0 B0 C0\nM30\n", "after M88 in line 4", "--keeps-position M88"},
        Lost{head + "G74 Z1=0\nX8 Z5\nM30\n", "after G74 Z1=0 in line 4", "G0 to a stated position after it"},
        Lost{head + "CYCLE800()\nX8\nM30\n", "after CYCLE800() in line 4", "G0 to a stated position after it"}}) {
    INFO(c.text);
    std::string said;
    try {
      run(c.text, job);
    } catch (const Refusal& refusal) {
      said = refusal.diagnostic().message + " | " + refusal.diagnostic().help;
    }
    INFO(said);
    CHECK(said.find(c.cause) != std::string::npos);
    CHECK(said.find(c.way) != std::string::npos);
    CHECK(said.find("G28") == std::string::npos);
  }
  job.program.keeps_position.insert(88);
  CHECK(code_of(head + "M88\nX8\nM30\n", job).empty());
}

TEST_CASE("G1 F500 before the first rapid moves nothing, and goes through") {
  const std::string rest = "G0 X0 Y0 Z15\nG1 Z5 F200\nG0 Z15\nM2\n";
  for (const std::string mode : {"G1 F4500\n", "G01 F15.00\nG64\n", "F100\nG1\n"}) {
    const std::string text = run("G21 G90 G94 G54\n" + mode + rest, without_friction()).text;
    INFO(text);
    CHECK(text.find("\n" + mode) != std::string::npos);
  }
  CHECK(code_of("G21 G90 G94 G54\nG1 X5 F4500\n" + rest, without_friction()) == "compensate-position-unknown");
  CHECK(code_of("G21 G90 G94 G54\nG91 G1 Z5 F4500\nG90\n" + rest, without_friction()) == "compensate-position-unknown");
}

TEST_CASE("siemens: a program of three axes may end with CYCLE800(), and cuts nothing behind it") {
  Job job = kept_over_changes("siemens");
  const std::string program =
      "G54 G17 G710 G90 G94\nT1\nM6\nD1\nS5000 M3\nG0 X-25 Y10\nG0 Z60\nG1 Z55 F400\nX20\nG0 Z65\nM5\n";
  for (const std::string end : {"CYCLE800()\nM30\n", "CYCLE800()\nG0 X0 Y0\nM30\n", "M30\n"}) {
    INFO(end);
    CHECK(code_of(program + end, job).empty());
  }
  for (const std::string cut :
       {"CYCLE800()\nG0 X0 Y0 Z60\nG1 Z55 F100\nM30\n", "CYCLE800()\nD0\nD1\nG0 X0 Y0 Z60\nG1 X5 F100\nM30\n"}) {
    try {
      run(program + cut, job);
      FAIL(cut);
    } catch (const Refusal& refusal) {
      CHECK(refusal.diagnostic().code == "compensate-position-unknown");
      CHECK(refusal.diagnostic().message.find("A, B, C stands is not known after CYCLE800() in line 12") !=
            std::string::npos);
    }
  }
  job.program.keeps_position = {};
  const Diagnostic at_head = testing::refusal_of([&] {
    run("G54 G17 G710 G90 G94\nCYCLE800()\nG0 X0 Y0 Z60\nT1\nM6\nD1\nS500 M3\nG0 X0 Y0 Z60\nG1 X5 F100\nM30\n", job);
  });
  CHECK(at_head.message.find("A, B, C stands is not known after CYCLE800() in line 2") != std::string::npos);
  job = kept_over_changes("siemens");
  CHECK(code_of("CYCLE800()\n" + program + "M30\n", job) == "compensate-position-unknown");
}
