// The emitter alone: corrections made up here, so that every digit of the output can be predicted.
//
// With it the parts that show in whole blocks alone: emit_block.cpp (a piece becomes a line), emit_pieces.cpp (points
// become pieces), output/output_text.cpp (stamp, line ends, the order of the text). In programs that are compensated:
// emit_holes.cpp in tests/compensate/fanuc_test.cpp, siemens_cycles_test.cpp and flow_test.cpp; emit_refusals.cpp there
// too, in dialects_test.cpp and rotary_test.cpp.
#include "nc/rewrite/emit.hpp"

#include <functional>

#include <catch2/catch.hpp>

#include "base/diagnostic.hpp"
#include "nc/sequence/program.hpp"
#include "path/curve.hpp"
#include "path/duration.hpp"
#include "support/scratch.hpp"

using namespace plumbline;
using nc::CorrectedPoint;

namespace {

using Shift = std::function<AxisWords(const AxisWords&)>;

struct Rewriting {
  std::string_view dialect = "linuxcnc";
  int pieces = 1;     // of every cutting move
  bool arcs = false;  // that are arcs are arcs, their centres shifted as the points are
  Shift shift = [](const AxisWords&) { return AxisWords{}; };
  nc::EmitSettings emit = {.stamp = {"stamped"}};
  nc::ProgramSettings program;
};

nc::ProgramSettings known_start() {
  nc::ProgramSettings settings;
  for (auto& offset : settings.work_offsets) offset = nc::WorkOffset{};
  for (auto& start : settings.start) start = 0;
  return settings;
}

nc::Arc shifted(nc::Arc arc, const AxisWords& by, bool is_part) {
  for (const Axis axis : {Axis::X, Axis::Y, Axis::Z}) arc.centre_mm[index(axis)] += by[axis];
  if (is_part) arc.turns = arc.turns > 0 ? 1 : -1;
  return arc;
}

std::string rewrite(const std::string& text, const Rewriting& how) {
  const testing::Scratch folder;
  write_text(folder / "in.ngc", text);
  {
    const InputFile source(folder / "in.ngc");
    OutputFile out(folder / "out.ngc");
    const nc::Dialect& dialect = nc::dialect(how.dialect);
    nc::Program program(source, dialect, how.program);
    nc::Emitter emitter(source, dialect, how.emit, out);
    while (const nc::Step* step = program.next()) {
      if (step->role != nc::BlockRole::plain || step->motions.size() != 1 ||
          step->motions[0].kind == nc::MotionKind::dwell) {
        emitter.copy(*step);
        continue;
      }
      const nc::Motion& m = step->motions[0];
      const int n = m.kind == nc::MotionKind::rapid ? 1 : how.pieces;
      const path::Curve curve(m);
      std::vector<CorrectedPoint> points;
      for (int i = 1; i <= n; ++i) {
        const AxisWords at = curve.at(static_cast<double>(i) / n);
        points.push_back({at, how.shift(at), 1.0 / n});
        if (how.arcs && m.kind == nc::MotionKind::arc) points.back().arc = shifted(m.arc, how.shift(at), n > 1);
      }
      emitter.move(*step, points, AxisSet::all(), path::duration(m, curve, dialect));
    }
    emitter.finish();
    out.commit();
  }
  return read_text(folder / "out.ngc");
}

Rewriting lift(double z, int pieces = 1) {  // everything up by z mm
  Rewriting how;
  how.pieces = pieces;
  how.program = known_start();
  how.shift = [z](const AxisWords&) { return AxisWords{{0, 0, z, 0, 0, 0}}; };
  return how;
}

Rewriting slope(double per_mm, int pieces = 1) {  // Z rises with X
  Rewriting how = lift(0, pieces);
  how.shift = [per_mm](const AxisWords& at) { return AxisWords{{0, 0, per_mm * at[Axis::X], 0, 0, 0}}; };
  return how;
}

}  // namespace

TEST_CASE("without a correction the output is the input, byte for byte") {
  const std::string text =
      "%\r\n( a part )\r\nN10 g21 G90  g94\r\n/ M8\r\nG0X1.0Y 2 ; fast\r\nG1 Z-1 F100\r\nG2 X3 I1 (arc)\r\n#1=5\r\n"
      "G1X[#1+1]\r\nG91 X.1\r\nM30\r\n%\r\nbehind the end\r\n\r\nlast";
  CHECK(rewrite(text, lift(0)) == text);
  CHECK(rewrite(text, lift(0.00004)) == text);  // rounds to zero at four digits
}

TEST_CASE("only the words that must change do; new ones stand after the last axis word, spelt like it") {
  CHECK(rewrite("G0 X1 Y2 Z3\n", lift(0.01)) == "(stamped)\nG0 X1 Y2 Z3.01\n");
  CHECK(rewrite("g0x1y2\n", lift(0.01)) == "(stamped)\ng0x1y2z0.01\n");
  CHECK(rewrite("G0 X1.500 Y2 (there) M8\n", lift(-0.01)) == "(stamped)\nG0 X1.500 Y2 Z-0.01 (there) M8\n");
}

