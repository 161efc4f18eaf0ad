#include "nc/language/comment_line.hpp"

#include <catch2/catch.hpp>

using namespace plumbline::nc;

TEST_CASE("a comment is written in capitals where the control drops small letters") {
  CHECK(comment_line("made by plumbline", dialect("linuxcnc")) == "(made by plumbline)");
  CHECK(comment_line("made by plumbline", dialect("fanuc")) == "(MADE BY PLUMBLINE)");
  CHECK(comment_line("made by plumbline", dialect("siemens")) == "; made by plumbline");
}

TEST_CASE("a comment is no longer than its line may be") {
  Dialect narrow = dialect("linuxcnc");
  narrow.line_length = 6;
  CHECK(comment_room(narrow) == 4);
  CHECK(comment_line("abcdefgh", narrow) == "(abcd)");
  narrow.line_length = 1;
  CHECK(comment_line("abcdefgh", narrow) == "()");
}
