#include "base/text/printable.hpp"

#include <cstdint>

#include <fmt/format.h>

namespace plumbline {
namespace {

struct Character {
  std::uint32_t code = 0;
  std::size_t size = 1;
  bool is_utf8 = true;  // false: a byte that begins no character
};

Character character_at(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[at + i]); };
  const unsigned first = byte(0);
  if (first < 0x80) return {first, 1, true};
  const std::size_t size = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || at + size > text.size()) return {first, 1, false};
  std::uint32_t code = first & (0xFFU >> (size + 1));
  for (std::size_t i = 1; i < size; ++i) {
    if ((byte(i) & 0xC0U) != 0x80U) return {first, 1, false};
    code = code << 6U | (byte(i) & 0x3FU);
  }
  return {code, size, true};
}

// C0, DEL and C1; the marks that turn the direction of writing.
bool steers(const Character& c) {
  return !c.is_utf8 || c.code < 0x20 || (c.code >= 0x7F && c.code < 0xA0) || (c.code >= 0x202A && c.code <= 0x202E) ||
         (c.code >= 0x2066 && c.code <= 0x2069);
}

template <class Replace>
std::string without_steering(std::string_view text, const Replace& replace) {
  std::string out;
  for (std::size_t at = 0; at < text.size();) {
    const Character c = character_at(text, at);
    if (steers(c)) {
      replace(out, c);
    } else {
      out += text.substr(at, c.size);
    }
    at += c.size;
  }
  return out;
}

// JSON has the same escapes for characters from DEL on, and has escaped those below itself.
void escape(std::string& out, const Character& c) {
  out += !c.is_utf8 || c.code < 0x20 ? fmt::format("\\x{:02x}", c.code) : fmt::format("\\u{:04x}", c.code);
}

}  // namespace

std::string printable(std::string_view text) { return without_steering(text, escape); }

std::string printable_lines(std::string_view text) {
  return without_steering(text, [](std::string& out, const Character& c) {
    if (c.code == '\n' || c.code == '\t') {
      out += static_cast<char>(c.code);
    } else {
      escape(out, c);
    }
  });
}

std::string blanked(std::string_view text) {
  return without_steering(text, [](std::string& out, const Character& c) { out.append(c.size, ' '); });
}

}  // namespace plumbline