TEST_CASE("the stamp stands after %, and the comments that the program begins with") {
  CHECK(rewrite("%\n(part 7)\n\n(by hand)\n\nG21\nG0 X1\n", lift(0.01)) ==
        "%\n(part 7)\n\n(by hand)\n(stamped)\n\nG21\nG0 X1 Z0.01\n");
}

TEST_CASE("decimals are at least those of the source") {
  CHECK(rewrite("G0 X0 Z1.123456\n", lift(0.1)) == "(stamped)\nG0 X0 Z1.223456\n");
  CHECK(rewrite("G20\nG0 X0 Z1\n", lift(0.254)) == "(stamped)\nG20\nG0 X0 Z1.01\n");
}

TEST_CASE("a move is cut: N, S and comments stay on the first piece, M2 moves to the last") {
  CHECK(rewrite("G94 F600\nN7 G1 X4 Y0 S100 M2 (cut)\n", slope(0.01, 4)) ==
        "(stamped)\nG94 F600\nN7 G1 X1 Y0 Z0.01 S100 (cut)\nX2 Z0.02\nX3 Z0.03\nX4 Z0.04 M2\n");
}

TEST_CASE("blocks after a correction find the axes where they take them to be") {
  // Z is corrected at X4 and must come back to zero at X0, although the block does not name it.
  CHECK(rewrite("G1 F600 X4\nX0\nY5\n", slope(0.01)) == "(stamped)\nG1 F600 X4 Z0.04\nX0 Z0\nY5\n");
}

TEST_CASE("a motion code without axis words gets those of its correction") {
  // The control comes from a move in machine coordinates, where nothing is corrected.
  CHECK(rewrite("G0 X1\nG53 G0 Z0\nG1 F500\nX2\n", lift(0.01)) ==
        "(stamped)\nG0 X1 Z0.01\nG53 G0 Z0\nG1 F500 Z0.01\nX2\n");
}

TEST_CASE("increments lead from one corrected point to the next, without drift") {
  const std::string text = "G91 G1 F600 X1\nX1\nX1\nX-3\n";
  CHECK(rewrite(text, slope(0.00003)) == "(stamped)\nG91 G1 F600 X1\nX1 Z0.0001\nX1\nX-3 Z-0.0001\n");
}

TEST_CASE("an arc becomes straight pieces, and the motion code comes back for the blocks that count on it") {
  CHECK(rewrite("G17 G1 X10 Y0 F600\nG3 X0 Y10 I-10 J0\nX-10 Y0 R10\n", lift(0.01, 2)) ==
        "(stamped)\nG17 G1 X5 Y0 Z0.01 F600\nX10\nG1 X7.0711 Y7.0711 F584.699\nX0 Y10\nX-7.0711 Y7.0711\nX-10 Y0\n");
  Rewriting once = lift(0);  // only above Y15
  once.shift = [](const AxisWords& at) { return AxisWords{{0, 0, at[Axis::Y] > 15 ? 0.01 : 0, 0, 0, 0}}; };
  CHECK(rewrite("G1 X0 Y10 F600\nG3 X0 Y20 I0 J5\nX0 Y10 I0 J-5\nX0 Y0 I0 J-5\n", once) ==
        "(stamped)\nG1 X0 Y10 F600\nG1 X0 Y20 Z0.01 F381.972\nX0 Y10 Z0\nF600\nG3 X0 Y0 I0 J-5\n");
}

TEST_CASE("an arc that stays one gets other words in place of its own") {
  Rewriting how = lift(0);
  how.arcs = true;
  how.shift = [](const AxisWords&) { return AxisWords{{0.004, 0.002, 0.003, 0, 0, 0}}; };
  const std::string begin = "G17 G1 X10 Y0 F600\n";
  const std::string then = "(stamped)\nG17 G1 X10.004 Y0.002 Z0.003 F600\n";
  CHECK(rewrite(begin + "N5 G3 X0 Y10 I-10 J0 M8 (arc)\n", how) == then + "N5 G3 X0.004 Y10.002 I-10 J0 M8 (arc)\n");
  CHECK(rewrite(begin + "g3x0y10r10\n", how) == then + "g3x0.004y10.002i-10j0\n");
  CHECK(rewrite(begin + "G3 R10 X0 Y10\n", how) == then + "G3 I-10 J0 X0.004 Y10.002\n");
  CHECK(rewrite(begin + "G2 I-5 P3\n", how) == then + "G2 I-5 J0 P3\n");
  CHECK(rewrite(begin + "G90.1 G3 X0 Y10 I0 J0\n", how) == then + "G90.1 G3 X0.004 Y10.002 I0.004 J0.002\n");
  CHECK(rewrite(begin + "G91 G3 X-10 Y10 I-10 J0\n", how) == then + "G91 G3 X-10 Y10 I-10 J0\n");
  CHECK(rewrite(begin + "G18 G2 X20 Z10 I10 K0\n", how) == then + "G18 G2 X20.004 Z10.003 I10 K0\n");
  CHECK(rewrite(begin + "G19 G2 Z10 Y10 K10 J0\n", how) == then + "G19 G2 Z10.003 Y10.002 K10 J0\n");
}

