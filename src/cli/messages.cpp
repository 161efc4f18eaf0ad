#include "cli/messages.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>

#include <fmt/format.h>

#include "base/text/printable.hpp"
#include "report/diagnostic_json.hpp"

namespace plumbline::cli {
namespace {

bool as_json = false;  // set once, from the command line

}  // namespace

void say_as_json(bool json) { as_json = json; }
bool says_json() { return as_json; }

void put_message(std::string_view text) {
  const std::string shown = printable_lines(text);
  [[maybe_unused]] const std::size_t put = std::fwrite(shown.data(), 1, shown.size(), stderr);
}

void say(const Diagnostic& diagnostic) {
  put_message(as_json ? report::diagnostic_json(diagnostic) + "\n" : to_text(diagnostic));
}

void say_note(std::string_view text) {
  if (!as_json) {
    put_message(text);
    return;
  }
  while (text.ends_with('\n')) text.remove_suffix(1);
  Diagnostic note;
  note.message = text;
  note.severity = Severity::note;
  say(note);
}

void print_result(std::string_view result) {
  const std::string text = printable_lines(result);
  if (std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0) return;
  Place place;
  place.file = "<stdout>";
  refuse("file-unwritable", fmt::format("cannot be written: {}", std::strerror(errno)),
         "check where standard output goes, and that there is room", place);
}

}  // namespace plumbline::cli
