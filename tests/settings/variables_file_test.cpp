#include "settings/variables_file.hpp"

#include <catch2/catch.hpp>

#include "support/scratch.hpp"

using namespace plumbline;

TEST_CASE("variables are read in both forms") {
  const testing::Scratch scratch;
  const auto variables =
      settings::read_variables(scratch.file("v", "#100 12.5\r\n101\t-3\n\n  ; a comment\n#5221 = 1e2 ; mm\n"));
  CHECK(variables == std::map<int, double>{{100, 12.5}, {101, -3}, {5221, 100}});
  CHECK(settings::read_variables(scratch.file("b", "\xEF\xBB\xBF#1 2\n")) == std::map<int, double>{{1, 2}});
  CHECK(settings::read_variables(scratch.file("r", "R0=2\nR12 -1.5\n")) == std::map<int, double>{{0, 2}, {12, -1.5}});
  CHECK(settings::read_variables(scratch.file("vc", "VC1=2\nVC12 -1.5\n")) ==
        std::map<int, double>{{1, 2}, {12, -1.5}});
}

TEST_CASE("lines that are none are refused at their place") {
  struct Case {
    const char* text;
    const char* code;
    std::size_t line, column;
  };
  const testing::Scratch scratch;
  for (const Case& c : {Case{"#1 2\n#100\n", "variables-line", 2, 1}, Case{"1 2 3\n", "variables-line", 1, 5},
                        Case{"1 2\r2 3\r", "variables-line", 1, 4}, Case{"1 2\n2 3 ; a\r3 4\n", "variables-line", 2, 8},
                        Case{"#x 2\n", "variables-number", 1, 2}, Case{"0 2\n", "variables-number", 1, 1},
                        Case{"R1000.5 2\n", "variables-number", 1, 2}, Case{"#R1 2\n", "variables-number", 1, 2},
                        Case{"5602 2\n", "variables-number", 1, 1}, Case{"1.5 2\n", "variables-number", 1, 1},
                        Case{"1 nan\n", "variables-value", 1, 3}, Case{"1 2\n#1 3\n", "variables-twice", 2, 2}}) {
    INFO(c.text);
    const Diagnostic d = testing::refusal_of([&] { settings::read_variables(scratch.file("v", c.text)); });
    CHECK(d.code == c.code);
    CHECK(d.place.line == c.line);
    CHECK(d.place.column == c.column);
    CHECK_FALSE(d.help.empty());
  }
}
