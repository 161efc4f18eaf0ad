// Arcs of an output are held against the arcs that were meant.
#include <catch2/catch.hpp>

#include "compensate/bound/held_bound.hpp"
#include "compensate/read_back/meant.hpp"

using namespace plumbline;

namespace {

const std::string kArcs =
    "G21 G17 G90 G94\nG0 X0 Y0 Z0 A0 B0 C0\nN10 G2 X20 Y0 I10 J0 F600\nN20 X22 Y2 R2\nN30 G3 I-4 J0\nM2\n";

}  // namespace

TEST_CASE("faults in the words of an arc are found") {
  const Job job = job_within(5, false);
  const Meant meant = compensated(kArcs, job);
  CHECK(found(meant, job, 0, 0, "").empty());
  const auto finds = [&](const std::string& behind, const std::string& what, const std::string& by) {
    INFO(behind << ": " << what << " -> " << by << " in\n" << meant.output);
    CHECK_FALSE(found(meant, job, behind, what, by).empty());
  };
  REQUIRE(meant.output.find("N20 X") != std::string::npos);
  finds("C0\n", "G2", "G3");
  finds("C0\n", "G2", "G1");
  finds("C0\n", "G2", "G18 G2");
  finds("N20 X", " I", " I0.001 (was ");  // another centre, with the rest of its word in a comment
  finds("N30 ", "G3", "G3 P2");
  finds("N30 ", "G3", "G2");
  finds("N20 ", " J", " (J");
}

TEST_CASE("the centre of an arc counts to half of what its word keeps") {
  const Job job = job_within(5, false);
  const Meant meant = compensated("G21 G17 G90 G94\nG0 X0 Y0 Z0 A0 B0 C0\nG3 X2 Y2 I0 J2 F600\nM2\n", job);
  const std::size_t at = meant.output.find(" J");
  REQUIRE(at != std::string::npos);
  const std::size_t end = meant.output.find_first_of(" \n", at + 1);
  const double centre = std::stod(meant.output.substr(at + 2, end - at - 2));
  for (const double off : {-0.0002, 0.0002}) {
    CHECK_FALSE(found(meant, job, at, end - at, fmt::format(" J{:.4f}", centre + off)).empty());
  }
  CHECK(found(meant, job, at, end - at, fmt::format(" J{:.5f}", centre + 0.00001)).empty());
}
