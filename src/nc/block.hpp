// One block of a program, parsed: its words and where in the text they stand. Reused from block to block, so that
// reading a program allocates nothing.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace plumbline::nc {

/// Bytes [begin, end) of a block's text.
struct Span {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
};

inline constexpr std::uint32_t kLiteral = 0xFFFFFFFF;  // a Word whose value is a plain number

/// A letter and its value, as in or Y[#1+2].
struct Word {
  char letter = 0;                      // upper case
  double value = 0;                     // literals: at once; expressions: after the interpreter evaluated them
  std::uint32_t expression = kLiteral;  // where its code begins in Block::code
  Span span;                            // letter and value
  std::uint8_t decimals = 0;            // digits after the point, as written; 0 for an expression
};

struct Comment {
  Span span;  // with its delimiters
};

/// What a line is when it is not a block of words.
enum class LineKind : std::uint8_t {
  block,    // words, comments, or nothing
  percent,  // % at the begin or the end of the program
  ignored,  // text behind the end of the program
};

struct Block {
  std::string_view text;      // the line without its end
  std::string_view line_end;  // "\n", "\r\n" or "" (last line)
  std::size_t line = 0;       // counts from 1
  std::uint64_t offset = 0;   // of its first byte in the file
  LineKind kind = LineKind::block;
  bool block_delete = false;  // begins with /
  Span slash;                 // where that stands
  std::vector<Word> words;    // in the order of the text, N left out
  Span number;                // the N word; begin == end: none
  std::vector<Comment> comments;

  std::string_view at(Span span) const { return text.substr(span.begin, span.end - span.begin); }
  bool has_number() const { return number.end > number.begin; }
};

}  // namespace plumbline::nc
