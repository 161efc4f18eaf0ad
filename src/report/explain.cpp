#include "report/explain.hpp"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "base/diagnostic.hpp"
#include "base/text/nearest_name.hpp"

namespace plumbline::embedded {
extern const std::string_view diagnostics_md;
}

namespace plumbline::report {
namespace {

constexpr std::string_view kSection = "\n## ";
constexpr std::string_view kTitle = "\n# ";  // of the next file

std::string_view without_end_lines(std::string_view text) {
  while (text.starts_with('\n')) text.remove_prefix(1);
  while (text.ends_with('\n')) text.remove_suffix(1);
  return text;
}

std::vector<CodePage> read_pages() {
  std::vector<CodePage> pages;
  std::string_view rest = embedded::diagnostics_md;
  for (std::size_t at = rest.find(kSection); at != std::string_view::npos; at = rest.find(kSection)) {
    rest.remove_prefix(at + kSection.size());
    const std::size_t end = std::min({rest.find(kSection), rest.find(kTitle), rest.size()});
    const std::size_t line = std::min(rest.find('\n'), end);
    pages.push_back({rest.substr(0, line), without_end_lines(rest.substr(line, end - line))});
  }
  std::sort(pages.begin(), pages.end(), [](const CodePage& a, const CodePage& b) { return a.code < b.code; });
  return pages;
}

// [using.md](../using.md) -> docs/using.md
std::string without_links(std::string_view text) {
  constexpr std::string_view kLink = "](../";
  std::string out;
  for (std::size_t at = text.find(kLink); at != std::string_view::npos; at = text.find(kLink)) {
    const std::size_t open = text.rfind('[', at);
    const std::size_t close = text.find(')', at);
    if (open == std::string_view::npos || close == std::string_view::npos) break;
    out += text.substr(0, open);
    out += "docs/";
    out += text.substr(at + kLink.size(), close - at - kLink.size());
    text.remove_prefix(close + 1);
  }
  return out + std::string(text);
}

std::string first_sentence(std::string_view text) {
  std::string line(text.substr(0, text.find("\n\n")));
  std::replace(line.begin(), line.end(), '\n', ' ');
  const std::size_t end = std::min(line.find(". "), line.find(": "));
  if (end != std::string::npos) line.resize(end);
  if (line.ends_with('.')) line.pop_back();
  return line;
}

}  // namespace

std::span<const CodePage> code_pages() {
  static const std::vector<CodePage> pages = read_pages();
  return pages;
}

const CodePage* find_code_page(std::string_view code) {
  const auto pages = code_pages();
  const auto found = std::find_if(pages.begin(), pages.end(), [&](const CodePage& page) { return page.code == code; });
  return found == pages.end() ? nullptr : &*found;
}

std::string explain_text(std::string_view code) {
  if (code.starts_with('[') && code.ends_with(']')) code = code.substr(1, code.size() - 2);
  const CodePage* const page = find_code_page(code);
  if (page != nullptr) return fmt::format("{}\n\n{}\n", page->code, without_links(page->text));
  std::vector<std::string_view> codes;
  for (const CodePage& known : code_pages()) codes.push_back(known.code);
  const std::string_view nearest = nearest_name(code, codes);
  refuse("explain-unknown-code", fmt::format("there is no diagnostic {}", code),
         nearest.empty() ? "plumbline explain lists all of them" : fmt::format("did you mean {}?", nearest));
}

std::string explain_list() {
  std::size_t width = 0;
  for (const CodePage& page : code_pages()) width = std::max(width, page.code.size());
  std::string list;
  for (const CodePage& page : code_pages()) {
    list += fmt::format("{:{}}  {}\n", page.code, width, first_sentence(page.text));
  }
  return list;
}

}  // namespace plumbline::report
