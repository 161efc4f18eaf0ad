// One block of a program, parsed: its words and where in the text they stand. Reused from block to block, so that
// reading a program allocates nothing.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "base/axes.hpp"
#include "base/text/characters.hpp"

namespace plumbline::nc {

/// Bytes [begin, end) of a block's text.
struct Span {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
};

inline constexpr std::uint32_t kLiteral = 0xFFFFFFFF;  // a Word whose value is a plain number

inline constexpr char kNamedCode = '_';  // in place of a word's letter: a code that is written as a name, as in TRAORI

/// How the value of an axis word counts.
enum class WordMode : std::uint8_t {
  modal,        // as G90 or G91 says
  absolute,     // X=AC(5)
  incremental,  // X=IC(5)
  shortest,     // A=DC(5): the shorter way round
  positive,     // A=ACP(5)
  negative,     // A=ACN(5)
};

/// What a word stands for where its letter alone does not say it.
enum class WordUse : std::uint8_t {
  of_letter,
  tool_name,     // T="MILL10": the tool table says which number that is
  machine_axis,  // X1=0: of the machine's axis of this name, not of the work's X
  tool_vector,   // A3=0: I of the direction of the tool, not of an arc
  travel_end,    // Z=VPSLZ: where the travel of the axis ends, which only the machine knows; its value is 0
};

/// A letter and its value, as in or Y[#1+2]. Of a code written as a name the value is its row in
/// Dialect::named_codes.
struct Word {
  char letter = 0;                      // upper case
  double value = 0;                     // literals: at once; expressions: after the interpreter evaluated them
  std::uint32_t expression = kLiteral;  // where its code begins in Block::code
  Span span;                            // letter and value
  std::uint8_t decimals = 0;            // digits after the point, as written; 0 for an expression
  bool unknown = false;                 // an expression whose value only the machine knows (a probe result, an input)
  bool point = false;                   // a literal with a decimal point
  bool vacant = false;                  // an expression without a value
  WordMode mode = WordMode::modal;
  WordUse use = WordUse::of_letter;
  bool rounded = false;  // worked out of numbers with more digits than a control keeps
};

/// G, M or a code that is a name: several may stand in a block, and none of them is a value.
inline bool is_code(const Word& word) { return word.letter == 'G' || word.letter == 'M' || word.letter == kNamedCode; }

/// A value in the brackets of a code that is a name, as in CYCLE81(10,,2).
struct Argument {
  std::uint32_t expression = kLiteral;  // where its code begins in Block::code; kLiteral: left out, or a text
  double value = 0;                     // once the interpreter evaluated it
  bool plain = true;                    // a number, or nothing
  Span span;
};

struct Comment {
  Span span;  // with its delimiters
};

enum class Operation : std::uint8_t {
  end,
  number,         // pushes Instruction::number
  parameter,      // replaces the number on top by the value of the parameter that has this number
  name,           // pushes the value of the parameter names[Instruction::name]
  exists,         // pushes 1 if that parameter has a value, else 0
  exists_number,  // replaces the number on top by 1 if a parameter may have it, else by 0
  negate,
  absolute,
  arc_cosine,
  arc_sine,
  macro_arc_sine,  // of a negative number: refused
  arc_tangent,
  cosine,
  exponential,
  round_down,
  round_up,
  logarithm,
  round,
  sine,
  square_root,
  tangent,  // angles in degrees
  power,
  times,
  divide,
  modulo,
  plus,
  minus,
  equal,
  not_equal,
  greater,
  greater_equal,
  less,
  less_equal,
  logical_and,
  logical_or,
  exclusive_or,
  bit_and,  // of whole numbers, bit by bit
  bit_or,
  bit_exclusive_or,
  whole_quotient,    // DIV
  whole_remainder,   // of whole numbers alone
  remainder,         // with the sign of the dividend
  truncate,          // towards zero
  round_away,        // away from zero
  arc_tangent_turn,  // 0 to 360
  arc_tangent_of_one,
  smaller,  // of two numbers
  larger,
  square,
  logical_not,
  check_truths,  // refuses two values that are not 0 or 1
  vacant,        // pushes the value of a variable that was never set
  bracketed,     // a variable alone in brackets: what it is worth if it was never set is not known
};

constexpr bool is_relation(Operation operation) {
  return operation >= Operation::equal && operation <= Operation::less_equal;
}

/// One step of an expression's code, in postfix order; Operation::end closes it.
struct Instruction {
  Operation operation = Operation::end;
  std::uint32_t name = 0;
  double number = 0;
  Span span;  // of the operator or operand, for diagnostics
};

/// A parameter setting, #5 = 3 or #<depth> = [#5*2]; takes effect when the whole block has been read.
/// What a declared variable keeps of a value: all of it, the nearest whole number, or whether it is 0.
enum class VariableType : std::uint8_t { real, whole, truth };

struct Setting {
  std::uint32_t target = kLiteral;         // code of the parameter's number; kLiteral: a named parameter
  std::uint32_t name = 0;                  // of a named one, in Block::names
  std::uint32_t value = 0;                 // code of the value
  Span span;                               // of the parameter
  Span whole;                              // with its value
  VariableType type = VariableType::real;  // of one that is declared here
};

/// What an O word asks for.
enum class FlowWord : std::uint8_t {
  none,
  program,  // O100 alone: begins a program that M98 calls
  sub,
  end_sub,
  call,
  give_back,  // return
  begin_do,
  begin_while,
  end_while,
  repeat,
  end_repeat,
  leave,  // break
  go_on,  // continue
  begin_if,
  else_if,
  otherwise,  // else
  end_if,
  // Controls with jumps
  go_to,    // with a condition in Flow::values: if it holds
  if_then,  // Block::settings if the condition holds
  begin_for,
  end_for,
  begin_loop,
  end_loop,
  begin_repeat,
  until,
  choose,          // CASE
  repeat_section,  // REPEAT LABEL P=3
  repeat_line,     // REPEATB LABEL P=3
  external_call,   // EXTCALL
  define,          // DEF: the settings of the block declare variables
};

/// Where a jump looks for its label.
enum class Direction : std::uint8_t { both, forward, backward };

/// Where CASE goes on for one value; a label of a part that is repeated.
struct Choice {
  std::uint32_t value = kLiteral;  // code of the value; kLiteral: for all others
  Span label;
  Direction direction = Direction::both;
};

/// What steers the program: the O word of a line, or its IF, GOTO, CALL..., and what stands after it.
struct Flow {
  FlowWord word = FlowWord::none;
  Span span;                          // O, label and keyword
  Span name;                          // of a named label, without < and >
  std::uint32_t label = kLiteral;     // code of a numbered one
  std::vector<std::uint32_t> values;  // code of a condition, a count, a value to return, or of the arguments
  Direction direction = Direction::both;
  std::vector<Choice> choices;
  std::uint32_t count = kLiteral;  // code of how often a subprogram is called
};

/// What a line is when it is not a block of words.
enum class LineKind : std::uint8_t {
  block,    // words, comments, or nothing
  percent,  // % at the begin or the end of the program
  ignored,  // text after the end of the program
};

struct Block {
  std::string_view file;      // name of the program, for diagnostics
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
  std::vector<Setting> settings;
  std::vector<Instruction> code;    // of all expressions of the block, one after the other
  Flow flow;                        // of a line that steers
  std::vector<Argument> arguments;  // of the one code that has such
  std::vector<Span> left_out;       // words whose value is that of a vacant variable
  std::vector<Span> names;          // of named parameters, without # < and >

