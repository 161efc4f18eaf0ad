// Cycles that a SINUMERIK program calls by name: written out, or called hole by hole with their levels shifted.
#include <array>
#include <regex>

#include <catch2/catch.hpp>

#include "compensate/play.hpp"

using namespace plumbline;

namespace {

Job siemens_job() {
  Job job;
  job.dialect = "siemens";
  job.settings.friction = false;
  return job;
}

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

const std::string kDrillStart = "DEF INT HOLE\nG54 G17 G710 G90 G94 F300\nS800 M3\nG0 X0 Y0 Z20 A0 B0 C0\n";

}  // namespace

TEST_CASE("drilling cycles of a SINUMERIK become moves, and what calls them after each move ends before") {
  const Job job = siemens_job();
  Job still = job;
  still.model.gravity.setZero();
  for (const std::string part :
       {"MCALL CYCLE81(10,0,2,-8)\nX10 Y5\nX20\nMCALL\nG1 X0 F400\n",
        "R1=2\nMCALL CYCLE82(R1*5,0,R1,,7,0.5)\nN50 G1 X10 Y5 F500 ; first\nG91 X3\nMCALL\nG90 Y1\n",
        "X5 Y5\nN9 CYCLE89(12,0,1,-4,,1)\nMCALL CYCLE81(9,0,1,-2)\nG0 X7\nMCALL CYCLE81(9,0,1,-3)\nX8\nMCALL\n",
        "MCALL CYCLE81(10,0,2,-8)\nFOR HOLE=1 TO 3\nX=HOLE*4 Y=HOLE\nENDFOR\nMCALL\nG1 X1\n"}) {
    const std::string whole = kDrillStart + part + "G0 Z30\nM30\n";
    INFO(whole);
    const Result result = run(whole, job);
    INFO(result.text);
    const Played played = play(whole, result.text, job);
    CHECK(played.at_points_um <= (whole.find("G91") == std::string::npos ? 0.15 : 2.5));  // 0.001 mm, 0.001 deg
    CHECK(played.time_change <= 1e-3);
    CHECK(count_of(result.text, "\nMCALL\n") >= count_of(result.text, "\nMCALL CYCLE"));
    CHECK(run(whole, still).text == whole);
  }
}

TEST_CASE("a dwell of a cycle in turns of the spindle stays one where its hole is written out") {
  const Job job = siemens_job();
  for (const auto& [cycle, dwell] : {std::pair<std::string, std::string>{"CYCLE82(10,0,2,-5,,-2)\n", "S2"},
                                     {"MCALL CYCLE82(10,0,2,-5,,-2.5)\nX5\nMCALL\n", "S2.5"},
                                     {"X3\nMCALL CYCLE89(10,0,2,-5,,-3)\nX5\nX7\nMCALL\n", "S3"},
                                     {"CYCLE82(10,0,2,-5,,0.24)\n", "F0.24"}}) {
    const std::string whole = kDrillStart + cycle + "G0 Z30\nM30\n";
    const Result result = run(whole, job);
    INFO(result.text);
    const std::size_t dwells =
        count_of(result.text, "\nG4" + dwell + "\n") + count_of(result.text, "\nG4 " + dwell + "\n");
    CHECK(dwells == (cycle.find("X7") == std::string::npos ? 1 : 2));
    CHECK(count_of(result.text, "G4") == dwells);
    CHECK(play(whole, result.text, job).time_change <= 1e-3);
  }
}

