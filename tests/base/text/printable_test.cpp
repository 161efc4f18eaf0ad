#include "base/text/printable.hpp"

#include <catch2/catch.hpp>

#include "base/diagnostic.hpp"

using namespace plumbline;

TEST_CASE("what steers a terminal is shown, all else stays") {
  CHECK(printable("part 1.ngc") == "part 1.ngc");
  CHECK(printable("\x1b[31mred\x07") == "\\x1b[31mred\\x07");
  CHECK(printable("two\nlines\t\x7f") == "two\\x0alines\\x09\\u007f");
  CHECK(printable_lines("two\nlines\t\x1b") == "two\nlines\t\\x1b");
  CHECK(printable("Fr\xc3\xa4sen \xe2\x82\xac \xf0\x9f\x94\xa9") == "Fr\xc3\xa4sen \xe2\x82\xac \xf0\x9f\x94\xa9");
  CHECK(printable("\xc2\x9b"
                  "31m") == "\\u009b31m");                                   // CSI as one character
  CHECK(printable("\x9b \xff \xc3") == "\\x9b \\xff \\xc3");                 // bytes that are no UTF-8
  CHECK(printable(std::string("a\xe2\x80") + "\xae" + "b") == "a\\u202eb");  // from right to left
  CHECK(printable_lines("{\"id\": \"\\u001b\xc2\x9b\x7f\"}\n") == "{\"id\": \"\\u001b\\u009b\\u007f\"}\n");  // JSON
  CHECK(blanked("a\x1b\xc2\x9b\xff!") == "a    !");
}

TEST_CASE("messages show names and texts of files without what they would do to a terminal") {
  Diagnostic diagnostic{"code", "the table \x1b]0;x\x07 is missing", "look at \x1b[2J", {}, Severity::error};
  diagnostic.place.file = "a\x1b[1m\n.ngc";
  diagnostic.place.line = 1;
  diagnostic.place.column = 3;
  diagnostic.place.text = "G1\x1b[31m";
  CHECK(to_text(diagnostic) ==
        "a\\x1b[1m\\x0a.ngc:1:3: error: the table \\x1b]0;x\\x07 is missing [code]\n    1 | G1 [31m\n      |   ^\n"
        "help: look at \\x1b[2J\n");
}
