#include "base/diagnostic.hpp"

#include <catch2/catch.hpp>

using namespace plumbline;

TEST_CASE("a place in a text knows its line and column") {
  const std::string text = "one\r\ntwo three\nfour";
  const Place place = place_in("f.txt", text, 9, 5);
  CHECK(place.line == 2);
  CHECK(place.column == 5);
  CHECK(place.text == "two three");
  CHECK(place_in("f.txt", text, 0).text == "one");
  CHECK(place_in("f.txt", text, 999).text == "four");
}

TEST_CASE("a diagnostic prints file, line, column, the text under a caret and the way out") {
  const Diagnostic d{"nc-x", "unknown word Q", "remove it", {"p.ngc", 12, 8, 2, "G1 X10 Q5"}, Severity::error};
  CHECK(to_text(d) ==
        "p.ngc:12:8: error: unknown word Q [nc-x]\n"
        "   12 | G1 X10 Q5\n"
        "      |        ^~\n"
        "help: remove it\n");
}

TEST_CASE("a diagnostic without a place still says what and the way out") {
  CHECK(to_text({"", "no model named", "add -m MODEL", {}, Severity::warning}) ==
        "warning: no model named\nhelp: add -m MODEL\n");
}

TEST_CASE("the caret stays below its column in a long line and under control characters") {
  std::string line(400, 'x');
  line[299] = 'Q';
  line[298] = '\t';
  const std::string text = to_text({"c", "m", "", {"f", 1, 300, 1, line}, Severity::error});
  const std::size_t shown = text.find('\n') + 1;
  const std::size_t caret = text.find('\n', shown) + 1;
  CHECK(text[shown + (text.find('^') - caret)] == 'Q');
  CHECK(text.find('\t') == std::string::npos);
}

TEST_CASE("the caret stands below its character after letters of several bytes, in any line") {
  const std::string line = "(M\xc3\xbcller, \xc3\xbc\xc3\xb6) Q\xc3\xa4 5";
  const std::size_t column = line.find('Q') + 1;
  CHECK(to_text({"c", "m", "", {"f", 1234567, column, 3, line}, Severity::error}) ==
        "f:1234567:" + std::to_string(column) + ": error: m [c]\n1234567 | " + line + "\n        | " +
            std::string(13, ' ') + "^~\n");
  std::string umlauts;
  for (int i = 0; i < 300; ++i) umlauts += "\xc3\xbc";
  const std::string text = to_text({"c", "m", "", {"f", 1, 301, 2, umlauts}, Severity::error});
  const std::size_t shown = text.find("| ") + 2;
  CHECK((text.find('\n', shown) - shown) % 2 == 0);  // no letter is cut
  CHECK(text.substr(shown, 2) == "\xc3\xbc");
}

TEST_CASE("a message cannot command the terminal") {
  CHECK(to_text({"", "no word \x1b[31m", "", {}, Severity::error}) == "error: no word \\x1b[31m\n");
}

TEST_CASE("a refusal carries its diagnostic") {
  try {
    refuse("code", "message", "help");
    FAIL("refuse came back");
  } catch (const Refusal& refusal) {
    CHECK(refusal.diagnostic().code == "code");
    CHECK(std::string(refusal.what()) == "message");
  }
}
