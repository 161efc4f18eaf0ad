#include "cli/terminal.hpp"

#include <cstdlib>

#include <fmt/color.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "cli/messages.hpp"

namespace plumbline::cli {
namespace {

constexpr std::size_t kUsualColumns = 80;

int descriptor(Stream stream) { return stream == Stream::out ? STDOUT_FILENO : STDERR_FILENO; }

bool wants_no_colour() {
  const char* const none = std::getenv("NO_COLOR");
  if (none != nullptr && *none != '\0') return true;
  const char* const terminal = std::getenv("TERM");
  return terminal == nullptr || std::string_view(terminal) == "dumb";
}

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

bool is_terminal(Stream stream) { return isatty(descriptor(stream)) == 1 && !says_json(); }

std::size_t columns(Stream stream) {
  winsize size{};
  if (ioctl(descriptor(stream), TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return kUsualColumns;
  return size.ws_col;
}

std::string coloured(std::string text, std::string_view part, Verdict verdict, Stream stream) {
  if (part.empty() || !is_terminal(stream) || wants_no_colour()) return text;
  const std::size_t at = text.find(part);
  if (at == std::string::npos) return text;
  return text.replace(at, part.size(), fmt::format(style_of(verdict), "{}", part));
}

}  // namespace plumbline::cli
