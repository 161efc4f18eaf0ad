#include "compensate/played/piece_ranking.hpp"

#include <algorithm>
#include <limits>

namespace plumbline::compensate {
namespace {

constexpr double kFirstRatio = 1.5;    // of what is found to what was guessed, as long as little was played
constexpr std::uint64_t kLearnt = 16;  // pieces of a kind
constexpr double kSafety = 1.3;        // on the largest such ratio that was met
constexpr double kLeastMm = 1e-9;
constexpr double kRounding = 1e-12;

}  // namespace

// What a piece leaves, of X Y Z or of A B C: a chord leaves its curve by an eighth of the second difference in its
// middle; what its ends are off by rounding is added there.
double ChordGuess::next(const Vector3<double>& step, const Vector3<double>& off, double arc) {
  const Vector3<double> second = is_first_ ? Vector3<double>(Vector3<double>::Zero()) : Vector3<double>(step - step_);
  Vector3<double> chord = second.squaredNorm() > second_.squaredNorm() ? second : second_;
  if (chord.norm() < arc) chord *= arc / std::max(chord.norm(), kLeastMm);
  const double middle = std::max(((off + off_) / 2 + chord / 8).norm(), arc / 8);
  const double left = std::max({middle, off.norm(), off_.norm()});
  step_ = step;
  second_ = second;
  off_ = off;
  is_first_ = false;
  return left;
}

// The largest guesses_; of neighbours among many, in none of which friction counts most, one alone.
void PieceRanking::keep(const PieceGuess& guess, bool among_many) {
  for (std::size_t k = 0; among_many && guess.kind == PieceGuess::smooth && k < count_; ++k) {
    PieceGuess& kept = guesses_[k];
    if (kept.last + 1 != guess.piece || kept.kind != PieceGuess::smooth) continue;
    if (guess.value > kept.value) kept = guess;
    kept.last = guess.piece;
    return;
  }
  if (count_ < kGuesses) {
    guesses_[count_++] = guess;
    return;
  }
  PieceGuess& least = *std::min_element(guesses_.begin(), guesses_.end(),
                                        [](const PieceGuess& a, const PieceGuess& b) { return a.value < b.value; });
  if (guess.value > least.value) least = guess;
}

std::span<const PieceGuess> PieceRanking::sorted() {
  std::sort(guesses_.begin(), guesses_.begin() + static_cast<std::ptrdiff_t>(count_),
            [](const PieceGuess& a, const PieceGuess& b) { return a.value > b.value; });
  return {guesses_.data(), count_};
}

bool PieceRanking::promises(const PieceGuess& guess) const {
  const double learnt = kSafety * per_guess_[guess.kind];
  const double ratio = played_[guess.kind] < kLearnt ? std::max(kFirstRatio, learnt) : learnt;
  return guess.value * ratio > found.value;
}

void PieceRanking::learn(const PieceGuess& guess, double found_value) {
  if (guess.value <= 0) return;
  ++played_[guess.kind];
  per_guess_[guess.kind] = std::max(per_guess_[guess.kind], found_value / guess.value);
}

double PieceRanking::known(const PieceGuess& guess) const {
  if (guess.value <= 0) return std::numeric_limits<double>::max();
  return (1 - kRounding) * per_guess_[guess.kind] * guess.value;
}

}  // namespace plumbline::compensate
