#include "jobs/diff/diff.hpp"

#include <cmath>

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "jobs/diff/compensated.hpp"
#include "report/program/diff_text.hpp"
#include "settings/options.hpp"
#include "support/scratch.hpp"

using namespace plumbline;
using jobs::DiffSummary;
using testing::compensated;
using testing::diff_of;
using testing::is_whole;

namespace {

// A path with straight moves, arcs, a full circle, tiny moves and rapids.
std::string winding(bool numbered) {
  std::string text;
  int n = 0;
  const auto block = [&](const std::string& words) {
    text += (numbered ? fmt::format("N{} ", ++n * 10) : "") + words + "\n";
  };
  block("G21 G90 G94 G17");
  block("G0 X0 Y0 Z10 A0 B0 C0");
  block("G1 Z0 F500");
  block("G1 X40 Y5 A2 B-1 C3");
  block("G2 X60 Y25 I0 J20 F800");
  block("G3 X60 Y25 I-10 J0");
  for (int i = 0; i < 30; ++i)
    block(fmt::format("G1 X{:.4f} Y{:.4f} Z{:.4f}", 60 - 0.005 * i, 25 - 0.007 * i, -0.002 * i));
  block("G2 X59.8 Y25.2 R0.3 F30");
  block("G93 G1 X30 A-3 F4");
  block("X31 B2 F20");
  block("G94 G1 C-2 F200");
  block("G0 Z20");
  block("G0 X0 Y0 A0 B0 C0");
  block("M2");
  return text;
}

}  // namespace

TEST_CASE("an unrolled program and written-out cycles are aligned with their original") {
  const std::string program =
      "G21 G90 G94 G17\nG0 X0 Y0 Z10 A0 B0 C0\nM98 P7 L2\n#1=0\no1 while [#1 lt 3]\nG1 X[#1*9] Y[1/3] F600\nG3 X0 Y5 "
      "R30\n#1=[#1+1]\no1 endwhile\nG99 G81 X5 Y5 Z-4 R2\nG91 X3 L3\nG80 G90 G0 Z20\nG5.1 X30 Y0 I9 J9\nG1 @20 ^30\n"
      "M2\nO7\nG1 X40 Y5 A2 F500\nG0 X0 Y0 A0\nM99\n";
  const testing::Scratch scratch;
  const std::string output = compensated(scratch, program);
  CHECK(output.find("o1 ") == std::string::npos);
  const DiffSummary s = diff_of(program, output);
  CHECK(is_whole(s));
  CHECK(s.moves_b > s.moves_a);
  CHECK(s.shift[index(Axis::Z)].largest < 0.05);
  CHECK(s.shift[index(Axis::Z)].largest > 0.005);
  CHECK(std::abs(s.seconds_b / s.seconds_a - 1) < 1e-3);
}

TEST_CASE("near the edge of the workspace shifts are large and change fast, and the moves are in line all the same") {
  for (const char* const moves :
       {"G0 X-244.7475 Y106.2342 Z161.3723 A-12.013866 B-14.1663 C-15.6094\nG1 Z25.9637 F2913.6\nG1 A-16.0507 "
        "B-16.5923 C-13.7341\nX188\n",
        "G0 X-115.2884 Y185.7896 Z134.2844 A-1.3629 B-12.6 C-10.7742\nG0 X-178.2934 Y-114.7871 Z149.8757 A9 B17.3405 "
        "C-14.0931\nG0 X-123.339 Y131.128 Z134.8333 A-13.6823\nG1 B11.316 F900\n",
        "G0 X-54.4021 Y-51.561 Z-18.4052 A-7.2167 B-13.6852 C4.3\nG0 X253.6928 Y226.8 Z162.1407 A-16.5905 B10.1721 "
        "C-1.1319\n"
        "G1 X240 F800\nG2 X230 Y216.8 I-10\nG2 X228 Y214.8 I-2\n",
        "G0 X-226.7289 Y160.1473 Z-209.9314 A13.9337 B-17.0887 C-12.6932\nG1 B19.8827 C-19.7995 F265.3\nG3 J2.1172\n"
        "G1 X221.7527 Y260.1235 Z200.3035\n"}) {
    INFO(moves);
    const testing::Scratch scratch;
    const DiffSummary s = diff_of(moves, compensated(scratch, moves, 7, 1));
    CHECK(is_whole(s));
    CHECK(s.shift[index(Axis::Z)].largest > 0.2);
    CHECK(s.time_change.value <= 0.0016);
  }
}

