#include "nc/language/guard_lines.hpp"

#include <string>

#include <catch2/catch.hpp>

#include "nc/language/comment_line.hpp"

using namespace plumbline::nc;

namespace {

bool is_part(std::string_view dialect_name, std::string_view line) {
  return is_part_of_guard(line, dialect(dialect_name));
}

}  // namespace

TEST_CASE("the lines around a guard are comments of the dialect, and no other line is one") {
  CHECK(comment_line(kGuardEnds, dialect("fanuc")) == "(GUARD: PASSED)");
  CHECK(comment_line(kGuardEnds, dialect("siemens")) == "; guard: passed");
  for (const char* const name : {"linuxcnc", "fanuc", "siemens"}) {
    INFO(name);
    const Dialect& own = dialect(name);
    CHECK(is_guard_line(comment_line(kGuardBegins, own), kGuardBegins, own));
    CHECK_FALSE(is_guard_line(comment_line(kGuardBegins, own), kGuardEnds, own));
    CHECK_FALSE(is_guard_line(comment_line(kGuardEnds, own) + " ", kGuardEnds, own));
    CHECK_FALSE(is_guard_line(std::string(" ").append(comment_line(kGuardEnds, own)), kGuardEnds, own));
    CHECK_FALSE(is_guard_line(kGuardEnds, kGuardEnds, own));
  }
  CHECK_FALSE(is_guard_line("(guard: passed)", kGuardEnds, dialect("siemens")));
  CHECK(is_guard_line("(guard: passed)", kGuardEnds, dialect("fanuc")));  // of a program that was made before
}

TEST_CASE("a guard of LinuxCNC measures, chooses offsets and ends: nothing of it moves") {
  for (const char* const line :
       {"#<plumbline_g54_x> = 1", "o<plumbline_guard> if [#<_x> GT 1]", "(MSG, plumbline guard: G54 is set otherwise)",
        "M2", "G49", "G43 H3", "G54", "G59.3"}) {
    INFO(line);
    CHECK(is_part("linuxcnc", line));
  }
  for (const char* const line :
       {"#<depth> = 1", "o<other> if [1]", "(MSG, other)", "M30", "G53", "G54 X1", "G5", "G0 X1", " M2", "m2"}) {
    INFO(line);
    CHECK_FALSE(is_part("linuxcnc", line));
  }
}

TEST_CASE("a guard of macro B is an alarm on a condition, to the end of its line") {
  const std::string alarm = "IF [#5221 NE 0] THEN #3000=101(PLUMBLINE: G54)";
  CHECK(is_part("fanuc", alarm));
  CHECK_FALSE(is_part("fanuc", alarm + " G0 X1."));
  CHECK_FALSE(is_part("fanuc", alarm + "(G54)"));
  CHECK_FALSE(is_part("fanuc", "IF [#5221 NE 0] THEN #3000=102(PLUMBLINE: G54)"));
  CHECK_FALSE(is_part("fanuc", "#3000=101(PLUMBLINE: G54)"));
  CHECK_FALSE(is_part("fanuc", "IF [#5221 NE 0] GOTO 10"));
  CHECK_FALSE(is_part("fanuc", "M2"));
}

TEST_CASE("a guard of a SINUMERIK asks for frames and stops; a control without one has no such line") {
  for (const char* const line : {"IF ABS($P_ACTFRAME[X,TR]-1)>0.001", "IF ABS($AA_IW[X]-1)>0.001",
                                 "MSG(\"plumbline guard: G54\")", "M0", "M30", "ENDIF", "G54", "G500", "G505"}) {
    INFO(line);
    CHECK(is_part("siemens", line));
    CHECK_FALSE(is_part("okuma", line));
  }
  for (const char* const line : {"IF R1==2", "MSG(\"other\")", "M2", "G53", "G0", "G1 X5", "G54 X1"}) {
    INFO(line);
    CHECK_FALSE(is_part("siemens", line));
  }
}
