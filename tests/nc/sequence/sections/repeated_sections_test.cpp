#include "nc/sequence/sections/repeated_sections.hpp"

#include <catch2/catch.hpp>

#include "base/diagnostic.hpp"

using namespace plumbline;
using namespace plumbline::nc;

namespace {

RepeatedSection lines_3_to_5() {
  RepeatedSection section;
  section.begin.line = 3;
  section.end = 6;
  section.back.line = 8;
  section.remaining = 2;
  section.level = 1;
  return section;
}

}  // namespace

TEST_CASE("a part is read again from its begin, then reading goes on after the line that repeats it") {
  RepeatedSections sections;
  const auto first = sections.begin({}, lines_3_to_5());
  CHECK(first.at.line == 3);
  CHECK(first.entry->pass == 2);
  CHECK_FALSE(sections.after(5, 1).has_value());
  CHECK_FALSE(sections.after(6, 2).has_value());  // of a subprogram that it calls
  const auto second = sections.after(6, 1);
  REQUIRE(second.has_value());
  CHECK(second->at.line == 3);
  CHECK(second->entry->pass == 3);
  const auto back = sections.after(6, 1);
  REQUIRE(back.has_value());
  CHECK(back->at.line == 8);
  CHECK_FALSE(back->entry.has_value());
  CHECK_FALSE(sections.after(6, 1).has_value());
}

TEST_CASE("a jump stays inside the part that is repeated, or leaves it with its call") {
  RepeatedSections sections;
  sections.begin({}, lines_3_to_5());
  const Block block;
  sections.check_jump(block, {0, 3}, 1);
  sections.check_jump(block, {0, 9}, 2);
  CHECK_THROWS_AS(sections.check_jump(block, {0, 6}, 1), Refusal);
  CHECK_THROWS_AS(sections.check_jump(block, {0, 2}, 1), Refusal);
  sections.leave(1);
  sections.check_jump(block, {0, 9}, 1);
}

TEST_CASE("the end of the file ends a part that stands there") {
  RepeatedSections sections;
  RepeatedSection section = lines_3_to_5();
  section.remaining = 1;
  sections.begin({}, section);
  CHECK_FALSE(sections.after(kEndOfFile, 2).has_value());
  const auto back = sections.after(kEndOfFile, 1);
  REQUIRE(back.has_value());
  CHECK(back->at.line == 8);
  CHECK_FALSE(sections.after(kEndOfFile, 1).has_value());
}
