// Also o_word_loops.cpp, whose words it hands on. tests/nc/programs/flow_*.ngc hold more, beside what LinuxCNC makes of
// it.
#include "nc/sequence/o_word_flow.hpp"

#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "nc/programs.hpp"
#include "support/scratch.hpp"

using namespace plumbline;
using namespace plumbline::nc;
using namespace plumbline::nc::tests;

namespace {

// The X of the moves.
std::vector<double> visited_by_o_words(const std::string& text) {
  std::vector<double> all;
  for (const Motion& motion : motions_of("G90\n" + text + "M2\n")) all.push_back(motion.to[Axis::X]);
  return all;
}

using Visited = std::vector<double>;

}  // namespace

TEST_CASE("a BREAK is forgotten at the end of a DO loop alone, as LinuxCNC does it") {
  const std::string thrice = "#1=0\nO2 DO\n#1=[#1+1]\nG0 X#1\nO2 WHILE [#1 LT 3]\n";
  CHECK(visited_by_o_words(thrice) == Visited{1, 2, 3});
  CHECK(visited_by_o_words("O1 WHILE [1]\nO1 BREAK\nO1 ENDWHILE\n" + thrice) == Visited{1});
  CHECK(visited_by_o_words("O1 DO\nO1 BREAK\nO1 WHILE [1]\n" + thrice) == Visited{1, 2, 3});
}

TEST_CASE("a REPEAT that was executed begins anew") {
  CHECK(
      visited_by_o_words("#2=0\n#3=0\nO1 REPEAT [2]\nO2 REPEAT [2]\n#2=[#2+1]\nG0 X#2\nO2 ENDREPEAT\nO1 ENDREPEAT\n") ==
      Visited{1, 2, 3, 4});
  CHECK(visited_by_o_words("O1 REPEAT [0]\nG0 X1\nO1 ENDREPEAT\nG0 X2\n") == Visited{2});
}

TEST_CASE("a REPEAT rounds halves to even, as LinuxCNC does it") {
  const auto passes = [](const std::string& count) {
    return visited_by_o_words("O1 REPEAT [" + count + "]\nG0 X1\nO1 ENDREPEAT\n").size();
  };
  CHECK(passes("0.5") == 0);
  CHECK(passes("1.5") == 2);
  CHECK(passes("2.5") == 2);
  CHECK(passes("3.5") == 4);
  CHECK(passes("4.5") == 4);
  CHECK(passes("2.51") == 3);
  CHECK(passes("-0.5") == 0);
}

TEST_CASE("what stands behind an ELSEIF is evaluated though a branch before it was executed, as LinuxCNC does it") {
  const std::string taken = "O1 IF [1]\nG0 X1\nO1 ELSEIF [";
  const std::string rest = "]\nG0 X2\nO1 ENDIF\n";
  CHECK(code_of(taken + "1/0" + rest) == "nc-arithmetic");
  CHECK(code_of(taken + "SQRT[-1]" + rest) == "nc-arithmetic");
  CHECK(code_of(taken + "#<nope> GT 1" + rest) == "nc-parameter-unset");
  CHECK(code_of(taken + "1]\nG0 X3\nO1 ELSEIF [1/0" + rest) == "nc-arithmetic");
  CHECK(code_of("O1 IF [0]\nO1 ELSEIF [1]\nO1 ELSEIF [1/0" + rest) == "nc-arithmetic");
  CHECK(visited_by_o_words(taken + "1" + rest) == Visited{1});
  CHECK(visited_by_o_words("O2 IF [0]\n" + taken + "1/0" + rest + "O2 ENDIF\nG0 X3\n") == Visited{3});
  CHECK(visited_by_o_words("O3 WHILE [1]\nO1 IF [1]\nG0 X1\nO3 BREAK\nO1 ELSEIF [1/0" + rest + "O3 ENDWHILE\n") ==
        Visited{1});
  CHECK(code_of("M66 P0 L0\n" + taken + "#5399" + rest, at_zero()).empty());
}