TEST_CASE("cycles that peck or work the spindle are called hole by hole, with their levels shifted") {
  Job job = siemens_job();
  for (const std::string part : {"MCALL CYCLE84(10,0,2,-8,,0,3,,1.25,0,400,400)\nX10 Y5\nX20\nMCALL\nG1 X0 F400\n",
                                 "X5 Y5\nCYCLE83(10,0,2,-9,,-4,,0,0,0,1,1)\nG91 X2\nCYCLE85(10,0,2,,6,,200,300)\nG90\n",
                                 "R2=-7\nMCALL CYCLE840(10,0,2,R2,,,0,,0,,1)\nG1 X10 Y5 F500\nMCALL "
                                 "CYCLE86(10,0,2,R2,,1,3,-1,0,1,0)\nX5 F500\nMCALL\n"}) {
    const std::string whole = kDrillStart + part + "G0 X1 Y1 Z30\nM30\n";
    INFO(whole);
    const Result result = run(whole, job);
    INFO(result.text);
    compensate::Corrector machine(job.model, job.settings);
    // Of each hole both its top and its bottom, in the same order.
    const auto bottoms = [&](const std::string& text) {
      std::vector<Move> kept;
      for (const Move& move : moves_of(text, job.program, "siemens")) {
        if (move.motion.kind == nc::MotionKind::feed && move.motion.to[Axis::Z] < 0) kept.push_back(move);
      }
      return kept;
    };
    const std::vector<Move> before = bottoms(whole);
    const std::vector<Move> after = bottoms(result.text);
    REQUIRE(before.size() >= 2);
    REQUIRE(before.size() == after.size());
    for (std::size_t i = 0; i < before.size(); ++i) {
      const AxisWords stands = after[i].to_W + machine.error({after[i].to_W, {}, {}, std::nullopt}).value();
      CHECK(tip_distance(stands, before[i].to_W) <= job.settings.cycle_tolerance_mm);
      CHECK(tip_distance(after[i].to_W, before[i].to_W) > 1e-3);
    }
  }
  job.settings.cycle_tolerance_mm = 1e-5;
  CHECK(code_of(kDrillStart + "CYCLE83(10,0,2,-90,,-4,,0,0,0,1,1)\n", job) == "compensate-cycle");
}

TEST_CASE("the F of a dwell is no feed that the output would count on") {
  const Job job = siemens_job();
  const std::string text = kDrillStart + "G1 X20 A5 F500\nG4 F2\nG1 X30\nG4 F=1+1\nX40 Y9 A0\nG4 S800\nX1\nM30\n";
  const Result result = run(text, job);
  INFO(result.text);
  CHECK(count_of(result.text, "G4 F2\n") == 1);
  CHECK(play(text, result.text, job).time_change <= 1e-3);
}

TEST_CASE("codes whose place beside a cut is the builder's choice are refused where the cut has several pieces") {
  const Job job = siemens_job();
  CHECK(code_of(kDrillStart + "G1 X20 M9\nM30\n", job) == "emit-m-code");
  CHECK(code_of(kDrillStart + "G1 X20 Y3\nX0 M19\nM30\n", job) == "emit-m-code");
  CHECK(code_of(kDrillStart + "G2 X20 CR=30 M1=19\nM30\n", job) == "emit-m-code");
  for (const char* const block : {"G1 X20 M5", "M8 G1 X20", "G0 X20 M9"}) {
    const std::string output = run(kDrillStart + block + "\nM30\n", job).text;
    INFO(output);
    CHECK(output.find('M', output.find("A0 B0 C0")) < output.find('\n', output.find('G', output.find("A0 B0 C0"))));
  }
}

TEST_CASE("increments are written as the control keeps them, and what is rounded away is carried on") {
  const Job job = siemens_job();
  const std::string text = kDrillStart + "G91 G1 X30.7 Y10.3 A1 F900\nX-12.4 B-1\nG90 X1 Y1\nM30\n";
  const std::string output = run(text, job).text;
  INFO(output);
  const std::size_t begin = output.find("G91");
  const std::string cut = output.substr(begin, output.find("G90 X") - begin);
  for (std::size_t at = cut.find('.'); at != std::string::npos; at = cut.find('.', at + 1)) {
    const bool feed = cut.rfind('F', at) != std::string::npos && cut.rfind('F', at) > cut.find_last_of("XYZABC \n", at);
    CHECK((feed || cut.find_first_not_of("0123456789", at + 1) - at <= 4));
  }
  CHECK(play(text, output, job).at_points_um <= 1.5);
}

