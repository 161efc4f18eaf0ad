// Text of one line -> Block. grammar/block.ebnf holds the productions.
#pragma once

#include "nc/language/block.hpp"
#include "nc/language/dialect.hpp"
#include "nc/syntax/named/named_grammar.hpp"
#include "nc/syntax/reading/block_reading.hpp"

namespace plumbline::nc {

/// Reads block.text into the rest of the block. After the text there must be a line end or a NUL.
/// block.file, text, line_end, line and offset are the caller's.
class Parser {
 public:
  /// The dialect must outlive it.
  explicit Parser(const Dialect& dialect) : reading_(dialect) {}
  void parse(Block& block);

 private:
  BlockReading reading_;
  NamedGrammar named_;
};

}  // namespace plumbline::nc
