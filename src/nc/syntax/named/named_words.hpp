// Words, settings and codes of languages with names: X=LENGTH, R1=5, TRAORI(1).
#pragma once

#include <string_view>

#include "nc/syntax/reading/block_reading.hpp"

namespace plumbline::nc {

/// The value of the word that `letter` at `span` begins; its = has been read.
void read_assigned_word(BlockReading& in, char letter, Span span, WordUse use = WordUse::of_letter);

/// CR=5; X1=0, whose axis is the machine's.
void read_address(BlockReading& in, const NameMeaning& meaning, Span span);

/// setting = variable , [ "[" , value , "]" ] , "=" , value. The name has been read, and means `meaning` (or null).
void read_assigned_variable(BlockReading& in, Span name, const NameMeaning* meaning);

/// token() is the type of a variable that is declared. Refuses types that are not interpreted; `what` is in plural what
/// has the type.
VariableType variable_type(const BlockReading& in, std::string_view what);

/// Refuses the name of a variable that is a word of the control [H p. 2-14].
void check_name_is_free(const BlockReading& in, Span name);

/// A code that is a name, of this row of Dialect::named_codes, with what stands in brackets after it.
void read_named_code(BlockReading& in, Span span, int row);

}  // namespace plumbline::nc
