// Which candidate is taken, on paths of many moves, is in align_test.cpp, diff_test.cpp and diff_drawn_test.cpp.
#include "jobs/diff/candidates.hpp"

#include <catch2/catch.hpp>

#include "jobs/diff/read_moves.hpp"
#include "nc/rewrite/output/emit_settings.hpp"

using namespace plumbline;
using jobs::Candidate;
using jobs::Standing;

namespace {

// What the move of A after the first rapid may have become, both at the zero with the same shift.
std::vector<Candidate> after_the_rapid(std::string_view a, std::string_view b) {
  testing::ReadMoves first("G21 G90 G94\nG0 Z5\n" + std::string(a));
  testing::ReadMoves second("G21 G90 G94\nG0 Z5\n" + std::string(b));
  return jobs::Candidates(first.queue(), second.queue(), nc::EmitSettings{}.time_tolerance)
      .of(1, 1, {{{0, 0, 5, 0, 0, 0}}, {}, true});
}

}  // namespace

TEST_CASE("a move may be as many pieces as end where it ends, in its time") {
  const std::vector<Candidate> found = after_the_rapid("G1 X10 F600\nG1 X20\n", "G1 X4 F600\nX7\nX10\nG1 X20\n");
  REQUIRE(found.size() == 1);
  CHECK(found[0].count == 3);
  CHECK(found[0].cost == Approx(0).margin(1e-9));
  CHECK(found[0].in_time);
}

TEST_CASE("a next move that states its code in one program alone speaks against a candidate") {
  const auto cost = [](const char* next_of_a, const char* next_of_b) {
    return after_the_rapid(std::string("G1 X10 F600\n") + next_of_a, std::string("G1 X10 F600\n") + next_of_b)
        .at(0)
        .cost;
  };
  CHECK(cost("G1 X20\n", "G1 X20\n") == Approx(0).margin(1e-9));
  CHECK(cost("X20\n", "X20\n") == Approx(0).margin(1e-9));
  CHECK(cost("G1 X20\n", "X20\n") == Approx(2));
  CHECK(cost("X20\n", "G1 X20\n") == Approx(0.5));
}

TEST_CASE("where both have numbers these decide, whatever time it takes") {
  const std::vector<Candidate> found =
      after_the_rapid("N10 G1 X10 F600\nN20 G1 X20\n", "N10 G1 X4 F60\nX7\nX10\nN20 G1 X20\n");
  REQUIRE(found.size() == 1);
  CHECK(found[0].count == 3);
  CHECK(after_the_rapid("N10 G1 X10 F600\nN20 G1 X20\n", "N15 G1 X10 F600\nN20 G1 X20\n").empty());
}

TEST_CASE("a move that ends elsewhere, or of another kind, is none") {
  CHECK(after_the_rapid("G1 X10 F600\n", "G1 X10 Y50 F600\n").empty());
  CHECK(after_the_rapid("G0 X10\n", "G1 X10 F600\n").empty());
  CHECK(after_the_rapid("G1 X10 F600\n", "G0 X10\n").empty());
  CHECK(after_the_rapid("G1 X10 F600\n", "").empty());
}

TEST_CASE("a move shorter than rounding may have no counterpart, at a cost") {
  // 0.5, its length of 0.001 in 0.0005, and as far from where B stands in units of 0.03
  const std::vector<Candidate> found = after_the_rapid("G1 X0.001 F600\nG1 X20\n", "G1 X20 F600\n");
  REQUIRE_FALSE(found.empty());
  CHECK(found[0].count == 0);
  CHECK(found[0].cost == Approx(0.5 + 2 + 0.001 / 0.03));
  CHECK(after_the_rapid("G1 X0.01 F600\nG1 X20\n", "G1 X20 F600\n").empty());
}

TEST_CASE("a shift may change with the length of a move and with itself, and be anything before the first match") {
  jobs::DiffMove move;
  move.length = 20;
  CHECK(jobs::Candidates::slack(move, {{}, {}, false}) == Approx(0.1 + 2 + 10));
  CHECK(jobs::Candidates::slack(move, {{}, {}, true}) == Approx(0.1 + 2));
  CHECK(jobs::Candidates::slack(move, {{}, {{0, 3, 0, 0, 0, 0}}, true}) == Approx(0.1 + 2 + 1.5));
}

TEST_CASE("numbers differ only where both have one") {
  jobs::DiffMove a;
  jobs::DiffMove b;
  a.number = "N10";
  CHECK_FALSE(jobs::numbers_differ(a, b));
  b.number = "N10";
  CHECK_FALSE(jobs::numbers_differ(a, b));
  b.number = "N20";
  CHECK(jobs::numbers_differ(a, b));
}
