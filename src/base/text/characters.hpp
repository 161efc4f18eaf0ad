// Letters, digits and blanks of ASCII, whatever the locale says; the byte order mark.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace plumbline {

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// A to Z and a to z.
constexpr bool is_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }

/// What names of variables and labels consist of.
constexpr bool is_of_name(char c) { return is_letter(c) || is_digit(c) || c == '_'; }

/// What may stand between the words of a line; a carriage return belongs to the line's end.
constexpr bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

constexpr char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

constexpr char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

/// Bytes at the begin of a file's text that are its byte order mark: 3 or 0.
constexpr std::size_t byte_order_mark_size(std::string_view text) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  return text.starts_with(kMark) ? kMark.size() : 0;
}

/// Where a carriage return stands between two parts of a line, as the line ends of old Mac texts do; npos: nowhere.
/// Those before a line feed and at the end of `text` are line ends.
constexpr std::size_t lone_carriage_return(std::string_view text) {
  for (std::size_t at = text.find('\r'); at != std::string_view::npos; at = text.find('\r', at + 1)) {
    const std::size_t next = text.find_first_not_of(" \t\r", at);
    if (next != std::string_view::npos && text[next] != '\n') return at;
  }
  return std::string_view::npos;
}
inline constexpr std::string_view kLoneCarriageReturn =
    "a carriage return stands alone, as the line ends of old Mac texts do: where a line ends is not certain";
inline constexpr std::string_view kOtherLineEnds =
    "save the file with the line ends of Unix (LF) or Windows (CR LF), and look at the lines there";

/// \p text without its blanks.
inline std::string without_blanks(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (!is_blank(c)) out += c;
  }
  return out;
}

/// \p text in capital letters.
inline std::string upper(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = upper(c);
  return out;
}

}  // namespace plumbline
