// Arcs that stay arcs under a bound: what the control makes of their written words keeps the deformed tip within it.
#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "compensate/bound/drawn_arcs.hpp"
#include "compensate/bound/held_bound.hpp"
#include "machine/machines.hpp"

using namespace plumbline;

TEST_CASE("drawn arcs stay arcs or become few, and keep the bound") {
  std::uint64_t stayed = 0;
  std::uint64_t split = 0;
  std::uint64_t blocks = 0;
  for (const double tolerance_um : {0.5, 2.0}) {
    for (unsigned seed = 1; seed <= 6; ++seed) {
      const std::string text = DrawnArcs(seed).text(8);
      Job job = job_within(tolerance_um, false);
      const HeldBound held = held_bound(text, job, kDense);
      INFO("seed " << seed << " at " << tolerance_um << " um: " << held.played.tip_um);
      check_held(held, text);
      CHECK(held.over == 0);
      const compensate::ArcFigures& arcs = held.result.summary.bound->arcs;
      CHECK(arcs.stayed + arcs.split == 8);
      stayed += arcs.stayed;
      split += arcs.split;
      blocks += arcs.blocks;
    }
  }
  INFO(stayed << " stayed, " << split << " became " << blocks);
  CHECK(stayed >= 30);
  CHECK(blocks <= 5 * split);
}

TEST_CASE("with friction arcs keep the bound but on the pieces that the summary counts") {
  for (unsigned seed = 21; seed <= 24; ++seed) {
    const std::string text = DrawnArcs(seed).text(6);
    INFO("seed " << seed);
    const HeldBound held = held_bound(text, job_within(0.5, true), kDense);
    check_held(held, text);
    CHECK(held.result.summary.bound->arcs.straight == 0);
  }
}
