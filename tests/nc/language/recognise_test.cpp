#include "nc/language/recognise.hpp"

#include <catch2/catch.hpp>

#include "base/diagnostic.hpp"
#include "nc/programs.hpp"

using namespace plumbline;
using namespace plumbline::nc;
using namespace plumbline::nc::tests;

namespace {

std::string dialect_of(std::string_view text, std::string_view ending = ".nc") {
  const ProgramFile file(text, ending);
  return recognise(InputFile(file.path())).dialect->name;
}

std::string refusal_of_look(std::string_view text) {
  const ProgramFile file(text);
  try {
    recognise(InputFile(file.path()));
  } catch (const Refusal& refusal) {
    return refusal.diagnostic().code;
  }
  return "";
}

}  // namespace

TEST_CASE("what only one dialect has names it") {
  CHECK(dialect_of("G21\no100 sub\no100 endsub\n") == "linuxcnc");
  CHECK(dialect_of("#<depth>=5\n") == "linuxcnc");
  CHECK(dialect_of("%\nG90 g54.1p2 X0\n") == "fanuc");
  CHECK(dialect_of("IF[#1EQ#0]GOTO10\n") == "fanuc");
  CHECK(dialect_of("N1G15H1\n") == "okuma");
  CHECK(dialect_of("CALL OPULL PL=5\n") == "okuma");
  CHECK(dialect_of("N10 G1 X=IC(5)\n") == "siemens");
  CHECK(dialect_of("%_N_TEIL_MPF\n;$PATH=/_N_MPF_DIR\nG1 X5\n") == "siemens");
  CHECK(dialect_of("MSG(\"HALT\")\n") == "siemens");
}

TEST_CASE("what all dialects have is read as LinuxCNC's, unless the program begins with its number") {
  CHECK(dialect_of("") == "linuxcnc");
  CHECK(dialect_of("%\nN10 G90 G54 G0 X10. Y5. A3. S800 M3\nG1 Z-2. F200\nM30\n%\n") == "linuxcnc");
  CHECK(dialect_of("%\nO1234 (PART)\nG0 X10.\n") == "fanuc");
  CHECK(dialect_of("G0 X10.\nO1234\n") == "linuxcnc");
  CHECK(dialect_of("O1234\no100 if [1]\no100 endif\n") == "linuxcnc");
  CHECK(dialect_of("O1234\nG15 H1\n") == "okuma");
}

TEST_CASE("an NE after a bracket is no label") {
  CHECK(dialect_of("#3=2\no527 if [[#3+1] NE 3]\nG0 X1\no527 endif\n") == "linuxcnc");
  CHECK(dialect_of("#1=[[2*3] ne #<depth>]\nG0 X1\n") == "linuxcnc");
  CHECK(dialect_of("#<a>=1\nG0 X[[1]NE[2]]\n") == "linuxcnc");
  CHECK(dialect_of("IF [VC1 EQ 2] NLAB\n") == "okuma");
  CHECK(dialect_of("IF[VC1 EQ 2]N10\n") == "okuma");
}

TEST_CASE("G700 and G710 are a SINUMERIK's") {
  CHECK(dialect_of("N10 G710 G90 G17 G54 G64 G94\nN11 T1 M6\nN12 D1\n") == "siemens");
  CHECK(dialect_of("G17G700G90\nG0 X1\n") == "siemens");
  CHECK(dialect_of("T2 D1 M6\nG90 G54 g710\n") == "siemens");
  CHECK(dialect_of("N710 G71 X700 (G710)\nG0 X1\n") == "linuxcnc");
  CHECK(dialect_of("G70.1 X1\nG0 X710\n") == "linuxcnc");
  CHECK(dialect_of("%\nO1234\nG0 X710.\n") == "fanuc");
}

TEST_CASE("comments show nothing") {
  CHECK(dialect_of("(TRAORI)\nG0 X1. ; CALL O1000\n") == "linuxcnc");
  CHECK(dialect_of("(POST: G54.1 P2 AND #<name>)\nG0 X1.\n") == "linuxcnc");
}

TEST_CASE("a file that ends in .ngc is LinuxCNC's unless its text shows another control") {
  CHECK(dialect_of("O1000\nT1 M6\nG0 X10\n", ".ngc") == "linuxcnc");
  CHECK(dialect_of("%\nO1000\nM72\n", ".NGC") == "linuxcnc");
  CHECK(dialect_of("%\nO1000\nG54.1 P2\n", ".ngc") == "fanuc");
  CHECK(dialect_of("G15 H1\n", ".ngc") == "okuma");
  CHECK(dialect_of("O1000\nT1 M6\nG0 X10\n", ".tap") == "fanuc");
}

TEST_CASE("digits of a code are digits") {
  CHECK(dialect_of("G59.1\nG0 X1\n") == "linuxcnc");
  CHECK(dialect_of("#<a>=1\ng59.3 g0 x1\n") == "linuxcnc");
  CHECK(dialect_of("G50.1 X0\n") == "fanuc");
  CHECK(dialect_of("G05.1 Q1\n") == "fanuc");
  CHECK(dialect_of("G05 P10000\n") == "fanuc");
  CHECK(dialect_of("N5 G500 X1\n") == "siemens");
  CHECK(dialect_of("WHILE [#1 LT 3] DO1\n") == "fanuc");
  CHECK(dialect_of("VC12=3\n") == "okuma");
  CHECK(dialect_of("R12=3\n") == "siemens");
}

TEST_CASE("names and texts of the program's own show nothing") {
  CHECK(dialect_of("o<cycle_drill> call\n") == "linuxcnc");
  CHECK(dialect_of("#<process>=1\n#<trans_x>=2\n#<ret> = 3\n") == "linuxcnc");
  CHECK(dialect_of("G0 X#<Goto 5>\n") == "linuxcnc");
  CHECK(dialect_of("MSG(\"CALL OPERATOR, GOTO 5\")\nG0 X1\n") == "siemens");
  CHECK(dialect_of("IF R1<R2 GOTOF END1\n") == "siemens");
}

TEST_CASE("codes that builders of other controls use show LinuxCNC's where nothing else is shown") {
  CHECK(dialect_of("M62 P1\nG0 X1\n") == "linuxcnc");
  CHECK(dialect_of("G54.1 P2\nM72\n") == "fanuc");
  CHECK(dialect_of("G15 H1\nM73\n") == "okuma");
  CHECK(refusal_of_look("%\nO1234\nM72\nG0 X10\n") == "nc-dialect-ambiguous");
  CHECK(refusal_of_look("O1\nG0 X10\nM64 P1\n") == "nc-dialect-ambiguous");
}

TEST_CASE("what shows two dialects is refused") {
  CHECK(refusal_of_look("TRAORI\nG54.1 P2\n") == "nc-dialect-ambiguous");
  CHECK(refusal_of_look("G15 H1\no<tool> call\n") == "nc-dialect-ambiguous");
  CHECK(refusal_of_look("G90 G0 X1\n").empty());
}

TEST_CASE("marks begin with what they look for, not with what stands for something else") {
  for (const std::string_view name : dialect_names()) {
    for (const auto* const marks : {&marks_of_dialect(name).marks, &marks_of_dialect(name).weak_marks}) {
      for (const std::string& mark : *marks) {
        INFO(name << ": " << mark);
        REQUIRE(!mark.empty());
        CHECK(std::string_view(" *~$!").find(mark.front()) == std::string_view::npos);
      }
    }
  }
}
