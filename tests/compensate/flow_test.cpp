// Programs that loop, branch, call subprograms or drill in cycles: refused, never written as if each block stood alone.
#include <catch2/catch.hpp>

#include "compensate/play.hpp"

using namespace plumbline;

TEST_CASE("loops, branches, subprograms and cycles are refused at the line where they begin") {
  const std::string start = "G21 G90 G94\nG0 X0 Y0 Z0 A0 B0 C0\n";
  std::size_t line = 0;
  for (const std::string text :
       {"o1 repeat [2]\nG1 X5 F100\no1 endrepeat\n", "o1 if [1]\nG1 X5 F100\no1 endif\n", "o1 sub\no1 endsub\n",
        "o1 call\nM2\no1 sub\nG1 X5 F100\no1 endsub\n", "M98 P1\nM2\nO1\nG1 X5 F100\nM99\n", "M99\n"}) {
    INFO(text);
    CHECK(code_of(start + text, {}, &line) == "compensate-flow");
    CHECK(line == 3);
  }
  CHECK(code_of(start + "G1 @5 ^30 F100\n", {}, &line) == "compensate-polar");
  CHECK(line == 3);
  CHECK(code_of(start + "G81 X1 Y1 Z-3 R1 F100\n", {}, &line) == "compensate-cycle");
  CHECK(line == 3);
}

TEST_CASE("a program number alone steers nothing, and stands before the stamp") {
  const Result result = run("%\nO1234 (PART)\nG21 G90 G94\nG0 X9 Y0 Z0 A0 B0 C0\nG1 X5 F100\n%\n", {});
  CHECK(result.text.starts_with("%\nO1234 (PART)\n("));
}
