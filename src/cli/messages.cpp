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
Loudness how_loud = Loudness::usual;

void put(const std::string& shown) {
  [[maybe_unused]] const std::size_t written = std::fwrite(shown.data(), 1, shown.size(), stderr);
}

}  // namespace

void say_as_json(bool json) { as_json = json; }
bool says_json() { return as_json; }

void say_as_much_as(Loudness loudness) { how_loud = loudness; }
Loudness loudness() { return how_loud; }

void put_message(std::string_view text) { put(printable_lines(text)); }

void say(const Diagnostic& diagnostic) {
  if (as_json) return put_message(report::diagnostic_json(diagnostic) + "\n");
  const std::string text = printable_lines(to_text(diagnostic));
  const bool is_error = diagnostic.severity == Severity::error;
  put(coloured(text, is_error ? "error:" : "warning:", is_error ? Verdict::bad : Verdict::doubtful, Stream::err));
}

void say_note(std::string_view text) {
  if (how_loud == Loudness::quiet) return;
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

void say_step(std::string_view text) {
  if (how_loud == Loudness::verbose) say_note(std::string(text) + "\n");
}

void print_result(std::string_view result, const Judgement& judgement) {
  const std::string text = coloured(printable_lines(result), judgement.words, judgement.verdict, Stream::out);
  if (std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0) return;
  Place place;
  place.file = "<stdout>";
  refuse("file-unwritable", fmt::format("cannot be written: {}", std::strerror(errno)),
         "check where standard output goes, and that there is room", place);
}

}  // namespace plumbline::cli
