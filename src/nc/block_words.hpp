// The words of a block by their letter.
#pragma once

#include <array>
#include <cstdint>

#include "base/axes.hpp"
#include "nc/block.hpp"

namespace plumbline::nc {

constexpr std::uint32_t letter_bit(char letter) { return std::uint32_t{1} << static_cast<unsigned>(letter - 'A'); }

class BlockWords {
 public:
  /// Forgets the words of the block before.
  void clear() { letters_ = 0; }
  /// G and M are not kept: there may be several.
  void add(const Word& word) {
    letters_ |= letter_bit(word.letter);
    words_[static_cast<std::size_t>(word.letter - 'A')] = &word;
  }
  bool has(char letter) const { return (letters_ & letter_bit(letter)) != 0; }
  const Word* find(char letter) const { return has(letter) ? words_[static_cast<std::size_t>(letter - 'A')] : nullptr; }
  const Word* find(Axis axis) const { return find(plumbline::letter(axis)); }
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
  std::array<const Word*, 26> words_{};
};

}  // namespace plumbline::nc