TEST_CASE("a last move whose end the correction moves by millimetres is in line, since its pieces take its time") {
  const std::string begin = "G0 X216.313 Y-32.084 Z89.15 A-3.269 B-9.072 C-6.437\nG1 B-3.753 F905\nY174.804 Z128\n";
  for (const char* const last : {"A-14.837 B13\n", "A-14.8 B13.05\n", "A-14.7 B13.1\n", "A-14.9 B12.9\n"}) {
    INFO(last);
    const testing::Scratch scratch;
    const DiffSummary s = diff_of(begin + last, compensated(scratch, begin + last, 2.70219927, 5.49456401));
    CHECK(s.out_of_line_a == 0);
    CHECK(s.out_of_line_b == 0);
    CHECK(s.shift[index(Axis::Z)].largest > 0.5);
  }
}

TEST_CASE(
    "a move beside a singularity, shifted by a quarter of its length, is in line, since its pieces take its time") {
  for (const char* const moves : {"G0 X-290 Y78.4 Z200 A-4.55 B1.2 C-0.7\nG1 X238.1 F2905.8\nB18.2\n",
                                  "G0 X-290 Y78.4 Z200 A-4.55 B1.2 C-0.7\nG1 X238.1 F900\nB18.3\nB17.5 Y77\n",
                                  "G0 X-290 Y78.4 Z204 A-4.55 B1.2 C-0.7\nG1 X238.1 F2905.8\nB18.2\n"}) {
    INFO(moves);
    const testing::Scratch scratch;
    const DiffSummary s = diff_of(moves, compensated(scratch, moves, 10.341017267, 5.285348696));
    CHECK(is_whole(s));
    CHECK(s.shift[index(Axis::Z)].largest > 2);
  }
}

TEST_CASE("pieces that take their move's time within the tolerance of the stamp are that move's, not the next one's") {
  for (const char* const moves :
       {"G0 X-16.153 Y-1.915 Z-224.05 A-15.63 B-2.196 C3.288\nG91\nG1 Z418.38 B17.72 F2000\n",
        "G0 X2.774 Y-1.915 Z-224.05 A-15.26 B-2.196 C3.288\nG91\nG1 Z420.25 B17.94 F3000\n",
        "G0 X-24.138 Y-1.915 Z-224.05 A-15.92 B-2.196 C3.288\nG91\nG1 Z421.83 B17.25 F1200\n"}) {
    INFO(moves);
    const std::string program = std::string(moves) + "G1 B4.599 C-13.987 A7.673\nM2\n";
    const testing::Scratch scratch;
    const DiffSummary s = diff_of(program, compensated(scratch, program, 2.994, 2.64, 0.006));
    CHECK(is_whole(s));
    CHECK(s.time_change.value <= 0.0061);
  }
}

TEST_CASE("pieces of micrometres are in line one by one, though rounding makes some a tenth longer") {
  const std::string begin = "G0 X3.0859 Y-4.845 Z-17.0213 A0.622 B4.9755 C-3.700267\nF483.1\n";
  for (const std::string points :
       {"G5.2 X18.5681 Y3.5691 P1 L3\nX30.4924 Y-.9531 P3\nX17.087 Y-13.1713 P3\nX39.1722 Y6. P3\nX15.0637 Y-31.8185 "
        "P1\n",
        "G5.2 X8.2 Y1.5 P1 L3\nX10.4 Y-.9 P4\nX7.1 Y-3.2 P4\nX5 Y-9 P1\n",
        "G5.2 X4 Y-1.5 P1 L3\nX6.4 Y-.3 P2\nX6.5 Y-.31 P2\nX6.5 Y-9 P1\n"}) {
    const std::string program = begin + points + "G5.3\nM2\n";
    INFO(program);
    const testing::Scratch scratch;
    const std::string output = compensated(scratch, program, 10, 5, 0.0085);
    const DiffSummary s = diff_of(program, output);
    CHECK(is_whole(s));
    for (const Axis axis : kAllAxes) CHECK(s.shift[index(axis)].largest < 0.05);
    CHECK(s.time_change.value <= 0.01);
  }
}