TEST_CASE("arcs that an arc becomes hold what moves and where their centres are") {
  Rewriting how = lift(0.01, 2);
  how.arcs = true;
  CHECK(rewrite("G17 G1 X10 Y0 F600\nG3 X-10 Y0 R10\nX10 I10 P2 M0\n", how) ==
        "(stamped)\nG17 G1 X5 Y0 Z0.01 F600\nX10\nG3 X0 Y10 I-10 J0\nX-10 Y0 I0 J-10\n"
        "X0 Y10 I10 J0\nX10 Y0 I0 J-10 M0\n");
}

TEST_CASE("a full circle without axis words gets them") {
  Rewriting how = lift(0.01, 2);
  CHECK(rewrite("G1 X10 F600\nG2 I-5 J0 M8\n", how) == "(stamped)\nG1 X5 Z0.01 F600\nX10\nG1 X0 M8 F381.972\nX10\n");
}

TEST_CASE("inverse time: each piece its share, and never below the least rate of the control") {
  CHECK(rewrite("G93 G1 X4 F10\n", slope(0.01, 4)) ==
        "(stamped)\nG93 G1 X1 Z0.01 F40\nX2 Z0.02 F40\nX3 Z0.03 F40\nX4 Z0.04 F40\n");
  CHECK(rewrite("G93 G1 X4 F10\n", lift(0.01)) == "(stamped)\nG93 G1 X4 Z0.01 F10\n");
  // A turn of A that gains 0.01 mm of Z: 0.01 mm x 2/min is below 0.1 mm/min, so that block goes under G94.
  CHECK(rewrite("G93 G1 A5 F2\nG1 X5 F2\n", lift(0.01)) == "(stamped)\nG94 G1 A5 Z0.01 F0.02\nG1 G93 X5 F2\n");
}

TEST_CASE("feed per minute: F only where the time would change, and the F of the program afterwards") {
  CHECK(rewrite("G94 G1 X4 F60\nX8\n", slope(0.01)) == "(stamped)\nG94 G1 X4 Z0.04 F60\nX8 Z0.08\n");
  // A purely rotary block: 5 deg at 60 deg/min are 5 s; the 0.01 mm of Z that it gains must take them too.
  Rewriting at_five = lift(0);
  at_five.shift = [](const AxisWords& at) { return AxisWords{{0, 0, at[Axis::A] > 4 ? 0.01 : 0, 0, 0, 0}}; };
  CHECK(rewrite("G94 G1 A5 F60\nA5 X3\n(done)\nA5 X6\n", at_five) ==
        "(stamped)\nG94 G1 A5 Z0.01 F0.12\nA5 X3 F60\n(done)\nA5 X6\n");
}

TEST_CASE("offsets set from where the control stands come out as in the original") {
  CHECK(rewrite("G0 X1\nG92 Z5\nG0 Z6\n", lift(0.01)) == "(stamped)\nG0 X1 Z0.01\nG92 Z5.01\nG0 Z6.01\n");
  CHECK(rewrite("G0 X1\nG10 L20 P1 Z5\nG0 Z6\n", lift(0.01)) == "(stamped)\nG0 X1 Z0.01\nG10 L20 P1 Z5.01\nG0 Z6.01\n");
  CHECK_THROWS_AS(rewrite("G0 X1\nG28.1\n", lift(0.01)), Refusal);
}

TEST_CASE("an offset set for a system that is turned counts in the directions of that system") {
  Rewriting aside = lift(0);
  aside.shift = [](const AxisWords&) { return AxisWords{{0.01, 0, 0, 0, 0, 0}}; };
  CHECK(rewrite("G10 L2 P2 R90\nG0 X1\nG10 L20 P2 X5 Y7\nG10 L20 P1 X5\n", aside) ==
        "(stamped)\nG10 L2 P2 R90\nG0 X1.01\nG10 L20 P2 X5 Y6.99\nG10 L20 P1 X5.01\n");
}

TEST_CASE("moves in machine coordinates go through as they stand") {
  CHECK(rewrite("G0 X1\nG53 G0 Z7\nG0 X2\n", lift(0.01)) == "(stamped)\nG0 X1 Z0.01\nG53 G0 Z7\nG0 X2 Z7.01\n");
}

