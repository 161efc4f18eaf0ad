#include "base/angle.hpp"

#include <catch2/catch.hpp>

using plumbline::kTurn;
using plumbline::within_turn;

TEST_CASE("an angle is brought within one turn from 0, from below as from above") {
  CHECK(within_turn(1) == 1);
  CHECK(within_turn(0) == 0);
  CHECK(within_turn(kTurn) == 0);
  CHECK(within_turn(kTurn + 1) == Approx(1));
  CHECK(within_turn(-1) == Approx(kTurn - 1));
  CHECK(within_turn(-3 * kTurn - 1) == Approx(kTurn - 1));
}
