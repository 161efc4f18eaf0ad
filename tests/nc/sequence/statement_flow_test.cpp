// Also statement_loops.cpp, whose loops it hands on, and program_ends.cpp.
#include "nc/sequence/statement_flow.hpp"

#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "base/diagnostic.hpp"
#include "nc/programs.hpp"
#include "support/scratch.hpp"

using namespace plumbline;
using namespace plumbline::nc;
using namespace plumbline::nc::tests;

namespace {

std::vector<double> visited_by_statements(const std::string& text, std::string_view dialect_name) {
  const ProgramFile program(text);
  const InputFile file(program.path());
  Program steps(file, dialect(dialect_name), empty_tables());
  std::vector<double> all;
  while (const Step* const step = steps.next()) {
    for (const Motion& motion : step->motions) all.push_back(motion.to[Axis::X]);
  }
  return all;
}

std::string refused_statement(const std::string& text, std::string_view dialect_name) {
  try {
    visited_by_statements(text, dialect_name);
  } catch (const Refusal& refusal) {
    return refusal.diagnostic().code;
  }
  return {};
}

using Positions = std::vector<double>;

}  // namespace

TEST_CASE("FOR counts from its begin whenever it is reached from above") {
  const std::string twice =
      "R2=0\nLOOP\nR2=R2+1\nFOR R1=1 TO 2\nG0 X=R1+R2*10\nENDFOR\nIF R2==2 GOTOF ENDE\nENDLOOP\nENDE: M30\n";
  CHECK(visited_by_statements(twice, "siemens") == Positions{11, 12, 21, 22});
  CHECK(visited_by_statements("FOR R1=3 TO 2\nG0 X1\nENDFOR\nG0 X2\nM30\n", "siemens") == Positions{2});
}

TEST_CASE("a jump out of a loop leaves it, and the end behind it is that of the loop around") {
  const auto both = [](const std::string& inner, const std::string& end) {
    return "R2=0 R3=0\nFOR R1=1 TO 2\n" + inner + "\nR3=R3+1\nIF R3==2 GOTOF OUT\nG0 X=R1\n" + end +
           "\nOUT: G0 X=R1*10\nENDFOR\nM30\n";
  };
  CHECK(visited_by_statements(both("FOR R2=1 TO 3", "ENDFOR"), "siemens") == Positions{1, 10, 2, 2, 2, 20});
  CHECK(visited_by_statements("R1=0\nWHILE R1<2\nR1=R1+1\nWHILE R1<9\nIF R1==2 GOTOF OUT\nG0 X=R1\nR1=R1+1\n"
                              "ENDWHILE\nOUT: G0 X=R1*10\nENDWHILE\nM30\n",
                              "siemens") == Positions{1, 20});
  CHECK(visited_by_statements("R1=0\nREPEAT\nREPEAT\nR1=R1+1\nIF R1>1 GOTOF OUT\nG0 X=R1\nUNTIL R1>5\n"
                              "OUT: G0 X=R1*10\nUNTIL R1>2\nG0 X5\nM30\n",
                              "siemens") == Positions{1, 20, 30, 5});
  CHECK(visited_by_statements("R1=0\nLOOP\nLOOP\nR1=R1+1\nIF R1>1 GOTOF OUT\nG0 X=R1\nENDLOOP\n"
                              "OUT: G0 X=R1*10\nIF R1>2 GOTOF AWAY\nENDLOOP\nAWAY: M30\n",
                              "siemens") == Positions{1, 20, 30});
}

