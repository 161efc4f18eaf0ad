#include "cli/messages.hpp"

#include <cstdio>
#include <string>

#include <fmt/format.h>

#include "jobs/diagnostic_json.hpp"

namespace plumbline::cli {
namespace {

bool as_json = false;  // set once, from the command line

}  // namespace

void say_as_json(bool json) { as_json = json; }
bool says_json() { return as_json; }

void say(const Diagnostic& diagnostic) {
  fmt::print(stderr, "{}", as_json ? jobs::diagnostic_json(diagnostic) + "\n" : to_text(diagnostic));
}

void say_note(std::string_view text) {
  if (!as_json) {
    fmt::print(stderr, "{}", text);
    return;
  }
  while (text.ends_with('\n')) text.remove_suffix(1);
  Diagnostic note;
  note.message = text;
  note.severity = Severity::note;
  say(note);
}

}  // namespace plumbline::cli