TEST_CASE("an N on a line before a move ends the pieces of the move before it") {
  const std::string a = "N1 G0 X2.9744 Y-12.6757 Z-31.0832\nN2 G1 Z-34.4847 F2792.4\nN3 Y-32.4877 Z23.1428\n";
  for (const std::string next :
       {"N4 G20\nN5 G5.1 X.02392 Y-1.09468 I-0.0591 J0.12919 F78\n", "N4 M8\nN5 G81 X5 Y-30 Z12 R14\nN6 G80\n",
        "N4 G91\nN5 G81 X.1 Y.1 Z-4 R-3 L4\nN6 G80\n"}) {
    INFO(next);
    const testing::Scratch scratch;
    const std::string output = compensated(scratch, a + next, 5, 5);
    INFO(output);
    const DiffSummary s = diff_of(a + next, output);
    CHECK(is_whole(s));
    CHECK(s.time_change.value <= 0.0016);
  }
}

TEST_CASE("the number of a block that ends a spline is that of all of its points, and ends none of them") {
  for (const char* const spline :
       {"G5.2 X8 Y6 P1 L3 F2028.6\nX8 Y-6 P1\nX0.05 Y0.03 P1\nN25 G5.3\n",
        "N20 G5.2 X-9 Y3 P1 L3 F600\nX-9 Y-4 P2\nX-0.06 Y0.02 P1\nN30 G5.3\n",
        "N20 G5.2 X-2 Y3 P1 L3 F900\nN21 X-9 Y4 P1\nN22 X-0.05 Y0.07 P1\nN23 G5.3\nN24 G1 X4\n"}) {
    const std::string program = std::string("G21 G90 G94 G17 G64\nG0 X0 Y0 Z9 A0 B0 C0\n") + spline + "M2\n";
    INFO(program);
    const testing::Scratch scratch;
    const DiffSummary s = diff_of(program, compensated(scratch, program, 5, 5));
    CHECK(is_whole(s));
  }
}

TEST_CASE("a program equals itself") {
  const DiffSummary s = diff_of(winding(false), winding(false));
  CHECK(s.equal_within(0, 0));
  CHECK(s.matched == s.moves_a);
  CHECK(s.moves_a == s.moves_b);
  CHECK(s.seconds_a > 1);
  CHECK(s.seconds_a == s.seconds_b);
}

TEST_CASE("a compensated program is in line with its source, with numbers and without") {
  const testing::Scratch scratch;
  for (const bool numbered : {true, false}) {
    for (const double step : {0.2, 1.0, 50.0}) {
      INFO("numbered " << numbered << ", step " << step);
      const std::string source = winding(numbered);
      const DiffSummary s = diff_of(source, compensated(scratch, source, step));
      CHECK(is_whole(s));
      CHECK(s.moves_b > s.moves_a);
      CHECK(s.points >= s.moves_b);
      CHECK(s.shift[2].largest > 0.01);
      CHECK(s.shift[2].largest < 0.1);
      CHECK(s.shift[2].rms < s.shift[2].largest);
      CHECK(s.time_change.value <= 0.0016);
      CHECK(s.seconds_b == Approx(s.seconds_a).epsilon(1e-3));
      CHECK_FALSE(s.equal_within(1e-4, 1e-4));
    }
  }
}

TEST_CASE("pieces of a line and chords of an arc equal it") {
  const std::string a = "G1 F100 X0 Y0\nG1 X10 Y5 C10\nG1 X20\n";
  const std::string b = "G1 F100 X0 Y0\nG1 X2.5 Y1.25 C2.5\nX5 Y2.5 C5\nX7.5 Y3.75 C7.5\nX10 Y5 C10\nG1 X20\n";
  const DiffSummary s = diff_of(a, b);
  CHECK(s.equal_within(1e-9, 1e-9));
  CHECK(s.matched == 3);
}