TEST_CASE("a turn alone that F does not count is refused, for how long it takes no program says") {
  const std::string head = "G54 G17 G710 G90 G94\nF500\nG0 X0 Y0 Z20 A0 B0 C0\nFGROUP(X,Y,Z)\n";
  for (const std::string turn : {"G1 A5", "G1 X0 B3 C-2", "G91 G1 C4"}) {
    INFO(turn);
    CHECK(code_of(head + turn + "\nM30\n", siemens_job()) == "emit-feed-rule");
    CHECK(code_of(head + "FGROUP()\n" + turn + "\nM30\n", siemens_job()).empty());
    CHECK(code_of(head + "G93\n" + turn + " F20\nM30\n", siemens_job()).empty());
  }
  CHECK(code_of(head + "G0 A5\nG1 X10 A0\nM30\n", siemens_job()).empty());
}

TEST_CASE("in inches a cut that turns is refused until somebody says what a degree counts") {
  const std::string head = "G54 G17 G700 G90 G94\nF10\nG0 X0 Y0 Z1 A0 B0 C0\n";
  for (const std::string cut : {"G1 X1 A2", "G1 A2", "G1 C1 Y.5 F20", "G3 X1 CR=2 B1"}) {
    Job job = siemens_job();
    INFO(cut);
    CHECK(code_of(head + cut + "\nM30\n", job) == "emit-feed-rule");
    CHECK(code_of(head + "FGROUP(X,Y,Z)\n" + cut + "\nM30\n", job) == (cut == "G1 A2" ? "emit-feed-rule" : ""));
    job.program.feed_rule = nc::FeedRule::all_axes_as_mm;
    CHECK(code_of(head + cut + "\nM30\n", job).empty());
  }
  CHECK(code_of(head + "G1 X1\nG2 X2 I.5 J0\nM30\n", siemens_job()).empty());
}

TEST_CASE("a cut in machine coordinates goes through as it stands, from where the correction left the axes") {
  const Job siemens = siemens_job();
  for (const std::string cut : {"G53 X20", "G1 SUPA X20 Y1", "G153 Z-950", "X12 G53"}) {
    const std::string text = "G54 G17 G710 G90 G94 F100\nG0 X10 Y0 Z50 A0 B0 C0\nG1 X15\n" + cut + "\nX10 Z50\nM30\n";
    INFO(text);
    CHECK(code_of(text, siemens).empty());
  }
  Job linuxcnc = siemens_job();
  linuxcnc.dialect = "linuxcnc";
  CHECK(code_of("G21 G90 G54 F100\nG0 X10 Y0 Z50 A0 B0 C0\nG1 X15\nG53 G1 X16\nX10\nM2\n", linuxcnc).empty());
}

TEST_CASE("variables that a block hands to the control have their values where the program is written out") {
  const Job job = siemens_job();
  const std::string head = "DEF REAL CLOSE=0.02\nG54 G17 G710 G90 G94 F100\nG0 X10 Y0 Z50 A0 B0 C0\nR1=1\n";
  for (const std::string passed :
       {"SPOS=R1*90", "G641 ADIS=CLOSE", "CYCLE832(CLOSE,1)", "MSG(\"R1\"<<R1)", "SPOS[1]=30+R1"}) {
    INFO(passed);
    CHECK(code_of(head + "WHILE R1<3\n" + passed + "\nG1 X=R1\nR1=R1+1\nENDWHILE\nM30\n", job).empty());
    CHECK(code_of(head + passed + "\nG1 X=R1\nM30\n", job).empty());  // which sets them itself
  }
  for (const auto& [passed, first, second] :
       {std::array<std::string, 3>{"SPOS=R1*90", "SPOS=1*90\n", "SPOS=2*90\n"},
        {"G641 ADIS=CLOSE/R1", "ADIS=0.02/1\n", "ADIS=0.02/2\n"},
        {"CYCLE832(0.01,R1,1)", "CYCLE832(0.01,1,1)\n", "CYCLE832(0.01,2,1)\n"},
        {R"(MSG("N "<<R1<<" of 2"))", "MSG(\"N 1 of 2\")\n", "MSG(\"N 2 of 2\")\n"}}) {
    INFO(passed);
    const std::string text = run(head + "WHILE R1<3\n" + passed + "\nG1 X=R1\nR1=R1+1\nENDWHILE\nM30\n", job).text;
    INFO(text);
    CHECK(text.find(first) != std::string::npos);
    CHECK(text.find(first) < text.find(second));
    CHECK(text.find(second) != std::string::npos);
  }
  for (const std::string unknown : {"SPOS=R[R1]", "MSG(\"R1 \"<<R1+1)"}) {
    INFO(unknown);
    CHECK(code_of(head + "WHILE R1<3\n" + unknown + "\nG1 X=R1\nR1=R1+1\nENDWHILE\nM30\n", job) == "compensate-flow");
  }
  for (const std::string passed : {"SPOS=90", "MSG(\"R1 CLOSE\")", "CYCLE832(0.1,_FINISH,1)", "FGROUP(X,Y,Z)"}) {
    INFO(passed);
    CHECK(code_of(head + "WHILE R1<3\n" + passed + "\nG1 X=R1\nR1=R1+1\nENDWHILE\nM30\n", job).empty());
  }
}

