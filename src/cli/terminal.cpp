#include "cli/terminal.hpp"

#include <fmt/color.h>

#include "base/platform/platform.hpp"
#include "cli/messages.hpp"

namespace plumbline::cli {
namespace {

constexpr std::size_t kUsualColumns = 80;

int descriptor(Stream stream) { return stream == Stream::out ? platform::kStandardOutput : platform::kStandardError; }

bool wants_no_colour() { return !platform::environment("NO_COLOR").value_or("").empty(); }

fmt::text_style style_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::good:
      return fmt::emphasis::bold | fmt::fg(fmt::terminal_color::green);
    case Verdict::doubtful:
      return fmt::emphasis::bold | fmt::fg(fmt::terminal_color::yellow);
    case Verdict::bad:
      break;
  }
  return fmt::emphasis::bold | fmt::fg(fmt::terminal_color::red);
}

}  // namespace

bool is_terminal(Stream stream) { return platform::is_terminal(descriptor(stream)) && !says_json(); }

std::size_t columns(Stream stream) {
  const std::size_t told = platform::terminal_columns(descriptor(stream));
  return told == 0 ? kUsualColumns : told;
}

std::string coloured(std::string text, std::string_view part, Verdict verdict, Stream stream) {
  if (part.empty() || !is_terminal(stream) || wants_no_colour() || !platform::shows_colours(descriptor(stream)))
    return text;
  const std::size_t at = text.find(part);
  if (at == std::string::npos) return text;
  return text.replace(at, part.size(), fmt::format(style_of(verdict), "{}", part));
}

}  // namespace plumbline::cli
