// The way out that a refusal names is one of the control's own: no code or word of another control.
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "nc/programs.hpp"

using namespace plumbline;
using namespace plumbline::nc;
using namespace plumbline::nc::tests;

namespace {

struct Case {
  const char* dialect;
  std::string program;
  std::string names;     // what the message or its help says
  std::string does_not;  // and what it must not
};

std::string said_of(const Case& c) {
  ProgramSettings settings = empty_tables();
  const ProgramFile program(c.program);
  const InputFile file(program.path());
  try {
    Program blocks(file, dialect(c.dialect), settings);
    while (blocks.next() != nullptr) {
    }
  } catch (const Refusal& refusal) {
    return refusal.diagnostic().message + " | " + refusal.diagnostic().help;
  }
  return "";
}

void check(const std::vector<Case>& cases) {
  for (const Case& c : cases) {
    INFO(c.dialect << ": " << c.program);
    const std::string said = said_of(c);
    INFO(said);
    CHECK_FALSE(said.empty());
    CHECK(said.find(c.names) != std::string::npos);
    CHECK((c.does_not.empty() || said.find(c.does_not) == std::string::npos));
  }
}

}  // namespace

TEST_CASE("where the centre of an arc counts from is said in the control's own words") {
  check({{"linuxcnc", "F9\nG2 X10 I3\nM2\n", "G90.1", "AC("},
         {"fanuc", "O1\nG54 G0 X0 Y0\nG2 X10. I3. F9.\nM30\n", "from the start of the arc", "G90.1"},
         {"okuma", "G15 H1\nG0 X0 Y0\nG2 X10 I3 F9\nM2\n", "from the start of the arc", "G90.1"},
         {"siemens", "G54\nG0 X0 Y0\nG2 X10 I3 F9\nM30\n", "I=AC(..)", "G90.1"},
         {"siemens", "G54\nG0 X0 Y0\nG2 X10 I3 CR=3 F9\nM30\n", "CR=", "either R"}});
}

TEST_CASE("parameters, levels and counts of another control are not named") {
  check({{"fanuc", "O1\nG0 X[1,2]\nM30\n", "stands one of * /", "**"},
         {"linuxcnc", "G0 X[1,2]\nM2\n", "stands one of ** * /", ""},
         {"okuma", "G15 H1\nG18 G0 X0 Y50 Z0\nG71 Y50\nG81 X9 Y-5 R2 F9 M53\nM2\n", "G18 and G19", "5101"},
         {"fanuc", "O1\nG54 G18 G0 X0 Y50. Z0\nG81 X9. Y-5. R2. F9.\nM30\n", "5101", ""},
         {"fanuc", "O1\nG4 P0.5\nM30\n", "X and seconds", ""},
         {"fanuc", "O1\n#5221=5.\nM30\n", "G92", "G28.1"},
         {"fanuc", "O1\n#2001=5.\nM30\n", "#100 to #199", "G10 L1,"},
         {"linuxcnc", "#5420=5\nM2\n", "G28.1", "#100 to #199"}});
}

TEST_CASE("values, subprograms and calls are spoken of as the control writes them") {
  check({{"siemens", "G54\nG1 X(5) F9\nM30\n", "(expression)", "#parameter"},
         {"okuma", "G15 H1\nG1 X[5+3] F9\nM2\n", "[expression]", "#parameter"},
         {"fanuc", "O1\n#1=BIN[16]\nM30\n", "no function that is known", ""},
         {"fanuc", "O1\nM98 P9\nM30\nO9\nG4 P1\n", "M99", "RTS"},
         {"okuma", "CALL O9\nM2\nO9\nG4 F1\n", "RTS", "M99"},
         {"siemens", "L9\nM30\n%_N_L9_SPF\nG4 F1\n", "M17 or RET", "M99"},
         {"linuxcnc", "G0 M99 X5\nM2\n", "M99 stands alone", "M98"},
         {"siemens", "G54\nSUPA G2 X9 I4 F9\nM30\n", "SUPA", "G53"},
         {"siemens", "G54\nG91\nG0 SUPA X9\nM30\n", "SUPA", "G53"}});
}