TEST_CASE("a jump into a loop finds none begun, even if it was left by a jump before") {
  CHECK(refused_statement("R2=0\nFOR R1=1 TO 3\nBACK: G0 X=R1\nIF R2==0 GOTOF OUT\nENDFOR\nM30\n"
                          "OUT: R2=1\nGOTOB BACK\n",
                          "siemens") == "nc-flow-label");
  CHECK(refused_statement("O1\n#1=0\nWHILE [#1 LT 2] DO 1\n#1=#1+1\nGOTO 10\nEND 1\nWHILE [#1 LT 2] DO 1\n"
                          "N10 G0 X#1\n#1=#1+1\nEND 1\nM30\n",
                          "fanuc") == "nc-flow-label");
  CHECK(refused_statement("R1=0\nGOTOF IN\nLOOP\nIN: G0 X1\nENDLOOP\nM30\n", "siemens") == "nc-flow-label");
  CHECK(visited_by_statements("O1\n#1=0\nWHILE [#1 LT 2] DO 1\n#1=#1+1\n#2=0\nWHILE [#2 LT 3] DO 2\n#2=#2+1\n"
                              "IF [#2 EQ 2] GOTO 10\nG0 X#2\nEND 2\nN10 G0 X[#1*10]\nEND 1\nM30\n",
                              "fanuc") == Positions{1, 10, 1, 20});
}

TEST_CASE("a jump into a loop or a branch is refused, even if it never comes to the end") {
  const std::string loop = "WHILE [#1 LT 3] DO 1\n#1=#1+1\nN5 G0 X1.\nIF [#1 EQ 0] GOTO 9\nEND 1\nN9 M30\n";
  CHECK(refused_statement("O1\n#1=0\nGOTO 5\n" + loop, "fanuc") == "nc-flow-label");
  CHECK(refused_statement("O1\n#1=0\nM98 P2\n" + loop + "O2\nM99 P5\n", "fanuc") == "nc-flow-label");
  CHECK(refused_statement("O1\n#1=9\n" + loop.substr(0, loop.find("M30")) + "IF [#1 EQ 9] GOTO 5\nM30\n", "fanuc") ==
        "nc-flow-label");
  CHECK(refused_statement("O1\nDO 1\nDO 2\nN5 GOTO 9\nEND 2\nGOTO 5\nEND 1\nN9 GOTO 5\n", "fanuc") == "nc-flow-label");
  const std::string branch = "IF R1==1\nAHEAD: G0 X1\nELSE\nOTHER: G0 X2\nENDIF\n";
  CHECK(refused_statement("GOTOF AHEAD\n" + branch + "M30\n", "siemens") == "nc-flow-label");
  CHECK(refused_statement("GOTOF OTHER\n" + branch + "M30\n", "siemens") == "nc-flow-label");
  CHECK(refused_statement("R1=1\n" + branch + "GOTOB OTHER\nM30\n", "siemens") == "nc-flow-label");
  CHECK(refused_statement("R1=1\nIF R1==1\nGOTOF OTHER\nELSE\nOTHER: G0 X2\nENDIF\nM30\n", "siemens") ==
        "nc-flow-label");
  CHECK(refused_statement("R1=2\nIF R1==1\nAHEAD: G0 X2\nELSE\nR1=R1+1\nIF R1<5 GOTOB AHEAD\nENDIF\nM30\n",
                          "siemens") == "nc-flow-label");
}

TEST_CASE("a jump within a loop or a branch, out of it, or to its begin is read") {
  CHECK(visited_by_statements("O1\n#1=0\nGOTO 5\nN5 WHILE [#1 LT 4] DO 1\n#1=#1+1\nIF [#1 EQ 2] GOTO 8\n"
                              "IF [#1 EQ 3] GOTO 9\nG0 X#1\nN8 END 1\nN9 G0 X9.\nM30\n",
                              "fanuc") == Positions{1, 9});
  CHECK(visited_by_statements("O1\n#1=0\nWHILE [#1 LT 2] DO 1\n#1=#1+1\nM98 P2\nG0 X8.\nN5 G0 X#1\nEND 1\nM30\n"
                              "O2\nM99 P5\n",
                              "fanuc") == Positions{1, 2});
  CHECK(visited_by_statements("R1=1\nAGAIN:\nIF R1<3\nGOTOF PART\nG0 X9\nPART: G0 X=R1\nR1=R1+1\nGOTOB AGAIN\n"
                              "ENDIF\nM30\n",
                              "siemens") == Positions{1, 2});
}

