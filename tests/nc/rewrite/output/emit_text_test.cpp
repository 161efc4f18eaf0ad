#include "nc/rewrite/output/emit_text.hpp"

#include <string>

#include <catch2/catch.hpp>

#include "nc/syntax/parsed.hpp"
#include "support/scratch.hpp"

using namespace plumbline;
using namespace plumbline::nc;
using nc::tests::Parsed;

namespace {

// An editor on a block of one line.
struct Edited {
  explicit Edited(const std::string& line, std::string_view dialect_name = "linuxcnc") : parsed(line, dialect_name) {
    editor.start(parsed.block, spelling_of(parsed.block, {}));
  }
  Span span(char letter) const { return find_word(parsed.block, letter)->span; }
  std::string text() {
    std::string out;
    editor.apply(out);
    return out;
  }
  Parsed parsed;
  BlockEditor editor;
};

std::string word_text(double value, int decimals, const Spelling& spelling, std::string out = "") {
  append_word(out, 'X', value, decimals, spelling);
  return out;
}

}  // namespace

TEST_CASE("a block shows its case and its spacing, one with a single word its case alone") {
  const Spelling like{true, true, true, 8};
  const Spelling two = spelling_of(Parsed("G1X2").block, like);
  CHECK_FALSE(two.lower_case);
  CHECK_FALSE(two.spaced);
  CHECK(two.point);
  CHECK(two.most_digits == 8);
  CHECK(spelling_of(Parsed("g1 x2").block, {}).lower_case);
  CHECK(spelling_of(Parsed("g1 x2").block, {}).spaced);
  CHECK_FALSE(spelling_of(Parsed("X2").block, like).lower_case);
  CHECK(spelling_of(Parsed("X2").block, like).spaced);
  CHECK(spelling_of(Parsed("(note)").block, like).lower_case);
}

TEST_CASE("what is not edited comes out byte for byte") {
  const std::string line = "N7  g1\tX1.500Y2(c) ; d";
  Edited edited(line);
  CHECK(edited.text() == line);
  edited.editor.replace(edited.span('X'), "X3");
  CHECK(edited.text() == "N7  g1\tX3Y2(c) ; d");
}

TEST_CASE("words are put before, after and in place of others; one that goes takes its blanks along") {
  Edited edited("N7 G1  X1 Y2 (c)");
  edited.editor.insert_after(edited.span('Y').end, "Z3");
  edited.editor.replace(edited.span('Y'), "Y2.5");
  edited.editor.insert_before(edited.span('Y').begin, "F9");
  edited.editor.replace(edited.span('X'), "");
  CHECK(edited.text() == "N7 G1 F9 Y2.5 Z3 (c)");
  Edited tight("g1x1");
  tight.editor.insert_before(tight.span('X').begin, "G93");
  tight.editor.insert_after(tight.span('X').end, "Y2");
  tight.editor.insert_after(tight.span('X').end, "Z3");
  CHECK(tight.text() == "g1g93x1y2z3");
  Edited all("G1 X1");
  all.editor.replace(all.span('G'), "");
  all.editor.replace(all.span('X'), "");
  CHECK(all.text().empty());
}

TEST_CASE("a block of several lines becomes one where it changes, and stays as it is where not") {
  const std::string line = "G1 X1 \n$  Y2";
  Edited edited(line, "okuma");
  CHECK(edited.text() == line);
  edited.editor.replace(edited.span('X'), "X3");
  CHECK(edited.text() == "G1 X3 Y2");
}

TEST_CASE("numbers have a point and as many digits as the control takes") {
  CHECK(word_text(1.5, 9, {}) == "X1.5");
  CHECK(word_text(1.23456, 3, {}) == "X1.235");
  CHECK(word_text(2, 3, {.point = true}) == "X2.");
  CHECK(word_text(2.5, 3, {.point = true}) == "X2.5");
  CHECK(word_text(12345.678912, 9, {.most_digits = 8}) == "X12345.679");
  CHECK(word_text(0.123456789, 9, {.most_digits = 8}) == "X0.1234568");
  CHECK(word_text(1234567.123456789, 9, {}) == "X1234567.12345679");
  CHECK(word_text(-1, 3, {.lower_case = true, .spaced = true}, "G1") == "G1 x-1");
  CHECK(word_text(-1, 3, {.spaced = true}, "G1 ") == "G1 X-1");
  CHECK(word_text(-1, 3, {.spaced = true}) == "X-1");
}

TEST_CASE("a code is spelt like the block") {
  std::string out;
  append_code(out, "G1", {.lower_case = true, .spaced = true});
  append_code(out, "M8", {.lower_case = true, .spaced = true});
  CHECK(out == "g1 m8");
  append_code(out, "M9", {});
  CHECK(out == "g1 m8M9");
  CHECK(in_spelling("G43.1", {.lower_case = true}) == "g43.1");
}

TEST_CASE("a block is refused as a whole") {
  const Parsed parsed("N7 G1 X1");
  const Diagnostic refused = testing::refusal_of([&] { refuse_block(parsed.block, "emit-modes", "why", "way out"); });
  CHECK(refused.code == "emit-modes");
  CHECK(refused.place.line == 7);
  CHECK(refused.place.column == 1);
  CHECK(refused.place.length == 8);
}
