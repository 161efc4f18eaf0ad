// Subprograms in languages with names: how a program calls them, and what they begin with.
#pragma once

#include "nc/syntax/reading/block_reading.hpp"

namespace plumbline::nc {

/// Refuses GOTOC, GOTOS, and the keywords that call otherwise than by a name.
void refuse_unread_keyword(const BlockReading& in, Span keyword);

/// SUB(1,2) P3: the name, at `name`, has been read; it stands alone in its block. Reads the line to its end.
void read_call_by_name(BlockReading& in, Span name);

/// What stands after CALL: a program's name, how often, and values of variables. The flow of the block is begun.
void read_call_statement(BlockReading& in);

/// What stands after EXTCALL: a text with the name of a file.
void read_external_call(BlockReading& in);

/// What stands after PROC: the name of this subprogram and its parameters, which become
/// settings.
void read_subprogram_head(BlockReading& in);

/// passes = [ "P" , ( number | "=" , value ) ]: how often [A 1.13; D: P= as of other addresses].
void read_passes(BlockReading& in);

}  // namespace plumbline::nc
