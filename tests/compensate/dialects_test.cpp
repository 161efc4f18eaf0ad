// Programs for other controls come out in their own language, and put the tip where it was programmed.
#include <algorithm>
#include <regex>

#include <catch2/catch.hpp>

#include "compensate/play.hpp"

using namespace plumbline;

namespace {

constexpr double kThousandthsUm = 1.5;  // of mm and deg, at the tip

// What a control keeps of mm and deg is not among the tip's errors that a correction can take away. Where no rule for F
// is needed, one is taken: short pieces on which the tool turns by a thousandth of a degree have no time without.
void check(const std::string& text, const std::string& output, Job job, double kept_um = 0) {
  if (job.dialect == "okuma") kept_um = std::max(kept_um, kThousandthsUm);
  if (job.dialect == "okuma" && !job.program.feed_rule) job.program.feed_rule = nc::FeedRule::xyz_first;
  INFO(output);
  const Played played = play(text, output, job);
  CHECK(played.at_points_um <= 0.15 + kept_um);
  CHECK(played.between_points_um <= 0.5 + kept_um);
  CHECK(played.time_change <= 2e-3);
}

bool holds(const std::string& text, const std::string& pattern) {
  return std::regex_search(text, std::regex(pattern, std::regex::multiline));
}

const std::string kFanuc =
    "%\nO0042 (POCKET)\nG17 G21 G90 G94 G54\nG0 X0. Y0. Z20. A0. B0. C0.\nG43.4 H0 Z20.\n"
    "N10 G1 X20. Y10. Z0. A-12. B5. F900.\nN20 G3 X-20000 Y10. I-20. J15.\nG1 A3. B-4.\nG9 G1 X0. Y0.\nG61 X5.\nG64 "
    "G91 X1.5 "
    "Y-2.\n"
    "G90 G93 G1 X0. Y0. F12.\nG94 X5. F500.\nM98 P1\nG0 Z30.\nM30\nO1\nG54.1 P2 G1 Y5.\nM99\n%\n";

const std::string kOkuma =
    "$POCKET.MIN%\nO42 (POCKET)\nG15 H1\nG17 G90 G94\nG0 X0 Y0 Z20 A0 B0 C0\nVC1=20\n"
    "NPOCK G1 X=VC1 Y10 Z0 A-12 B5 F900\nG3 X-20 Y10 I-20 J15\nG1 A3 B-4\nG15 H2 G1 X5\nX5 G9\nG0 Z30\nM2\n";

const std::string kSiemens =
    "%_N_POCKET_MPF\n;$PATH=/_N_MPF_DIR\nN10 G54 G17 G710 G90 G94\nN20 G0 X0 Y0 Z20 A0 B0 C0\nN30 TRAORI\nN40 "
    "FGROUP(X,Y,Z)\n"
    "N50 G1 X=IC(20) Y=10 Z0 A=-12 B=AC(5) F900\nN60 G3 X-20 Y10 I=AC(0) J=AC(25)\nN70 G1 X-10 Y20\n"
    "N75 G2 X10 Y20 CR=15\nN80 CIP X10 Y0 I1=20 J1=10\nN90 FGROUP()\nN100 G1 A3 B-4\nN110 X5 C2\nN120 G0 Z30\nN130 "
    "M30\n";

}  // namespace

TEST_CASE("a program for Fanuc comes out for Fanuc") {
  Job job = job_of_control("fanuc");
  job.program.feed_rule = nc::FeedRule::xyz_first;
  const Result result = run(kFanuc, job);
  check(kFanuc, result.text, job, kThousandthsUm);
  CHECK(result.summary.changed_blocks > 5);
  INFO(result.text);
  CHECK_FALSE(holds(result.text, "[XYZABCF]-?[0-9]+( |$|[A-Z])"));  // each number that was written has its point
  CHECK(holds(result.text, "^O0042 \\(POCKET\\)\n\\(PLUMBLINE"));   // the stamp after the number
  CHECK_FALSE(holds(result.text, "M98|M99|^O1$"));
}

