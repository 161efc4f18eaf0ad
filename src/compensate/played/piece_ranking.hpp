// Which pieces of a block promise to leave most of the path that the original asks for.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/pose.hpp"
#include "compensate/read_back/figures.hpp"

namespace plumbline::compensate {

/// Of what a piece leaves.
struct PieceGuess {
  enum Kind : std::uint8_t { smooth, corner, turn };
  double value = 0;
  Kind kind = smooth;
  std::size_t piece = 0;
  std::size_t last = 0;  // up to which it stands for its neighbours
};

/// The pieces of a block that promise most, by one figure: the tip's distance or the turn. What was found over what was
/// guessed is learnt for each kind, from block to block.
class PieceRanking {
 public:
  static constexpr std::size_t kGuesses = 48;  // of a block

  /// A new block begins.
  void clear() { count_ = 0; }
  void keep(const PieceGuess& guess, bool among_many);
  /// Those that were kept, the largest first.
  std::span<const PieceGuess> sorted();
  bool promises(const PieceGuess& guess) const;
  void learn(const PieceGuess& guess, double found_value);
  /// To find no more than this where that was guessed would teach nothing.
  double known(const PieceGuess& guess) const;

  Worst found;

 private:
  static constexpr std::size_t kKinds = 3;
  std::array<PieceGuess, kGuesses> guesses_{};
  std::size_t count_ = 0;
  std::array<double, kKinds> per_guess_{};      // what was found over what was guessed: the largest
  std::array<std::uint64_t, kKinds> played_{};  // pieces
};

/// Guesses what the pieces of a block leave, one after the other, by X Y Z or by A B C.
class ChordGuess {
 public:
  double next(const Vector3<double>& step, const Vector3<double>& off, double arc);

 private:
  Vector3<double> step_ = Vector3<double>::Zero(), second_ = Vector3<double>::Zero();
  Vector3<double> off_ = Vector3<double>::Zero();
  bool is_first_ = true;
};

}  // namespace plumbline::compensate
