#include "nc/sequence/nesting.hpp"

#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "nc/language/dialect.hpp"

using namespace plumbline::nc;

namespace {

Nesting nesting_of(const std::vector<std::string>& lines, bool left_out = false) {
  Nesting nesting;
  std::size_t number = 0;
  for (const std::string& line : lines) nesting.add(head_of(line, dialect("siemens")), {0, ++number}, left_out);
  nesting.close();
  return nesting;
}

}  // namespace

TEST_CASE("an end is that of what was begun last") {
  const Nesting nesting = nesting_of({"LOOP", "FOR R1=1 TO 2", "IF R1==1", "X1", "ELSE", "ENDIF", "ENDFOR", "ENDLOOP"});
  const NestedPart* const branch = nesting.part_at(3);
  REQUIRE(branch != nullptr);
  CHECK(branch->fault.empty());
  CHECK(branch->otherwise.line == 5);
  CHECK(branch->end.line == 6);
  CHECK(nesting.part_at(5) == branch);
  CHECK(nesting.part_at(4) == nullptr);
  CHECK(nesting.part_at(7)->begin.line == 2);
  CHECK(nesting.part_at(8)->begin.line == 1);
}

TEST_CASE("what crosses, has no begin or no end has a fault") {
  const Nesting crossing = nesting_of({"FOR R1=1 TO 2", "IF R1==1", "ENDFOR", "ENDIF"});
  CHECK(crossing.part_at(1)->is_open);
  CHECK(crossing.part_at(2)->fault.empty());
  CHECK_FALSE(crossing.part_at(3)->fault.empty());
  const Nesting archive = nesting_of({"%_N_A_MPF", "IF R1==1", "%_N_B_SPF", "ENDIF"});
  CHECK(archive.part_at(2)->is_open);
  CHECK_FALSE(archive.part_at(4)->fault.empty());
  CHECK_FALSE(nesting_of({"IF R1==1", "ELSE", "ELSE", "ENDIF"}).part_at(1)->fault.empty());
}

TEST_CASE("REPEAT with a label is no loop, and lines behind / may be left out") {
  CHECK(nesting_of({"REPEAT AA P=2"}).part_at(1) == nullptr);
  CHECK(nesting_of({"REPEAT ; AA", "UNTIL R1==1"}).part_at(2)->begin.line == 1);
  const Nesting nesting = nesting_of({"IF R1==1", "/ENDIF", "ENDIF"}, true);
  CHECK(nesting.part_at(1)->end.line == 3);
  CHECK(nesting.has_slash_between({0, 1}, {0, 3}, FlowWord::begin_if));
  CHECK_FALSE(nesting.has_slash_between({0, 2}, {0, 3}, FlowWord::begin_if));
  CHECK_FALSE(nesting.has_slash_between({0, 1}, {0, 3}, FlowWord::begin_for));
}

TEST_CASE("lines that hold one end of a loop or a branch alone cut it") {
  const Nesting nesting = nesting_of({"X1", "IF R1==1", "X2", "ELSE", "X3", "ENDIF", "X4"});
  for (const auto& [first, last] :
       {std::pair{1, 2}, std::pair{2, 5}, std::pair{3, 4}, std::pair{4, 4}, std::pair{6, 7}}) {
    INFO(first << " to " << last);
    CHECK(nesting.cut_by(static_cast<std::size_t>(first), static_cast<std::size_t>(last)) == nesting.part_at(2));
  }
  for (const auto& [first, last] :
       {std::pair{1, 7}, std::pair{2, 6}, std::pair{3, 3}, std::pair{5, 5}, std::pair{7, 7}}) {
    INFO(first << " to " << last);
    CHECK(nesting.cut_by(static_cast<std::size_t>(first), static_cast<std::size_t>(last)) == nullptr);
  }
}