TEST_CASE("a subprogram behind the second % is not there for the control, and the message says so") {
  const auto told = [](const std::string& text, std::string_view control) {
    const auto refused = refusal_of(text, empty_tables(), control);
    return refused ? refused->code + refused->message : std::string();
  };
  for (const std::string text :
       {"%\nO1\nM98 P2\nM30\n%\nO2\nG0 X5.\nM99\n%\n", "O1\nG65 P2 A1.\nM30\n%\n\nO0002\nM99\n",
        "%\nO1\nM98 P2\nM30\n%\n%\nO3\nM99\n:2\nM99\n%\n"}) {
    INFO(text);
    CHECK(told(text, "fanuc").find("behind the second %: the control stops reading there") != std::string::npos);
  }
  CHECK(told("%\nO1\nM98 P2\nM30\n%\nO3\nM99\n%\n", "fanuc").find("neither in this file nor beside it") !=
        std::string::npos);
  CHECK(told("%\nO1\nM98 P2\nM30\nO2\nM99\n%\n", "fanuc").empty());
}

TEST_CASE("an end behind a comment, or a loop without an end, is refused") {
  CHECK(refused_statement("O1\n#1=0\nWHILE [#1 LT 1] DO 1\n#1=#1+1\n(A) END 1\nM30\n", "fanuc") == "nc-flow-open");
  CHECK(refused_statement("O1\n#1=5\nWHILE [#1 LT 1] DO 1\nG0 X1.\n(A) END 1\nM30\n", "fanuc") == "nc-flow-open");
  CHECK(refused_statement("O1\n#1=0\nDO 1\nG0 X1.\nM30\n", "fanuc") == "nc-flow-open");
  CHECK(refused_statement("O1\n#1=1\nWHILE [#1 LT 1] DO #1\nG0 X1.\nEND 1\nM30\n", "fanuc") == "nc-flow-control");
}

TEST_CASE("loops of a subprogram are its own, and forgotten when it begins again") {
  CHECK(visited_by_statements("O1\n#1=0\nWHILE [#1 LT 2] DO 1\n#1=#1+1\nM98 P2 L2\nEND 1\nM30\n"
                              "O2\nWHILE [#1 LT 9] DO 1\nG0 X#1\nGOTO 5\nEND 1\nN5 M99\n",
                              "fanuc") == Positions{1, 1, 2, 2});
  CHECK(refused_statement("O1\nM98 P2\nM30\nO2\nG0 X1.\nEND 1\nM99\n", "fanuc") == "nc-flow-label");
}

TEST_CASE("what a condition leaves out ends at its own end") {
  const std::string branches = "IF R1>0\nIF R1>1\nG0 X1\nELSE\nG0 X2\nENDIF\nELSE\nG0 X3\nENDIF\nM30\n";
  CHECK(visited_by_statements("R1=2\n" + branches, "siemens") == Positions{1});
  CHECK(visited_by_statements("R1=1\n" + branches, "siemens") == Positions{2});
  CHECK(visited_by_statements("R1=0\n" + branches, "siemens") == Positions{3});
  CHECK(refused_statement("IF R1>0\nG0 X1\nM30\n", "siemens") == "nc-flow-open");
  CHECK(refused_statement("ENDLOOP\nM30\n", "siemens") == "nc-flow-label");
}

TEST_CASE("a program that runs into the next one of its file is refused, and so is a subprogram") {
  CHECK(refused_statement("O1\nG0 X1.\nO2\nG0 X2.\n", "fanuc") == "nc-flow-open");
  CHECK(visited_by_statements("O1\nG0 X1.\nM99\nO2\nG0 X2.\n", "fanuc") == Positions{1});
  CHECK(visited_by_statements("%\nO1\nG0 X1.\n%\nO2\nG0 X2.\n", "fanuc") == Positions{1});
  CHECK(refused_statement("O1\nM98 P2\nM30\nO2\nG0 X1.\nO3\nM99\n", "fanuc") == "nc-flow-open");
  CHECK(refused_statement("O1\nGOTO 5\nM30\n", "fanuc") == "nc-flow-label");
}