TEST_CASE("a flat program for Okuma comes out for Okuma") {
  Job job = job_of_control("okuma");
  CHECK(code_of(kOkuma, job) == "emit-feed-rule");
  job.program.feed_rule = nc::FeedRule::xyz_first;
  const Result result = run(kOkuma, job);
  check(kOkuma, result.text, job);
  INFO(result.text);
  CHECK(holds(result.text, "^NPOCK G1 X-?[0-9]+\\.[0-9]* Y"));
  CHECK(holds(result.text, "^VC1=20$"));
  CHECK(holds(result.text, "G9$"));
}

TEST_CASE("a program for Okuma in which nothing turns needs no feed rule, though its correction turns a little") {
  const std::string head = "$FLAT.MIN%\nO42\nG15 H1\nG0 X0 Y0 Z20 A5 B-3 C0\n";
  const Job job = job_of_control("okuma");
  for (const char* const cuts :
       {"G1 X40 Y10 Z0 F500\nX-40\n", "G1 Z0 F100\nG2 X20 Y20 I20 F800\nG1 Y60\n", "G91 G1 X0.5 Y2 F300\nX3\nZ-2\n"}) {
    const std::string text = head + cuts + "M2\n";
    const Result result = run(text, job);
    check(text, result.text, job);
    CHECK(result.summary.changed_blocks > 0);
  }
  for (const char* const turns : {"G1 X1 A8 F500\n", "G1 A8 F500\n", "G1 B-3.5 X0.001 F500\n"}) {
    CHECK(code_of(head + turns + "M2\n", job) == "emit-feed-rule");
  }
}

TEST_CASE("under G93 no feed rule is needed, whatever turns") {
  const Job job = job_of_control("okuma");
  const std::string head = "G15 H1\nG0 X0 Y0 Z20 A0 B0 C0\n";
  for (const char* const cuts :
       {"G93 G1 X11 A0.3 B0.1 F30\nX12 A0.6 B0.3 F25\n", "G93\nG1 A2 F3\nB1 C3 F4\nX5 C2 F10\n",
        "G93 G1 X0.001 C-4 F2.5\nY9 A1 F6\nG94 X30 F500\n"}) {
    const std::string text = head + cuts + "M2\n";
    INFO(text);
    const Result result = run(text, job);
    check(text, result.text, job);
    CHECK(result.summary.time_change.value < 1e-3);
  }
  CHECK(code_of(head + "G93 G1 X5 F10\nG94 X9 A3 F500\nM2\n", job) == "emit-feed-rule");
}

TEST_CASE("a block of several lines is joined where it changes, and stays as it is where it does not") {
  const Job job = job_of_control("okuma");
  const std::string text =
      "$A.MIN%\nG15 H1\nG90\n$ G94\nG0 X0 Y0 Z20\n$ A0 B0 C0\nN7 G1 X40\n$Y10 F500 (CUT)\nG3 X20\n$  Y30\n$ R22 "
      "M8\nM5\n$ "
      "M9\nM2\n";
  const Result result = run(text, job);
  INFO(result.text);
  check(text, result.text, job);
  CHECK(holds(result.text, "^G90\n\\$ G94$"));
  CHECK(holds(result.text, "^M5\n\\$ M9$"));
  CHECK(holds(result.text, "^N7 G1 X[0-9.]+ Y[0-9.]+ .*F500 \\(CUT\\)$"));
  CHECK_FALSE(holds(result.text, "^\\$ *[YR]"));
}

TEST_CASE("a tool that Okuma's control changes after a move is not carried along it") {
  Job job = job_of_control("okuma");
  job.program.feed_rule = nc::FeedRule::xyz_first;
  job.program.tool_in_spindle = 1;
  nc::Tool light;
  light.number = 1;
  light.mass_kg = 1;
  nc::Tool heavy = light;
  heavy.number = 2;
  heavy.mass_kg = 9;
  job.program.tools = nc::ToolTable({light, heavy});
  const std::string before = "G15 H1\nT2\nG0 X0 Y0 Z20 A0 B0 C0\n";
  const std::string together = run(before + "G1 X40 Y10 F500 M6\nM2\n", job).text;
  const std::string apart = run(before + "G1 X40 Y10 F500\nM6\nM2\n", job).text;
  CHECK(holds(together, " M6$"));
  CHECK(std::regex_replace(together, std::regex(" M6\n"), "\n") ==
        std::regex_replace(apart, std::regex("\nM6\n"), "\n"));
  job.program.tool_in_spindle = 2;
  CHECK(run(before + "G1 X40 Y10 F500\nM6\nM2\n", job).text != apart);
}