TEST_CASE("the way out of a code that is not read is the one that its row names") {
  check({{"fanuc", "O1\nG66 P9\nM30\n", "| write G65 after each", "write it out in G0"},
         {"siemens", "FGREF[A]=10\nM30\n", "| write FGROUP(X,Y,Z)", "write it out in G0"},
         {"okuma", "G54 X5\nM2\n", "write G56 H", "write it out in G0"},
         {"okuma", "M16\nM2\n", "", "write it out in G0"},
         {"okuma", "M83\nM2\n", "--pass M83", "write it out in G0"},
         {"siemens", "MIRROR X0\nM30\n", "| write it out in G0", ""}});
}

TEST_CASE("a tap and a measurement are not to be written out in plain moves") {
  check({{"siemens", "G54\nSPOS=0\nG331 Z40 K1 S100\nM30\n", "| write a tap as CYCLE84", "write it out in G0"},
         {"siemens", "G54\nG332 Z50 K1 S100\nM30\n", "CYCLE840", "write it out in G0"},
         {"siemens", "G54\nG63 Z40 F100\nM30\n", "CYCLE84", "write it out in G0"},
         {"siemens", "G54\nG33 Z40 K1\nM30\n", "does not follow the spindle", "write it out in G0"},
         {"siemens", "G54\nMEAS=1 G1 Z10 F100\nM30\n", "does not stop at the contact", "write it out in G0"},
         {"fanuc", "O1\nG33 Z-5. F1.\nM30\n", "G84", "write it out in G0"},
         {"fanuc", "O1\nG63\nM30\n", "G84", "write it out in G0"},
         {"fanuc", "O1\nG31 Z-5. F100.\nM30\n", "does not stop at the contact", "write it out in G0"},
         {"okuma", "G31 Z-5 F100\nM2\n", "does not stop at the contact", "write it out in G0"}});
}

TEST_CASE("H of a SINUMERIK is a function that goes to the PLC") {
  check({{"siemens", "H1\nM30\n", "hands to its PLC", "add the code that it belongs to"},
         {"siemens", "G54\nG0 X5 H20\nM30\n", "hands to its PLC", "add the code that it belongs to"},
         {"siemens", "H5=1\nM30\n", "hands to its PLC", "spindle"},
         {"siemens", "H5=1\nM30\n", "no H word", "spindle"},
         {"linuxcnc", "G0 X5 H2\nM2\n", "no code of this block uses", "PLC"}});
}

TEST_CASE("the way out is one that can be gone") {
  check({{"linuxcnc", "G1 X#<_hal[motion.pin]> F100\nM2\n", "a pin of its HAL", "set it in the program"},
         {"linuxcnc", "G0 X#<_ini[axis_x]max_limit>\nM2\n", "an entry of its INI file", "set it in the program"},
         {"linuxcnc", "#1=[#<_HAL[p]>+1]\nM2\n", "write the value itself", "set it in the program"},
         {"linuxcnc", "G0 X#<_here>\nM2\n", "set it in the program", "HAL"},
         {"fanuc", "O1\n#3001=0\nM30\n", "leave it out", "G10"},
         {"fanuc", "O1\n#3011=1\nM30\n", "leave it out", "G10"},
         {"fanuc", "O1\n#200=3.\nM30\n", "choose another number", "G10"},
         {"fanuc", "O1\n#499=3.\nM30\n", "choose another number", "G10"},
         {"fanuc", "O1\n#5241=3.\nM30\n", "G10", "leave it out"},
         {"fanuc", "O1\nM98 P1000 Q200\nM30\n", "a subprogram of its own", "remove it"},
         {"linuxcnc", "M98 P1000 Q200\nM2\n", "a subprogram of its own", "remove it"},
         {"fanuc", "O1\nM98 P1000 R200\nM30\n", "no code of this block uses", "a subprogram of its own"},
         {"fanuc", "O1\nN10/X5.\nM30\n", "before the N", "expected a word"},
         {"linuxcnc", "G0 X1 /Y5\nM2\n", "begins the line", "expected a word"},
         {"siemens", "N10 /G0 X5\nM30\n", "begins the line", "expected a word"},
         {"siemens", "DEF REAL\nM30\n", "the block ends where something is missing | expected a name", "0x00"},
         {"siemens", "DEF REAL AB,\nM30\n", "expected a name", "0x00"},
         {"siemens", "EXTERN\nM30\n", "expected a name", "0x00"},
         {"siemens", "CUTMOD=1\nM30\n", "function of the control", "DEF REAL"},
         {"siemens", "G1 X5 F100 OFFN=3\nM30\n", "function of the control", "DEF REAL"},
         {"siemens", "OFFN=R1\nM30\n", "function of the control", "DEF REAL"},
         {"siemens", "ABC=3\nM30\n", "declare it: DEF REAL ABC", ""},
         {"siemens", "A1: G0 X5\nM30\n", "begin with two letters", "expected a word"},
         {"siemens", "N10 X1:\nM30\n", "begin with two letters", "expected a word"}});
}

