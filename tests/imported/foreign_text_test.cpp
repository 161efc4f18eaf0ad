#include "imported/foreign_text.hpp"

#include <catch2/catch.hpp>

#include "support/scratch.hpp"

using namespace plumbline;
using namespace plumbline::testing;
using imported::decoded;

namespace {

std::string wide(std::string_view text, bool big) {
  std::string bytes;
  for (const char c : text) bytes += big ? std::string{'\0', c} : std::string{c, '\0'};
  return bytes;
}

}  // namespace

TEST_CASE("an encoding is found by its mark, by zeros, or by what is valid") {
  CHECK(decoded("f",
                "\xEF\xBB\xBF"
                "a\xC2\xB5",
                "auto")
            .text == "a\xC2\xB5");
  CHECK(decoded("f", "a\xC2\xB5", "auto").encoding == "utf-8");
  CHECK(decoded("f", "a\xB5", "auto").encoding == "latin-1");
  CHECK(decoded("f", "a\xB5", "auto").text == "a\xC2\xB5");
  CHECK(decoded("f", "\xFF\xFE" + wide("a;b", false), "auto").text == "a;b");
  CHECK(decoded("f", "\xFE\xFF" + wide("a;b", true), "auto").text == "a;b");
  CHECK(decoded("f", wide("no mark", false), "auto").text == "no mark");
  CHECK(decoded("f", wide("no mark", true), "auto").encoding == "utf-16be");
  // U+1D11E: a pair of surrogates, four bytes in UTF-8
  CHECK(decoded("f", std::string("\x34\xD8\x1E\xDD", 4), "utf-16le").text == "\xF0\x9D\x84\x9E");
}

TEST_CASE("bytes that an encoding does not have are refused where they stand") {
  const Diagnostic d = refusal_of([] { decoded("f", "a\nbc\xFF", "utf-8"); });
  CHECK(d.code == "import-encoding");
  CHECK(d.place.line == 2);
  CHECK(d.place.column == 3);
  CHECK(refusal_of([] { decoded("f", std::string("a\0b", 3), "utf-8"); }).code == "import-encoding");
  CHECK(refusal_of([] { decoded("f", "abc", "utf-16le"); }).code == "import-encoding");
  CHECK(refusal_of([] { decoded("f", std::string("\x34\xD8\x41\x00", 4), "utf-16le"); }).code == "import-encoding");
}
