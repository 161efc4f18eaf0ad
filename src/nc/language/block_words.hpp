// The words of a block by their letter.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "base/axes.hpp"
#include "nc/language/block.hpp"

namespace plumbline::nc {

inline constexpr std::size_t kLetters = 32;  // A to Z, @ ^ $, and 1 2 3 for the point between of a circle (I1 J1 K1)
constexpr std::size_t letter_place(char letter) {
  if (letter >= 'A' && letter <= 'Z') return static_cast<std::size_t>(letter - 'A');
  if (letter == '$') return 31;
  return letter == '@' ? 26 : letter == '^' ? 27 : static_cast<std::size_t>(letter - '1') + 28;
}
inline constexpr std::array kCentreLetters{'I', 'J', 'K'};  // of X, Y, Z

constexpr std::uint32_t letter_bit(char letter) { return std::uint32_t{1} << letter_place(letter); }

class BlockWords {
 public:
  /// Forgets the words of the block before.
  void clear() { letters_ = 0; }
  /// Codes are not kept: there may be several.
  void add(const Word& word) {
    letters_ |= letter_bit(word.letter);
    words_[letter_place(word.letter)] = &word;
  }
  bool has(char letter) const { return (letters_ & letter_bit(letter)) != 0; }
  const Word* find(char letter) const { return has(letter) ? words_[letter_place(letter)] : nullptr; }
  const Word* find(Axis axis) const { return find(plumbline::letter(axis)); }
  /// @ radius and ^ angle in place of X and Y.
  bool polar() const { return has('@') || has('^'); }
  std::uint32_t letters() const { return letters_; }
  AxisSet axes() const {
    AxisSet axes;
    for (const Axis axis : kAllAxes) {
      if (has(plumbline::letter(axis))) axes.insert(axis);
    }
    return axes;
  }

 private:
  std::uint32_t letters_ = 0;
  std::array<const Word*, kLetters> words_{};
};

}  // namespace plumbline::nc
