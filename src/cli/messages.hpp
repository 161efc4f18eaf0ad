// What is said on standard error, as text for people or as one JSON object a line (--diagnostics=json); and results on
// standard output. What names of files and other text from outside would do to a terminal is shown, not done.
#pragma once

#include <string_view>

#include "base/diagnostic.hpp"
#include "cli/terminal.hpp"

namespace plumbline::cli {

/// For all that is said from now on.
void say_as_json(bool json);
bool says_json();

enum class Loudness {
  quiet,    // -q: errors, warnings and results
  usual,    // and what was done, and how far the work is
  verbose,  // -v: and its steps
};
/// For all that is said from now on.
void say_as_much_as(Loudness loudness);
Loudness loudness();

/// An error, a warning: on a terminal that word stands in its colour.
void say(const Diagnostic& diagnostic);
/// What was done: whole lines, of no severity but "note".
void say_note(std::string_view text);
/// A step of the work, for who asked for them: a line without its end.
void say_step(std::string_view text);

/// Text on standard error, as it is in either form. Where it cannot be written nothing is lost but itself: the work
/// counts.
void put_message(std::string_view text);

/// The words of a result that are its verdict.
struct Judgement {
  std::string_view words;  // their first place is meant; empty: none
  Verdict verdict = Verdict::good;
};

/// A result, on standard output, the words of its judgement in their colour on a terminal. Refuses with file-unwritable
/// where it cannot be written.
void print_result(std::string_view result, const Judgement& judgement = {});

}  // namespace plumbline::cli