TEST_CASE("a moved block shows on its axis, with its lines") {
  const std::string a = "G0 X0 Y0\nG1 F100 X10\nY10\nX0\nY0\n";
  const std::string b = "G0 X0 Y0\nG1 F100 X10\nY10.3\nX0\nY0\n";
  const DiffSummary s = diff_of(a, b);
  CHECK(s.out_of_line_a == 0);
  CHECK(s.shift[1].largest == Approx(0.3));
  CHECK(s.shift[1].line_a == 3);
  CHECK(s.shift[1].line_b == 3);
  CHECK(s.shift[0].largest == 0);
}

TEST_CASE("an arc turned the other way is out of line") {
  const DiffSummary s = diff_of("G0 X0 Y0\nG2 X10 Y0 I5 F100\nG1 X20\n", "G0 X0 Y0\nG3 X10 Y0 I5 F100\nG1 X20\n");
  CHECK(s.out_of_line_a == 1);
  CHECK(s.out_of_line_b == 1);
  REQUIRE(s.out_of_line.size() == 1);
  CHECK(s.out_of_line[0].first_line_a == 2);
  CHECK_FALSE(s.equal_within(1, 1));
}

TEST_CASE("blocks that were put in or taken out are out of line, the rest is not") {
  std::string a = "G0 X0 Y0\nG1 F100 X0\n";
  for (int i = 1; i <= 100; ++i) a += fmt::format("X{} Y{}\n", i, i % 7);
  const std::size_t at = a.find("X50 ");
  const std::string b = a.substr(0, at) + "X20 Y30\nX22 Y33\n" + a.substr(at);
  const DiffSummary put_in = diff_of(a, b);
  CHECK(put_in.out_of_line_b <= 3);
  CHECK(put_in.out_of_line_a <= 1);
  CHECK(put_in.shift[0].largest < 1e-12);
  const DiffSummary taken_out = diff_of(b, a);
  CHECK(taken_out.out_of_line_a <= 3);
  CHECK(taken_out.shift[0].largest < 1e-12);
}

TEST_CASE("programs that have nothing in common end all the same") {
  std::string a = "G1 F100 X0\n";
  std::string b = "G1 F100 X0\n";
  for (int i = 1; i <= 200; ++i) {
    a += fmt::format("X{}\n", i * 3);
    b += fmt::format("Y{}\n", i * 5);
  }
  const DiffSummary s = diff_of(a, b);
  CHECK(s.matched + s.out_of_line_a == s.moves_a);
  CHECK(s.out_of_line_a > 190);
  CHECK(diff_of(a, "(nothing)\n").out_of_line_a == 201);
  CHECK(diff_of("(nothing)\n", a).out_of_line_b == 201);
}

TEST_CASE("another feed shows in the time") {
  const DiffSummary s = diff_of("G1 F100 X10\nX20\nG4 P2\n", "G1 F100 X10\nF50 X20\nG4 P3\n");
  CHECK(s.equal_within(0, 0));
  CHECK(s.seconds_a == Approx(14));
  CHECK(s.seconds_b == Approx(21));
  CHECK(s.time_change.value == Approx(1));
  CHECK(s.time_change.line == 2);
}

TEST_CASE("moves whose time only one program tells are in neither sum") {
  const std::string turn = "G1 F100 X10\nG1 A5\nX20\n";  // A alone has a time in both
  const std::string mixed = "G1 F100 X10\nG1 A5 Y0.001\nX20\n";
  settings::Options options;
  options.program.feed_rule = nc::FeedRule::unknown;
  const DiffSummary s = diff_of(turn, mixed, options);
  CHECK(s.matched == 3);
  CHECK(s.seconds_a == Approx(12));
  CHECK(s.seconds_b == Approx(12));
  CHECK(s.untimed.count == 1);
  CHECK(s.untimed.first_line == 2);
}