TEST_CASE("subprograms that end by M30, or with their last move, come out whole") {
  const Job job = siemens_job();
  for (const std::string end : {"X15 M30\n", "X15\nM2\n", "X15 M17\n", "G91 X15\nG90 Y3 M30\n",
                                "G2 X10 Y5 I2.5 J2.5 TURN=1 M17\n", "R1=4 X15 M5 M17 ; back\n"}) {
    const std::string whole =
        kDrillStart + "G1 X5 Y0\nPART\nG1 X2 Y2\nPART P2\nG0 Z30\nM30\n%_N_PART_SPF\nG1 X5 Y0 F500\n" + end;
    INFO(whole);
    const Result result = run(whole, job);
    INFO(result.text);
    CHECK(play(whole, result.text, job).at_points_um <= 2.5);
    const std::string written_out = result.text.substr(0, result.text.find("%_N_PART"));
    CHECK(count_of(written_out, "M30") == 1);
    CHECK(count_of(written_out, "M17") + count_of(written_out, "M2\n") == 0);
  }
}

TEST_CASE("planes that the call of a cycle leaves out are written where they are shifted") {
  const Job job = siemens_job();
  for (const std::string part :
       {"CYCLE83(10,,2,-9,,-4,,0,0,0,1,1)\n", "MCALL CYCLE84(10,,2,-8,,0,3,8,,0,400,400)\nX10 Y5\nX20\nMCALL\n",
        "CYCLE85(,-10,2,-18,,0,200,300)\n", "MCALL CYCLE81(10,,2,-8)\nX5\nMCALL\n"}) {
    const std::string whole = kDrillStart + part + "G0 X1 Y1 Z30\nM30\n";
    INFO(whole);
    const Result result = run(whole, job);
    INFO(result.text);
    CHECK(result.summary.changed_blocks > 0);
    CHECK_FALSE(std::regex_search(result.text, std::regex("\nCYCLE[0-9]+\\((10)?,,?[-2]")));
  }
}

TEST_CASE("positions that say themselves how they count are drilled at where the program is written out") {
  const Job job = siemens_job();
  for (const std::string part :
       {"MCALL CYCLE81(10,0,2,-5)\nY=AC(5)\nMCALL\n", "MCALL CYCLE82(10,0,2,-5,,1)\nX=IC(4) Y=AC(5)\nMCALL\n",
        "R1=5\nMCALL CYCLE83(10,0,2,-9,,-3,,0,0,0,1,1)\nX=AC(R1) Y=AC(7)\nX=IC(R1)\nMCALL\n",
        "MCALL CYCLE81(10,0,2,-5)\nY=AC(5)\n"}) {
    const std::string whole = kDrillStart + "PART\n" + part + "%_N_PART_SPF\nG1 X3 F500\nRET\n";
    INFO(whole);
    const Result result = run(whole, job);
    INFO(result.text);
    CHECK(result.summary.changed_blocks > 0);
    CHECK(count_of(result.text, "=AC(") + count_of(result.text, "=IC(") == 0);
  }
}

