// Values of languages with names: variables, functions and operators by their name.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "nc/syntax/reading/block_reading.hpp"

namespace plumbline::nc {

/// Whether the next token, where a word may stand, is of that kind.
bool item_follows(const BlockReading& in, TokenKind kind);

/// The operator that token() is, be it written as a sign or as a name; nothing if it is none.
std::optional<Operation> operator_at(const BlockReading& in);

/// The identifier that stands next, in capital letters; "" where something else does. Reading goes on after it.
std::string read_keyword(BlockReading& in);

/// Refuses where something else than `kind`, which messages call `what`, stands after a value.
void expect_after_value(BlockReading& in, TokenKind kind, std::string_view what);

/// Refuses where no = stands after the name.
void expect_equals(BlockReading& in, Span name);

/// The code of the value that stands next.
std::uint32_t read_named_value(BlockReading& in);
/// The same of a condition.
std::uint32_t read_named_condition(BlockReading& in);

/// The value that stands next, added to the code that is being written; `kind`, a bracket or a comma, ends it.
void add_named_value_until(BlockReading& in, TokenKind kind);

/// `name`, which stands at `span`, is one of those variables that have numbers: R1, R[2], VC3, VC[4].
bool is_numbered_variable(const BlockReading& in, std::string_view name);

/// Adds the number of the parameter that a numbered variable is kept as, [ ] after its name included.
void add_numbered_variable(BlockReading& in, Span span);

/// A variable of the control itself, whose names begin with Syntax::reserved.
bool is_reserved(const BlockReading& in, std::string_view name);
[[noreturn]] void refuse_reserved(const BlockReading& in, Span span);

}  // namespace plumbline::nc
