#include "compensate/played/piece_ranking.hpp"

#include <vector>

#include <catch2/catch.hpp>

using namespace plumbline;
using compensate::ChordGuess;
using compensate::PieceGuess;
using compensate::PieceRanking;

namespace {

std::vector<double> values_of(PieceRanking& ranking) {
  std::vector<double> values;
  for (const PieceGuess& guess : ranking.sorted()) values.push_back(guess.value);
  return values;
}

}  // namespace

TEST_CASE("the pieces that promise most are kept, the largest first") {
  PieceRanking ranking;
  for (std::size_t i = 0; i < 60; ++i) {
    ranking.keep({static_cast<double>(i * 7 % 60), PieceGuess::turn, i, i}, false);
  }
  const std::vector<double> kept = values_of(ranking);
  REQUIRE(kept.size() == PieceRanking::kGuesses);
  for (std::size_t i = 0; i < kept.size(); ++i) CHECK(kept[i] == static_cast<double>(59 - i));
  ranking.clear();
  CHECK(values_of(ranking).empty());
}

TEST_CASE("among many, smooth neighbours stand for each other") {
  PieceRanking ranking;
  for (std::size_t i = 0; i < 5; ++i) ranking.keep({1.0 + static_cast<double>(i), PieceGuess::smooth, i, i}, true);
  ranking.keep({9, PieceGuess::corner, 5, 5}, true);
  ranking.keep({2, PieceGuess::smooth, 7, 7}, true);  // 6 lies between
  CHECK(values_of(ranking) == std::vector<double>{9, 5, 2});
}

TEST_CASE("what was found over what was guessed decides what promises more than the worst so far") {
  PieceRanking ranking;
  ranking.found.take(1, {3});
  const PieceGuess half{0.5, PieceGuess::turn, 0, 0};
  CHECK_FALSE(ranking.promises(half));
  CHECK(ranking.promises({0.7, PieceGuess::turn, 0, 0}));  // half as much again, as long as little is learnt
  for (int i = 0; i < 16; ++i) ranking.learn(half, 2);
  CHECK(ranking.promises(half));
  CHECK_FALSE(ranking.promises({0.5, PieceGuess::smooth, 0, 0}));  // another kind
}

TEST_CASE("less than the most that was found of a guess teaches nothing") {
  PieceRanking ranking;
  const PieceGuess guess{0.5, PieceGuess::corner, 0, 0};
  CHECK(ranking.known(guess) == 0);
  ranking.learn(guess, 1);
  CHECK(ranking.known(guess) == Approx(1));
  CHECK(ranking.known(guess) < 1);
  CHECK(ranking.known({0.25, PieceGuess::corner, 0, 0}) == Approx(0.5));
  CHECK(ranking.known({0.5, PieceGuess::turn, 0, 0}) == 0);  // another kind
  CHECK(ranking.known({0, PieceGuess::turn, 0, 0}) > 1e9);   // nothing was guessed of it
}

TEST_CASE("a chord is guessed to leave its curve by an eighth of the second difference") {
  ChordGuess guess;
  const Vector3<double> none(0, 0, 0);
  CHECK(guess.next({1, 0, 0}, none, 0) == 0);
  CHECK(guess.next({1, 0.08, 0}, none, 0) == Approx(0.01));
  CHECK(guess.next({1, 0.16, 0}, {0, 0, 0.5}, 0) == Approx(0.5));  // its end is off by more
  ChordGuess of_arc;
  CHECK(of_arc.next({1, 0, 0}, none, 0.4) == Approx(0.05));
}