TEST_CASE("what Okuma's control does when the axes have arrived stands after the last piece") {
  Job job = job_of_control("okuma");
  job.program.feed_rule = nc::FeedRule::xyz_first;
  const std::string text = "G15 H1\nG0 X0 Y0 Z20 A0 B0 C0\nG1 X40 Y10 Z0 F500 M3 M8\nG1 X0 Y0 M5 M9\nM2\n";
  const std::string out = run(text, job).text;
  INFO(out);
  CHECK(holds(out, "^G1 X[0-9.]+ Y[0-9.]+ Z[0-9.]+ .*M3 M8$"));
  CHECK(holds(out, "^X[-0-9.]+ .*M5 M9$"));
  CHECK_FALSE(holds(out, "^G1 .*M5"));
}

TEST_CASE("a flat program for Siemens comes out for Siemens") {
  const Job job = job_of_control("siemens");
  const Result result = run(kSiemens, job);
  check(kSiemens, result.text, job);
  INFO(result.text);
  CHECK(holds(result.text, "^; plumbline"));
  CHECK(holds(result.text, "^N50 G1 X[0-9.]+ Y[0-9.]+ Z-?[0-9.]+ A-[0-9.]+ B[0-9.]+ "));
  CHECK_FALSE(holds(result.text, "IC\\(|CIP|CR=|I=AC"));
  CHECK(holds(result.text, "^N120 G0 Z"));
}

TEST_CASE("loops and subprograms of every dialect are written out") {
  const std::string head = "G0 X0 Y0 Z20. A0 B0 C0\n";
  Job fanuc = job_of_control("fanuc");
  const std::string macro =
      "O7\n" + head +
      "#1=0\nWHILE [#1 LT 3] DO 1\nG1 X[#1*10.] Y#5 F500\n#1=#1+1\nEND 1\nG65 P8 X25.\nM30\nO8\nG1 X#24 Y#25\nM99\n";
  check(macro, run(macro, fanuc).text, fanuc, 1.5);
  Job okuma = job_of_control("okuma");
  okuma.program.feed_rule = nc::FeedRule::xyz_first;
  const std::string task =
      "O7\nG15 H1\n" + head +
      "VC1=0\nNA IF [VC1 GE 3] NB\nG1 X=VC1*10 F500\nVC1=VC1+1\nGOTO NA\nNB CALL O8 PX=25\nM2\nO8\nG1 X=PX\nRTS\n";
  check(task, run(task, okuma).text, okuma);
  Job siemens = job_of_control("siemens");
  const std::string loops =
      "G54\n" + head + "FOR R1=0 TO 2\nR2=R1\nG1 X=R1*10 Y=IC(1) F500\nENDFOR\nIF R2>1\nG2 X10 Y5 CR=30\nENDIF\nM30\n";
  const std::string out = run(loops, siemens).text;
  check(loops, out, siemens);
  CHECK_FALSE(holds(out, "IF|=R[0-9]"));
  CHECK(out.ends_with("FOR R1=2 TO 2\nENDFOR\nR2=2\nM30\n"));
}

TEST_CASE("variables that are set beside a move are not written out there") {
  const std::string loop =
      "G54\nG0 X0 Y0 Z20 A0 B0 C0\nR1=1 R2=2\nFOR R3=0 TO 2\nR1=R3*2 G1 X=R2 Y5 R4=R2 F500\nR2=R2+R1\nENDFOR\nM30\n";
  const Job job = job_of_control("siemens");
  const std::string out = run(loop, job).text;
  check(loop, out, job);
  INFO(out);
  CHECK_FALSE(holds(out, "=R[0-9]|[GXYF][^O].*R[0-9]"));
}

TEST_CASE("a word whose variable is vacant gives way to the corrected one") {
  const Job job = job_of_control("fanuc");
  const std::string text = "G54 F500.\nG0 X0 Y0 Z20. A0 B0 C0\nG0 X#0 Y4.\nG1 X5. F#2\nM30\n";
  const std::string out = run(text, job).text;
  check(text, out, job, 1.5);
  INFO(out);
  CHECK_FALSE(holds(out, "#"));
}