  /// Leaves where it stands in the file, and nothing that its text says.
  void clear() {
    kind = LineKind::block;
    block_delete = false;
    slash = number = Span{};
    words.clear();
    comments.clear();
    settings.clear();
    code.clear();
    if (flow.word != FlowWord::none) flow = Flow{};  // plain lines leave it as it is
    arguments.clear();
    left_out.clear();
    names.clear();
  }
  std::string_view at(Span span) const { return text.substr(span.begin, span.end - span.begin); }
  bool has_number() const { return number.end > number.begin; }
};

/// Bytes at the begin of the block that are the file's byte order mark: 3 or 0.
inline std::size_t byte_order_mark_size(const Block& block) {
  return block.offset == 0 ? plumbline::byte_order_mark_size(block.text) : 0;
}

/// The first word of that letter (upper case); null if there is none.
inline const Word* find_word(const Block& block, char letter) {
  for (const Word& word : block.words) {
    if (word.letter == letter) return &word;
  }
  return nullptr;
}

/// The first word of each axis; null where there is none.
inline std::array<const Word*, kAxes> axis_words(const Block& block) {
  std::array<const Word*, kAxes> words{};
  for (const Word& word : block.words) {
    const std::size_t axis = kAxisOfLetter[static_cast<unsigned char>(word.letter)];
    if (axis < kAxes && words[axis] == nullptr) words[axis] = &word;
  }
  return words;
}

}  // namespace plumbline::nc