TEST_CASE("a refusal names what is missing, too large or of another control") {
  check({{"linuxcnc", "IF [#1 EQ 1] GOTO 10\nM2\n", "--dialect fanuc", "no function that is known"},
         {"linuxcnc", "N5 WHILE [#1 LT 3] DO 1\nM2\n", "o1 if", "no function that is known"},
         {"linuxcnc", "GOTO 10\nM2\n", "O words", "no function that is known"},
         {"linuxcnc", "#99999999999=1\nM2\n", "too large", "no whole number"},
         {"linuxcnc", "#1.5=1\nM2\n", "no whole number", "too large"},
         {"linuxcnc", "o99999999999 call\nM2\n", "too large", "no whole number"},
         {"fanuc", "O1\nGOTO 99999999999\nM30\n", "too large", "no whole number"},
         {"linuxcnc", "G21 G90\nG1 X[1+[2*3] Y2 F100\nM2\n", "a ] is missing before it", ""},
         {"okuma", "S=100*LA\nM2\n", "LA was never set", "a value of *"},
         {"okuma", "S=LA*100\nM2\n", "LA was never set", "a value of *"},
         {"okuma", "S=SIN[LB]\nM2\n", "LB was never set", "a value of"}});
}

TEST_CASE("what has no other form is left out, and a slip is called by its name") {
  check({{"fanuc", "O1\nG62\nM30\n", "write G64 or G61", "write it out"},
         {"fanuc", "O1\nG27 X0 Y0\nM30\n", "write G28", "write it out"},
         {"fanuc", "O1\nG54.2 P1\nM30\n", "choose a work system", "write it out"},
         {"fanuc", "O1\nM96 P2\nM30\n", "leave it out", "--pass"},
         {"fanuc", "O1\nG54 G94 G1 X1. F0\nM30\n", "F0 is no feed", "G93, G94 and G95"},
         {"linuxcnc", "M68 Q1\nM2\n", "M68", "M67"},
         {"okuma", "G15 H1\nG94 G1 X1 F0.\nM2\n", "F0. is no feed", ""},
         {"siemens", "G54 G94\nG1 X1 F=0\nM30\n", "F=0 is no feed", ""},
         {"fanuc", "O1\nGOTON10\nN10 M30\n", "without the N", "no function"},
         {"fanuc", "O1\nIF [1 EQ 1] GOTO N10\nN10 M30\n", "as in GOTO 10", "no function"},
         {"fanuc", "O1\nN10 G40 G17 G90 G70\nM30\n", "G20 (inch) and G21 (mm)", "another dialect"},
         {"fanuc", "O1\nG94 G90 G71\nM30\n", "G20 (inch) and G21 (mm)", "another dialect"},
         {"fanuc", "O1\nG199\nM30\n", "another dialect", "G20"}});
}