TEST_CASE("OSP: a hole with words that no source says all of stays a cycle, shifted, its words as they were") {
  const Job job = job_of_control("okuma");
  const std::string text =
      "G15 H1\nG90 G94 M53\nG0 X5. Y5. Z20. A0 B0 C0\nG71 Z20.\nS500 M3\n"
      "G73 X5. Y5. Z-6. R1. I2. J4. F100\nX10.\nG0 Z20.\nG85 X5. Z-2. R1. F80 FA=200\nG81 Y8. Z-1. R1. P250\n"
      "G284 X0 Y0 Z-2. R1. F500\nG0 Z20.\nM2\n";
  const std::string out = run(text, job).text;
  INFO(out);
  CHECK(holds(out, "^G73 X.* R1\\.0.* I2\\. J4\\. F100"));
  CHECK(holds(out, "^X[0-9.]+ Y[0-9.]+ Z-5\\.98.* R1\\.01"));
  CHECK(holds(out, "^G85 .* FA=200 Y"));
  CHECK(holds(out, "^G81 .* P250 X"));
  CHECK(holds(out, "^G284 .*"));
}

TEST_CASE("OSP: an arc of a program in which nothing turns needs no rule for F, however short its pieces are") {
  const Job job = job_of_control("okuma");
  for (const char* const cut : {"G2 X10 R5 F100\n", "G18 G3 X4 Z20 I2 K0 F250\n", "G1 X2 F100\nG3 I2\n"}) {
    const std::string text = "G15 H1\nG90 G94 G0 X0 Y0 Z20 A0 B0 C0\n" + std::string(cut) + "M2\n";
    const std::string out = run(text, job).text;
    INFO(out);
    Job counted = job;
    for (const nc::FeedRule rule : {nc::FeedRule::xyz_first, nc::FeedRule::all_axes_as_mm}) {
      counted.program.feed_rule = rule;
      check(text, out, counted, 1.5);
    }
  }
}

TEST_CASE("OSP: what was worked out has a point only where the control takes one") {
  const Job job = job_of_control("okuma");
  const std::string text =
      "G15 H1\nG90 G94 G0 X0 Y0 Z20 A0 B0 C0\nVC1=1\nNA IF [VC1 GT 1] NB\nS=1000*VC1 M3\nG15 H=VC1\nG0 X0 Y0 Z20\n"
      "G1 X=VC1*5 F=100*2\nG4 F=VC1/2\nG56 H=VC1-1\nVC1=VC1+1\nGOTO NA\nNB M2\n";
  const std::string out = run(text, job).text;
  INFO(out);
  CHECK(holds(out, "^S1000 M3$"));
  CHECK(holds(out, "^G15 H1$"));
  CHECK(holds(out, "^G1 X"));
  CHECK(holds(out, "^G4 F0\\.5$"));
  CHECK(holds(out, "^G56 H0$"));
}

TEST_CASE("OSP: a code of the builder beside a cut of several pieces is refused") {
  Job job = job_of_control("okuma");
  const std::string head = "G15 H1\nG90 G94 G0 X0 Y0 Z20 A0 B0 C0\n";
  job.program.passed_m_codes = job.program.keeps_position = {300};
  CHECK(code_of(head + "G1 X10 F100 M300\nM2\n", job) == "emit-m-code");
  CHECK(code_of(head + "G1 X10 F100 M20\nM2\n", job) == "nc-not-interpreted");
  CHECK(code_of(head + "M300\nG1 X10 F100 M8\nM21\nM2\n", job).empty());
}

TEST_CASE("a work system of one block alone cannot hold for its pieces") {
  Job job = job_of_control("okuma");
  const std::string text = "G15 H1\nG0 X0 Y0 Z20 A0 B0 C0\nG16 H2 G1 X5 F100\nM2\n";
  CHECK(code_of(text, job) == "compensate-work-system");
}