TEST_CASE("no subprogram is defined inside another") {
  const std::string inner = "O2 SUB\nG0 X2\nO2 ENDSUB\n";
  CHECK(code_of("O1 SUB\n" + inner + "O1 ENDSUB\nO1 CALL\nM2\n") == "nc-flow-label");
  CHECK(code_of("O1 SUB\nG0 X1\n" + inner + "O1 ENDSUB\nM2\n") == "nc-flow-label");
  CHECK(code_of("O1 SUB\nO3 IF [0]\n" + inner + "O3 ENDIF\nO1 ENDSUB\nM2\n") == "nc-flow-label");
  CHECK(code_of("O1 SUB\nO1 SUB\nO1 ENDSUB\nM2\n") == "nc-flow-label");
  CHECK(code_of("O1 SUB\nO2\nG0 X2\nO1 ENDSUB\nM2\n") == "nc-flow-label");
  CHECK(code_of("O1 SUB\nG0 X1\n(O2 SUB)\nO1 ENDSUB\nO1 CALL\nM2\n").empty());
  CHECK(visited_by_o_words("O1 CALL\nM2\nO1 SUB\nG0 X1\n" + inner + "G0 X3\nO1 ENDSUB\n") == Visited{1, 2});
}

TEST_CASE("of the branches of an IF one is executed") {
  for (const int value : {1, 2, 3}) {
    CHECK(visited_by_o_words("#1=" + std::to_string(value) +
                             "\nO1 IF [#1 EQ 1]\nG0 X1\nO1 ELSEIF [#1 EQ 2]\nG0 X2\nO1 ELSE\nG0 X3\nO1 ENDIF\n") ==
          Visited{static_cast<double>(value)});
  }
}

TEST_CASE("SUB is called by O CALL, a number by M98") {
  CHECK(visited_by_o_words("O1 SUB\nG0 X#1\nO1 ENDSUB\nO1 CALL [4]\nO1 CALL [5]\n") == Visited{4, 5});
  CHECK(visited_by_o_words("M98 P7 L2\nG0 X9\nM2\nO7\nG0 X1\nM99\n") == Visited{1, 1, 9});
  CHECK(code_of("M98 P7\nM2\nO7 SUB\nG0 X1\nO7 ENDSUB\n") == "nc-flow-label");
  CHECK(code_of("O7 CALL\nM2\nO7\nG0 X1\nM99\n") == "nc-flow-label");
  CHECK(code_of("O1 SUB\nO1 ENDSUB\nO1 SUB\nO1 ENDSUB\n") == "nc-flow-label");
  CHECK(code_of("O1 ENDWHILE\n") == "nc-flow-label");
}

TEST_CASE("a call with a folder opens the file there and looks for the name without it, as LinuxCNC does it") {
  const testing::Scratch scratch;
  std::filesystem::create_directories(scratch.path("subs/more"));
  scratch.file("subs/deep.ngc", "o<deep> sub\nG0 X1\no<deep> endsub\n");
  scratch.file("subs/more/other.ngc", "o<other> sub\nG0 X2\no<other> endsub\n");
  scratch.file("subs/named.ngc", "o<subs/named> sub\nG0 X3\no<subs/named> endsub\n");
  scratch.file("named.ngc", "o<named> sub\nG0 X4\no<named> endsub\n");
  const auto visited = [&](const std::string& text) {
    Visited all;
    for (const Motion& motion : motions_of_file(scratch.file("p.ngc", "G90\n" + text + "M2\n"), empty_tables())) {
      all.push_back(motion.to[Axis::X]);
    }
    return all;
  };
  const auto refused = [&](const std::string& text) {
    const auto refusal = refusal_of_file(scratch.file("p.ngc", "G90\n" + text + "M2\n"), empty_tables());
    return refusal ? refusal->code : "";
  };
  CHECK(visited("o<subs/deep> call\no<deep> call\n") == Visited{1, 1});
  CHECK(visited("o<SUBS/Deep> call\n") == Visited{1});
  CHECK(visited("o<./subs/deep> call\no<subs/more/other> call\n") == Visited{1, 2});
  CHECK(visited("o<deep> sub\nG0 X8\no<deep> endsub\no<subs/deep> call\n") == Visited{8});
  CHECK(visited("o<named> call\no<subs/named> call\n") == Visited{4, 4});
  CHECK(refused("o<subs/named> call\n") == "nc-flow-open");
  CHECK(refused("o<subs/none> call\n") == "nc-flow-open");
  CHECK(refused("o<subs/in> sub\nG0 X7\no<subs/in> endsub\no<subs/in> call\n") == "nc-flow-open");
  CHECK(refused("o<../subs/deep> call\nM2\no<deep> sub\nG0 X9\no<deep> endsub\n") == "nc-flow-open");
  CHECK(refused("o</tmp/deep> call\nM2\no<deep> sub\nG0 X9\no<deep> endsub\n") == "nc-flow-open");
}
