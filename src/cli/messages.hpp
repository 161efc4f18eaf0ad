// What is said on standard error, as text for people or as one JSON object a line (--diagnostics=json); and results on
// standard output. What names of files and other text from outside would do to a terminal is shown, not done.
#pragma once

#include <string_view>

#include "base/diagnostic.hpp"

namespace plumbline::cli {

/// For all that is said from now on.
void say_as_json(bool json);
bool says_json();

/// An error, a warning.
void say(const Diagnostic& diagnostic);
/// What was done: whole lines, of no severity but "note".
void say_note(std::string_view text);

/// Text on standard error, as it is in either form. Where it cannot be written nothing is lost but itself: the work
/// counts.
void put_message(std::string_view text);

/// A result, on standard output. Refuses with file-unwritable where it cannot be written.
void print_result(std::string_view result);

}  // namespace plumbline::cli