TEST_CASE("of an archive the main program is the first, and the only one that nothing calls") {
  const std::string sub = "%_N_SUB_SPF\nG0 X5\nM17\n";
  const std::string main = "%_N_MAIN_MPF\nG0 X1\nSUB\nM30\n";
  CHECK(refused_statement(sub + main, "siemens") == "nc-flow-open");
  CHECK(refused_statement("%_N_SUB_SPF\nG0 X5\n%_N_MAIN_MPF\nG0 X1\nM30\n", "siemens") == "nc-flow-open");
  CHECK(refused_statement("%_N_ONE_MPF\nG0 X1\nM30\n%_N_TWO_MPF\nG0 X2\nM30\n", "siemens") == "nc-flow-open");
  CHECK(refused_statement("%_N_ONE_MPF\nG0 X1\n" + sub + "%_N_two_mpf\nG0 X2\n", "siemens") == "nc-flow-open");
  CHECK(refused_statement(sub + "%_N_FURTHER_SPF\nG0 X6\nM17\n", "siemens") == "nc-flow-open");
  CHECK(refused_statement("G0 X1\nM30\n%_N_TWO_MPF\nG0 X2\nM30\n", "siemens") == "nc-flow-open");
  CHECK(visited_by_statements(main + sub, "siemens") == Positions{1, 5});
  CHECK(visited_by_statements("; of the CAM\n" + main + sub + "%_N_FURTHER_SPF\nG0 X6\nM17\n", "siemens") ==
        Positions{1, 5});
  CHECK(visited_by_statements("%_N_ONE_MPF\nG0 X1\nTWO\nM30\n%_N_TWO_MPF\nG0 X2\nM17\n", "siemens") == Positions{1, 2});
  CHECK(visited_by_statements(sub, "siemens") == Positions{5});
}

TEST_CASE("the file of a subprogram ends at its second %, and begins with its name") {
  const auto code = [](std::string_view name, std::string_view content, std::string_view control) {
    const testing::Scratch scratch;
    scratch.file(std::string(name), std::string(content));
    const bool fanuc = control == "fanuc";
    const auto refused =
        refusal_of_file(scratch.file(fanuc ? "main.nc" : "main.min", fanuc ? "O1\nM98 P100\nM30\n" : "CALL O100\nM2\n"),
                        empty_tables(), control);
    return refused ? refused->code : std::string();
  };
  for (const std::string_view percent : {"%\n", ""}) {
    INFO(percent);
    const std::string begin(percent);
    CHECK(code("O100.nc", begin + "O100\nG0 X7.\n%\nG0 X8.\nM99\n", "fanuc") == "nc-flow-open");
    CHECK(code("O100.nc", begin + "G0 X7.\n%\nG0 X8.\nM99\n", "fanuc") == "nc-flow-open");
    CHECK(code("O100.nc", begin + "G0 X3.\nO100\nG0 X7.\nM99\n", "fanuc") == "nc-flow-open");
    CHECK(code("O100.nc", begin + "(A) G0 X3. (B)\nO100\nG0 X7.\nM99\n", "fanuc") == "nc-flow-open");
    CHECK(code("O100.nc", begin + "(A) (B)\nO100\nG0 X7.\nM99\n%\n", "fanuc").empty());
    CHECK(code("O100.nc", begin + "G0 X7.\nM99\n%\n", "fanuc").empty());
    CHECK(code("O100.SUB", begin + "O100\nG0 X7\n%\nG0 X8\nRTS\n", "okuma") == "nc-flow-open");
    CHECK(code("O100.SUB", begin + "G0 X3\nO100\nG0 X7\nRTS\n", "okuma") == "nc-flow-open");
    CHECK(code("O100.SUB", begin + "O100\nG0 X7\nRTS\n%\n", "okuma").empty());
  }
  CHECK(code("O100.nc", "G0 X3.\n%\nO100\nG0 X7.\nM99\n%\n", "fanuc") == "nc-flow-open");
  CHECK(refused_statement("%\nO1\nM98 P2\nM30\nO2\nG0 X1.\n%\nG0 X2.\nM99\n", "fanuc") == "nc-flow-open");
}
