// One line on its way from text to block: what the grammars of all languages read from and add to.
#pragma once

#include "nc/language/dialect.hpp"
#include "nc/syntax/reading/block_builder.hpp"
#include "nc/syntax/reading/token_cursor.hpp"

namespace plumbline::nc {

struct BlockReading {
  /// The dialect must outlive it.
  explicit BlockReading(const Dialect& dialect_)
      : dialect(&dialect_), syntax(&dialect_.syntax), cursor(*syntax), out(*syntax) {}

  const Dialect* dialect;
  const Syntax* syntax;
  TokenCursor cursor;
  BlockBuilder out;
};

/// token() is ( of a comment that may hold anything: it is added, and reading goes on after its ).
void pass_comment(BlockReading& in);

/// token() is %, with which a program begins or ends. Refuses what stands after it where the control does.
void read_percent(BlockReading& in);

/// Refuses whatever else stands on this line than comments.
void end_of_statement(BlockReading& in);

/// token() is a sign. Where nothing says that the control reads two signs in a row, they are a slip.
void refuse_second_sign(const BlockReading& in);

/// token() is the / of block skip.
void read_block_skip(BlockReading& in);

}  // namespace plumbline::nc
