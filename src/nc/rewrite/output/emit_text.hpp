// Changes words of one block and leaves every other byte of it alone.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/text/number_text.hpp"
#include "nc/control/step.hpp"
#include "nc/language/block.hpp"

namespace plumbline::nc {

/// How the words of a block are spelt, so that new ones look like their neighbours.
struct Spelling {
  bool lower_case = false;
  bool spaced = false;
  bool point = false;   // numbers have a decimal point even where they are whole
  int most_digits = 0;  // of a number; 0: any
};
/// Of a block with one word, which shows no spacing: the spacing of `like`.
Spelling spelling_of(const Block& block, const Spelling& like);

/// Collects changes to a block's text, then applies them all. Reused from block to block.
class BlockEditor {
 public:
  void start(const Block& block, const Spelling& spelling);
  /// Puts `text` where the span stands. An empty text takes the blanks before it away too.
  void replace(Span span, std::string_view text);
  /// The same, its text appended to what this gives until the next call.
  std::string& replace(Span span);
  /// Adds a word before / after byte `at`, with the spelling of the block.
  void insert_before(std::uint32_t at, std::string_view word);
  void insert_after(std::uint32_t at, std::string_view word);
  const Spelling& spelling() const { return spelling_; }
  /// The block's text with all changes, appended to `out`.
  void apply(std::string& out);

 private:
  struct Edit {
    Span span;
    std::size_t begin;  // of its text in texts_, which ends where the next begins
    std::size_t end = 0;
  };
  static bool comes_before(const Edit& a, const Edit& b);
  template <class Take>
  void for_each_part(const Take& take) const;
  std::string& add(Span span);
  const Block* block_ = nullptr;
  Spelling spelling_;
  std::vector<Edit> edits_;  // as they were asked for
  std::string texts_;
};

/// Takes the / of a block away that is executed all the same; behind the name of its line a blank stays in its place.
void drop_slash(BlockEditor& editor, const Step& step);

/// A code as the block spells its own: "G1" or "g1".
void append_in_spelling(std::string& out, std::string_view code, const Spelling& spelling);
std::string in_spelling(std::string_view code, const Spelling& spelling);

/// A code, with a blank before it where the block has blanks and the line does not begin here.
void append_code(std::string& out, std::string_view code, const Spelling& spelling);

/// A word: letter in the case asked for, then the number with at most that many decimals.
void append_word(std::string& out, char letter, double value, int decimals, const Spelling& spelling);
/// The same without a blank before it, to where there is room for kWordRoom; returns its end.
char* write_word(char* out, char letter, double value, int decimals, const Spelling& spelling);
/// So many of these decimals fit a number of at most that many digits (0: any).
int decimals_within(int most_digits, double value, int decimals);
inline constexpr std::size_t kWordRoom = kDecimalRoom + 2;

/// Refuses a block as a whole.
[[noreturn]] void refuse_block(const Block& block, std::string_view code, std::string message, std::string help);

}  // namespace plumbline::nc