TEST_CASE("a diff is JSON for scripts") {
  const auto json = nlohmann::json::parse(report::diff_json(diff_of("G0 X1\n", "G0 X1.5 A1\n")));
  CHECK(json.at("plumbline") == "diff 1");
  CHECK(json.at("shift").at("X").at("largest_mm") == 0.5);
  CHECK(json.at("shift").at("A").at("largest_deg") == 1);
  CHECK(json.at("out_of_line_a") == 0);
}

TEST_CASE("a change of time is no share of nothing") {
  CHECK(report::diff_text(diff_of("G0 X1\n", "G1 F60 X1\n")).find("0.00 s in A, 1.00 s in B\n") != std::string::npos);
  CHECK(report::diff_text(diff_of("G1 F60 X1\n", "G1 F30 X1\n")).find("(+100.000 %)") != std::string::npos);
}

TEST_CASE("neither program may be empty, or no text") {
  const std::string program = "G0 X1 Y2\n";
  const std::string binary(
      "\x7f"
      "ELF\x01\x01\0\0\0\0\0\0",
      12);
  const auto code = [](const std::string& a, const std::string& b) {
    try {
      diff_of(a, b);
    } catch (const Refusal& refusal) {
      return refusal.diagnostic().code + " " + std::string(1, refusal.diagnostic().place.file.end()[-5]);
    }
    return std::string();
  };
  CHECK(code("", program) == "file-empty a");
  CHECK(code(program, "") == "file-empty b");
  CHECK(code(program, binary) == "file-not-text b");
  CHECK(code(binary, program) == "file-not-text a");
}

// Ends lie nearer together there than a friction turn moves them: time and what follows tell which is which.
TEST_CASE("tiny circles, tiny moves in front of long ones and last pieces beyond an end are aligned") {
  const std::string head = "G21 G90 G94 G54 G17\nG0 X0 Y0 Z3 A0 B0 C0\n";
  for (const char* const moves :
       {"G1 X20 Y5 F800\nG3 I0.00112 J0.0007\nG2 I0.01735 J-0.009 F57\nG1 X1 Y7\nG1 X1.0005 Y7.0004\n",
        "G2 I0.21 J0.05 F98.4\nG1 X0.0004 F40\nG1 X0.0007 Y0.0005 A0.0004\nG3 I-7.8 J6.3 F900\nG3 I0.0024 J0.0013\n",
        "G1 X5.0005 F300\nG1 X5 Y0.0006\nG1 X4.9996\nG2 X4.9998 Y0.0009 R0.0105 F10.6\nG1 Y-9 Z-2\n",
        "G1 A4 B-3 F700\nG1 A4.0007\nG1 X0.0003 A4.0009 F20\nG2 X0.2 Y0.1 R-0.15\nG1 X0.2003\nG0 Z9\n"}) {
    for (const double step_deg : {0.1, 1.0, 5.0}) {
      INFO(moves << step_deg);
      const testing::Scratch scratch;
      const std::string source = head + moves + "M2\n";
      const DiffSummary s = diff_of(source, compensated(scratch, source, 1, step_deg));
      CHECK(is_whole(s));
      CHECK(s.time_change.value <= 0.0016);
      for (const Axis axis : kAllAxes) CHECK(s.shift[index(axis)].largest < 0.06);
    }
  }
}

TEST_CASE("a stop that lost the turn of an axis leaves a compensated program in line with its source") {
  const testing::Scratch scratch;
  const std::string placed = "G54 G17 G90 G94 G710 G64\nG0 X0 Y0 Z20 A0 B0 C0\n";
  for (const std::string rest : {"G1 B=DC(359.9) F500\nM0\nG0 X1 Y0 Z21 A0 B0 C0\nG1 X30\n",
                                 "G1 A=DC(359.5) X3 F500\nM1\nG0 X1 Y0 Z21 A0 B0 C0\nG1 Y30\nA=DC(1)\n",
                                 "G0 C=DC(350)\nM0\nG0 X0 Y0 Z20 A0 B0 C=DC(20)\nG1 X30 F800\n"}) {
    INFO(rest);
    const std::string source = placed + rest + "M30\n";
    const DiffSummary s = diff_of(source, compensated(scratch, source));
    CHECK(is_whole(s));
    CHECK(s.shift[2].largest < 0.1);
  }
}