TEST_CASE("a block that moves and calls moves first, and what is called stands after it") {
  const Job job = job_of_control("fanuc");
  const std::string text =
      "<PART-1>\nG0 X0 Y0 Z20. A0 B0 C0 D0 H0\nG1 F500 X5. M98 P8\nY2. M98 P8 L2 M8\nM30\nO8\nX6.\nX4. M99\n";
  const std::string out = run(text, job).text;
  INFO(out);
  check(text, out, job, 1.5);
  CHECK(holds(out, "^<PART-1>$"));
  CHECK_FALSE(holds(out, "M98|M99|P8"));
  CHECK(holds(out, "M8"));
}

TEST_CASE("a dwell of a cycle counts what the control counts") {
  const Job job = job_of_control("fanuc");
  const std::string text =
      "O1\nG54\nG0 X0. Y0. Z20. A0. B0. C0.\nG82 X1. Z0. R2. P500 F100.\nG80\nG84 X5. Z-1. R2. P250 F100.\nG80\nM30\n";
  const std::string out = run(text, job).text;
  INFO(out);
  CHECK(holds(out, "^G4 P500$"));
  CHECK(holds(out, "^G84 X.* P250 F100\\."));
}

TEST_CASE("a program that is written out repeats no label") {
  const Job job = job_of_control("siemens");
  const std::string text =
      "G54\nG0 X0 Y0 Z20 A0 B0 C0\nR1=0\nN10 LOOP: G1 X=R1*5 Y1 F500\nAGAIN:\nMORE: R1=R1+1\nIF R1<3 GOTOB LOOP\nM30\n";
  const std::string out = run(text, job).text;
  INFO(out);
  CHECK_FALSE(holds(out, "LOOP:|AGAIN|MORE"));
  CHECK(holds(out, "^N10 G1 X"));
  check(text, out, job);
}

TEST_CASE("moves beside calls: arcs, increments and calls of calls") {
  const Job job = job_of_control("fanuc");
  for (const char* const calls : {"G2 X10. Y0 I5. J0 F400. M98 P8\n", "G91 G1 Y3. F400. M98 P8 L2\nG90\n",
                                  "M98 P30009 G1 X12. F400. M9\n", "G65 P9 A1.\nG0 Z21. M98 P9\n"}) {
    const std::string text = std::string("O1\nG90 G54 G0 X0 Y0 Z20. A0 B0 C0\n") + calls +
                             "X1.\nM30\nO8\nG1 X6. F300.\nM99\nO9\nG91 G0 Z-1. M98 P8\nG90\nM99\n";
    INFO(text);
    const std::string out = run(text, job).text;
    INFO(out);
    check(text, out, job, 1.5);
    CHECK_FALSE(holds(out, "M98|M99|G65"));
  }
}

TEST_CASE("a place above a hole that is not drilled is written out with the cycle that it belongs to") {
  const Job job = job_of_control("okuma");
  for (const char* const holes :
       {"G81 X5 Y0 R2 Z-4 F100 M53\nX8 NCYL\nX11\n", "NCYL G81 X5 R2 Z-4 F100 M53\nY3 NCYL\nX1\n",
        "G83 X5 R2 Z-4 Q1 F100 M53\nNCYL X9\nG0 X0\n"}) {
    const std::string text =
        std::string("$DRILL.MIN%\nO42\nG15 H1\nG0 X0 Y0 Z20 A0 B0 C0\nG71 Z20\n") + holes + "G80\nG0 Z30\nM2\n";
    INFO(text);
    const std::string out = run(text, job).text;
    INFO(out);
    check(text, out, job);
    CHECK_FALSE(holds(out, "NCYL"));
  }
}

TEST_CASE("a motion code in a header moves nothing, whatever is not known there") {
  for (const auto& [dialect, text] :
       {std::pair<const char*, const char*>{"okuma", "G0 G17 G40 G80 G90\nG15 H1\nG0 X0 Y0 Z20\nM2\n"},
        std::pair<const char*, const char*>{"okuma", "G1 G94 G40\nG15 H1\nG0 X0 Y0 Z20\nG1\nX1 F100\nM2\n"},
        std::pair<const char*, const char*>{"siemens", "G0 G17 G40 G60 G90\nG54\nX0 Y0 Z20\nM30\n"},
        std::pair<const char*, const char*>{"siemens", "N1 G1 G64\nN2 G54 G0 X0 Y0 Z20\nG1\nX1 F100\nM30\n"}}) {
    INFO(text);
    CHECK(code_of(text, job_of_control(dialect)).empty());
  }
}