TEST_CASE("exact stop holds at the last piece only") {
  CHECK(rewrite("G61.1\nG1 X2 F60\n", slope(0.01, 2)) == "(stamped)\nG61.1\nG1 G61 X1 Z0.01 F60\nG61.1 X2 Z0.02\n");
}

TEST_CASE("block delete: the choice is applied") {
  Rewriting how = lift(0.01);
  how.program.block_delete = true;
  CHECK(rewrite("/G0 X5\nG0 X1\n/G0 X6\n", how) ==
        "(stamped)\n(block delete is on: this block was left out)\nG0 X1 Z0.01\n(block delete is on: this block was "
        "left out)\n");
  CHECK(rewrite("G0 X1\n/ O9\n/O1 sub\n", how) ==
        "(stamped)\nG0 X1 Z0.01\n(block delete is on: this block was left out)\n(block delete is on: this block was "
        "left out)\n");
  for (const char* const first : {"/ O9\n", "/\n"}) {
    CHECK(rewrite(std::string(first) + "(note)\nG0 X1\n", how) ==
          "(stamped)\n(block delete is on: this block was left out)\n(note)\nG0 X1 Z0.01\n");
  }
  how.program.block_delete = false;
  CHECK(rewrite("G0 X1\n/G0 X6\n/(note)\n", how) == "(stamped)\nG0 X1 Z0.01\nG0 X6\n/(note)\n");
}

TEST_CASE("what sets an offset from where the control stands is changed behind / as elsewhere") {
  Rewriting how = lift(0.01);
  how.program.block_delete = false;
  CHECK(rewrite("G0 X1\n/G92 Z5\nG0 Z6\n", how) == "(stamped)\nG0 X1 Z0.01\nG92 Z5.01\nG0 Z6.01\n");
  CHECK(rewrite("G0 X1\n/N8 X2 G92 Z5\nG0 Z6\n", how) == "(stamped)\nG0 X1 Z0.01\nN8 X2 G92 Z5.01\nG0 Z6.01\n");
  CHECK(rewrite("G0 X1\n/G10 L20 P1 Z5\nG0 Z6\n", how) == "(stamped)\nG0 X1 Z0.01\nG10 L20 P1 Z5.01\nG0 Z6.01\n");
  CHECK(testing::refusal_of([&] { rewrite("G0 X1\n/G10 L20 P1 Z0 G43.1\n", how); }).code == "emit-shared-words");
  how.program.block_delete = true;
  CHECK(rewrite("G0 X1\n/G92 Z5\nG0 Z6\n", how) ==
        "(stamped)\nG0 X1 Z0.01\n(block delete is on: this block was left out)\nG0 Z6.01\n");
}

TEST_CASE("words that set a tool length as well as move are not corrected") {
  const std::string text = "G0 X1\nG43.1 Z8 G0 X2\n";
  CHECK(rewrite(text, lift(0)) == text);
  CHECK(testing::refusal_of([&] { rewrite(text, lift(0.01)); }).code == "emit-shared-words");
}

TEST_CASE("words that set an offset by the corrected place as well as a tool length are not corrected") {
  for (const char* const block : {"G10 L20 P1 X0 G43.1\n", "G43.1 G92 X0\n"}) {
    const std::string text = "G0 X1\n" + std::string(block);
    INFO(text);
    CHECK(rewrite(text, lift(0)) == text);
    Rewriting aside = lift(0);
    aside.shift = [](const AxisWords&) { return AxisWords{{0.01, 0, 0, 0, 0, 0}}; };
    CHECK(testing::refusal_of([&] { rewrite(text, aside); }).code == "emit-shared-words");
  }
}

TEST_CASE("what the control resolves bounds the digits") {
  Rewriting how = lift(0.0123);
  how.emit.increment_mm = 0.005;
  CHECK(rewrite("G0 X1\n", how) == "(stamped)\nG0 X1 Z0.01\n");
}

TEST_CASE("a block that grows over the control's line is refused") {
  const std::string comment(242, 'c');
  CHECK_THROWS_AS(rewrite("G0 X1 (" + comment + ")\n", lift(0.0123)), Refusal);
}

TEST_CASE("a word that says where an axis stands keeps the offset that the original gives, to all its decimals") {
  // the control stands on four decimals then, the offset of the original has five and more
  CHECK(rewrite("G0 Z1.23456\nG92 Z5.123456\n", lift(0.01)) == "(stamped)\nG0 Z1.24456\nG92 Z5.133456\n");
  CHECK(rewrite("G21 G0 Z25.4\nG20\nG92 Z2.5\n", lift(0.01)).ends_with("G92 Z2.500393701\n"));
  CHECK(rewrite("G0 Z1\nG10 L20 P1 Z.0123456\n", lift(0.01)).ends_with("Z0.0223456\n"));
}
