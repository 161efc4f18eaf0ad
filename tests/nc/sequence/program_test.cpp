#include "nc/sequence/program.hpp"

#include <filesystem>

#include <catch2/catch.hpp>

#include "nc/programs.hpp"
#include "support/scratch.hpp"

using namespace plumbline;
using namespace plumbline::nc;
using namespace plumbline::nc::tests;
namespace fs = std::filesystem;

namespace {

std::string whole(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

std::string round_trip(const std::string& text) { return text_of_blocks(ProgramFile(text).path()); }

// True for programs whose blocks are not executed in the order of the text.
bool jumps(const std::string& path) {
  const InputFile file(path);
  Program program(file, dialect("linuxcnc"), empty_tables());
  while (program.next() != nullptr) continue;
  return program.jumped();
}

AxisSet axes_named_in(const std::string& text) {
  const ProgramFile program(text);
  const InputFile file(program.path());
  return named_axes(file, dialect("linuxcnc"));
}

}  // namespace

TEST_CASE("axes are looked for in what could be executed alone") {
  CHECK(axes_named_in("G0 X" + std::string(200'000, '[') + "\nA1\n") == AxisSet{Axis::A});
  CHECK(axes_named_in("M99999999999999\nA1\n") == AxisSet{Axis::A});
}

TEST_CASE("the texts of all blocks are the program, byte for byte") {
  for (const std::string text : {"", "\n", "G0 X1", "G0 X1\n", "G0 X1\r\nG1 X2 F3\r\n", "\r\n\n \t\n",
                                 "%\nG0 X1\n%\nbehind \x01 \xFF (\n\n% 3\n", "G0 X1 M2\n#!?\nG1 X\n", "%\r\nG0 X1\r\n%",
                                 "(M\xFCller) g0x1 ; \xE2\x82\xAC\n", "G0 X1 \r\r\nM30\r"}) {
    INFO(text);
    CHECK(round_trip(text) == text);
  }
  const std::string after = "M2\n" + std::string(1'000'000, 'x') + "\n" + std::string("\0\0\n", 3);
  CHECK(round_trip(after) == after);
}

TEST_CASE("a carriage return inside a line is refused in every dialect, and so is a byte order mark") {
  const testing::Scratch scratch;
  const auto refused = [&](std::string_view name, const std::string& text) {
    return testing::refusal_of([&] {
      const InputFile file(scratch.file("part.nc", text));
      Program program(file, dialect(name), at_zero());
      while (program.next() != nullptr) continue;
    });
  };
  const std::string mark = "\xEF\xBB\xBF";
  for (const std::string_view name : dialect_names()) {
    INFO(name);
    for (const std::string text : {"G90 G0 X10.\rY10.\nM2\n", "G90\rG0 X10.\rM2\r", "G90\r\nG0 X1.\rM2\r\n"}) {
      const Diagnostic diagnostic = refused(name, text);
      CHECK(diagnostic.code == "nc-bad-character");
      CHECK(diagnostic.help.find("line ends") != std::string::npos);
    }
    for (const std::string text : {"G21\n", "%\nO1\nM30\n", "%_N_MAIN_MPF\nM30\n"}) {
      const Diagnostic diagnostic = refused(name, mark + text);
      CHECK(diagnostic.code == "nc-bad-character");
      CHECK(diagnostic.help.find("BOM") != std::string::npos);
    }
    CHECK(refused(name, "G21\n\r\rM30\n\r\r").code == refused(name, "G21\nM30\n").code);
    CHECK(refused(name, "G21\r\nM30 \r\r\n").code == refused(name, "G21\nM30\n").code);
  }
}

TEST_CASE("the programs of others come out byte for byte as far as they are read") {
  if (corpus().empty()) {
    WARN("no corpus: name its folder in PLUMBLINE_NC_CORPUS");
    return;
  }
  int read = 0;
  for (const auto& entry : fs::directory_iterator(corpus() / "linuxcnc")) {
    if (entry.path().extension() != ".ngc" || refusal_of_file(entry.path().string(), empty_tables())) continue;
    INFO(entry.path());
    if (jumps(entry.path().string())) continue;
    CHECK(text_of_blocks(entry.path().string()) == whole(entry.path().string()));
    ++read;
  }
  CHECK(read >= 3);
}

TEST_CASE("a program ends at M2, M30 or the second %") {
  CHECK(motions_of("G0 X1\nM2\nG0 X2\n").size() == 1);
  CHECK(motions_of("G0 X1 M30\nG0 X2\n").size() == 1);
  CHECK(motions_of("\n %\nG0 X1\n%\nG0 X2\n").size() == 1);
  CHECK(motions_of("%\nG0 X1\n").size() == 1);
  CHECK(code_of("(c)\n%\n") == "nc-bad-character");
}

TEST_CASE("a line may be as long as the control reads, and no longer") {
  const std::size_t limit = dialect("linuxcnc").line_length;
  const std::string line = "G0 X1 (" + std::string(limit - 8, 'c') + ")";
  CHECK(code_of(line + "\n").empty());
  CHECK(code_of(line + "\r\n") == "nc-line-too-long");
  CHECK(code_of(line + " \n") == "nc-line-too-long");
  CHECK(code_of(std::string(3'000'000, ' ')) == "nc-line-too-long");
}

TEST_CASE("named axes are found without executing the program") {
  CHECK(axes_named_in("G0 X1 (Y2) ; Z3\nG1 b5 F10\n") == AxisSet{Axis::X, Axis::B});
  CHECK(axes_named_in("G0 X1\nM2\nC1\n") == AxisSet{Axis::X});
  CHECK(axes_named_in("G0 X1\nnonsense!\nA[1+#3]\n") == AxisSet{Axis::X, Axis::A});
  CHECK(axes_named_in("").empty());
}

TEST_CASE("named axes are found in the files of subprograms, whatever the control calls those") {
  struct Case {
    const char* control;
    const char* program;
    const char* file;
    const char* subprogram;
    AxisSet expected;
  };
  const AxisSet x_and_a{Axis::X, Axis::A};
  for (const Case& c : {
           Case{"linuxcnc", "G0 X1\no<Side> call\nM2\n", "side.ngc", "o<side> sub\nA1\no<side> endsub\n", x_and_a},
           Case{"linuxcnc", "G0 X1\no<side> call\nM2\n", "Side.ngc", "A1\n", {Axis::X}},
           Case{"linuxcnc", "G0 X1\nM98 P7\nM2\n", "7.ngc", "O7\nA1\nM99\n", x_and_a},
           Case{"fanuc", "O1\nG0 X1.\nM98 P7\nM30\n", "O0007.NC", "O7\nA1.\nM99\n", x_and_a},
           Case{"fanuc", "O1\nG0 X1.\nM98 P50007\nM30\n", "o0007", "O7\nA1.\nM99\n", x_and_a},
           Case{"fanuc", "O1\nG0 X1.\nG65 P7 B2. C3.\nM30\n", "7.nc", "A1.\nM99\n", x_and_a},
           Case{"fanuc", "O1\nG0 X1.\nGOTO 9\nM30\nN9 A1.\nM30\n", "none", "", x_and_a},
           Case{"okuma", "G0 X1\nCALL OSIDE\nM2\n", "OSIDE.SSB", "OSIDE\nA1\nRTS\n", x_and_a},
           Case{"siemens", "G0 X1\nSIDE\nM30\n", "side.spf", "A1\nM17\n", x_and_a},
           Case{"siemens", "G0 X1\nSIDE\nM30\n", "_N_SIDE_SPF", "A=IC(1)\nM17\n", x_and_a},
       }) {
    INFO(c.control << ": " << c.program << c.file);
    const testing::Scratch scratch;
    scratch.file(c.file, c.subprogram);
    const InputFile file(scratch.file("main.nc", c.program));
    CHECK(named_axes(file, dialect(c.control)) == c.expected);
  }
}

TEST_CASE("steps tell what they are") {
  const ProgramFile program("%\nG1 X1 F100\n\nM2\nrest\n");
  const InputFile file(program.path());
  Program steps(file, dialect("linuxcnc"), empty_tables());
  CHECK(steps.next()->block->kind == LineKind::percent);
  const Step* step = steps.next();
  CHECK(step->block->line == 2);
  CHECK(step->motions.size() == 1);
  CHECK(step->before->motion == MotionMode::none);
  CHECK(step->after->motion == MotionMode::feed);
  CHECK(step->after->feed == 100);
  CHECK(step->position[Axis::X] == 1);
  CHECK(step->named == AxisSet{Axis::X});
  CHECK(steps.next()->motions.empty());
  CHECK(steps.next()->block->kind == LineKind::block);
  CHECK(steps.next()->block->kind == LineKind::ignored);
  CHECK(steps.next() == nullptr);
}

TEST_CASE("the control reads nothing after the second %") {
  const std::string subprogram = "o100 sub\nG1 X5\no100 endsub\n";
  CHECK(code_of("%\nF100\no100 call\nM2\n%\n" + subprogram) == "nc-flow-open");
  CHECK(code_of("%\nF100\nM98 P100\nM2\n%\nO100\nG1 X5\nM99\n%\n") == "nc-flow-open");
  CHECK(code_of("%\nF100\no1 if [0]\nG1 X5\n%\no1 endif\nM2\n") == "nc-flow-open");
  CHECK(code_of("%\nF100\no100 call\nM2\n" + subprogram + "%\n").empty());
  CHECK(motions_of("F100\no100 call\nM2\n%\n" + subprogram).size() == 1);  // without the first it is no end
}

TEST_CASE("a % inside a subprogram ends the program, or is refused as the control does") {
  const std::string subprogram = "F100\no100 call\nG1 X9\nM2\no100 sub\nG1 X5\n%\no100 endsub\n";
  CHECK(motions_of("%\n" + subprogram).size() == 1);
  CHECK(code_of(subprogram) == "nc-bad-character");
}

TEST_CASE("what a few letters spell counts for --max-blocks") {
  ProgramSettings settings = empty_tables();
  settings.max_blocks = 1000;
  CHECK(code_of("F100\nG81 X1 Y1 Z-1 R1 L400\nM2\n", settings) == "nc-too-many-blocks");
  CHECK(code_of("F100\nG81 X1 Y1 Z-1 R1 L300\nM2\n", settings).empty());
  CHECK(code_of("F100\nG2 I1 P2000\nM2\n", settings) == "nc-too-many-blocks");
  CHECK(code_of("F100\nG2 I1 P400\nG3 I1 P400\nM2\n", settings).empty());
  CHECK(code_of("F100\nG2 I1 P400\nG3 I1 P400\nG81 Z-1 R1 L100\nM2\n", settings) == "nc-too-many-blocks");
  CHECK(code_of("F100\nG83 Z-1 R1 Q.005\nM2\n", settings) == "nc-too-many-blocks");
  CHECK(code_of("F100\nG2 I1 P1000000000\nM2\n") == "nc-too-many-blocks");
}