TEST_CASE("a correction is no increment of an axis whose offset changed before") {
  const Job job = siemens_job();
  for (const std::string change : {"G1 X1 F200\nTRANS Z2\n", "G1 X1 F200\nTRANS Y4 Z1\n", "G1 X1 F200\nATRANS Z-1\n"}) {
    INFO(change);
    CHECK(code_of(kDrillStart + change + "G91 X60\nM30\n", job) == "nc-not-interpreted");
    CHECK(code_of(kDrillStart + change + "Y3 Z19\nG91 X60\nM30\n", job).empty());
  }
}

TEST_CASE("a word that says which way round it turns is not cut into increments") {
  const Job job = siemens_job();
  for (const std::string turn : {"A=DC(5)", "B=ACP(4) X3", "A=ACN(355)"}) {
    INFO(turn);
    CHECK(code_of(kDrillStart + "G1 F200\nG91 " + turn + "\nM30\n", job) == "emit-rotary-word");
  }
  CHECK(code_of(kDrillStart + "G1 F200\nA=DC(5)\nM30\n", job).empty());
}

TEST_CASE("CYCLE86 that lifts off the wall is shifted as a whole") {
  const Job job = siemens_job();
  for (const std::string hole :
       {"CYCLE86(10,0,2,-8,,0.5,3,-0.2,0.3,1,45)\n", "G18\nG0 Y20\nCYCLE86(30,20,2,10,,0,3,0.5,0,0,0)\n",
        "MCALL CYCLE86(10,0,2,-8,,0,4,0,-1,0,90,0,0,10)\nX5 Y6\nX7\nMCALL\n", "CYCLE86(10,0,2,,8,0.5,3,0,0,2,0)\n"}) {
    INFO(hole);
    const Result result = run(kDrillStart + hole + "G0 Z50\nM30\n", job);
    CHECK(result.summary.changed_blocks > 0);
  }
}

TEST_CASE("cuts whose time is not known are counted") {
  const Job job = siemens_job();
  for (const auto& [lines, untimed] :
       {std::pair<std::string, std::uint64_t>{"CYCLE83(10,0,2,-9,,-4,,1,0.5,0,1,1)\n", 1},
        {"MCALL CYCLE83(10,0,2,-20,,,4,-0.8,0,0,1,0)\nX5\nX10\nMCALL\n", 2},
        {"G95 F0.1\nG1 X5\nX10 Y3\nG94 F100 X20\n", 2},
        {"CYCLE83(10,0,2,-9,,-4,,0,0.5,0,1,1)\nG1 X9\n", 0}}) {
    INFO(lines);
    CHECK(run(kDrillStart + lines + "G0 Z50\nM30\n", job).summary.untimed_moves == untimed);
  }
}

TEST_CASE("F is no block of its own where positions of MCALL stand in a part that is written out") {
  const Job job = siemens_job();
  for (const std::string part :
       {"G1 Y18\nMCALL CYCLE81(20,0,2,-5)\nPOSITIONS\nMCALL\nM30\n%_N_POSITIONS_SPF\nX5 Y5\nX10\nM17\n",
        "G1 Y18\nG0 Z20\nMCALL CYCLE82(20,0,2,-5,,1)\nFOR HOLE=1 TO 3\nX=HOLE*4\nENDFOR\nMCALL\nG1 X3\nM30\n",
        "G1 Y18\nMCALL CYCLE83(20,0,2,-5,,-3,,0,0,0,1,1)\nR1=5\nIF R1==5\nX5\nENDIF\nMCALL\nM30\n"}) {
    const Result result = run(kDrillStart + part, job);
    INFO(result.text);
    CHECK_FALSE(std::regex_search(result.text, std::regex("^F[0-9.]+$", std::regex::multiline)));
  }
}
