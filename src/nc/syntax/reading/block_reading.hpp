// One line on its way from text to block: what the grammars of all languages read from and add to.
#pragma once

#include <cstdint>

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
  int brackets = 0;  // that are open
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

/// What a value is. In macro B a condition is neither 1 nor 0 [cnccode.com on macro expressions], and which number one
/// of an OSP counts as was found in no source; elsewhere each is the other, and nothing is refused.
enum class ValueKind : std::uint8_t { number, condition };

/// Refuses a condition that stands where a number is needed.
void need_number(const BlockReading& in, ValueKind kind, Span span);
/// Refuses a number that stands where a condition is needed.
void need_condition(const BlockReading& in, ValueKind kind, Span span);
/// What the operator at `span` makes of two values, both of them numbers, or both conditions that it joins; refuses
/// others.
ValueKind joined_kind(const BlockReading& in, Operation operation, Span span, ValueKind left, ValueKind right);

}  // namespace plumbline::nc
