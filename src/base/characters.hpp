// Letters, digits and blanks of ASCII, whatever the locale says.
#pragma once

#include <string>
#include <string_view>

namespace plumbline {

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// A to Z and a to z.
constexpr bool is_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }

/// What may stand between the words of a line; a carriage return belongs to the line's end.
constexpr bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

constexpr char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

constexpr char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

/// \p text in capital letters.
inline std::string upper(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = upper(c);
  return out;
}

}  // namespace plumbline
