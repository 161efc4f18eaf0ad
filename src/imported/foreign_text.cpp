#include "imported/foreign_text.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "base/diagnostic.hpp"

namespace plumbline::imported {
namespace {

constexpr std::string_view kMark8 = "\xEF\xBB\xBF";
constexpr std::string_view kMark16Little = "\xFF\xFE";
constexpr std::string_view kMark16Big = "\xFE\xFF";

unsigned byte(std::string_view text, std::size_t i) { return static_cast<unsigned char>(text[i]); }

void append(std::string& text, unsigned code) {
  const auto put = [&](unsigned value) { text += static_cast<char>(value); };
  if (code < 0x80) {
    put(code);
  } else if (code < 0x800) {
    put(0xC0 | code >> 6);
    put(0x80 | (code & 0x3F));
  } else if (code < 0x10000) {
    put(0xE0 | code >> 12);
    put(0x80 | (code >> 6 & 0x3F));
    put(0x80 | (code & 0x3F));
  } else {
    put(0xF0 | code >> 18);
    put(0x80 | (code >> 12 & 0x3F));
    put(0x80 | (code >> 6 & 0x3F));
    put(0x80 | (code & 0x3F));
  }
}

// Where UTF-8 is not valid; npos: nowhere.
std::size_t flaw_in_utf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const unsigned first = byte(text, i);
    const std::size_t length = first < 0x80                    ? 1
                               : first >= 0xC2 && first < 0xE0 ? 2
                               : first >= 0xE0 && first < 0xF0 ? 3
                               : first >= 0xF0 && first < 0xF5 ? 4
                                                               : 0;
    if (length == 0 || i + length > text.size()) return i;
    for (std::size_t k = 1; k < length; ++k) {
      if ((byte(text, i + k) & 0xC0) != 0x80) return i;
    }
    i += length;
  }
  return std::string_view::npos;
}

[[noreturn]] void refuse_at(const std::string& file, std::string_view before, const std::string& encoding) {
  Place place;
  place.file = file;
  place.line = 1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
  const std::size_t line = before.rfind('\n');
  place.column = line == std::string_view::npos ? before.size() + 1 : before.size() - line;
  refuse("import-encoding", fmt::format("this is no text in {}", encoding),
         "say encoding = \"auto\", \"utf-8\", \"utf-16le\", \"utf-16be\" or \"latin-1\" under [table] of the map; is "
         "the file "
         "text at all?",
         place);
}

std::string from_utf16(const std::string& file, std::string_view bytes, bool big, const std::string& encoding) {
  std::string text;
  const auto unit = [&](std::size_t i) {
    return big ? byte(bytes, i) << 8 | byte(bytes, i + 1) : byte(bytes, i + 1) << 8 | byte(bytes, i);
  };
  if (bytes.size() % 2 != 0) refuse_at(file, text, encoding);
  for (std::size_t i = 0; i < bytes.size(); i += 2) {
    unsigned code = unit(i);
    if (code >= 0xDC00 && code < 0xE000) refuse_at(file, text, encoding);
    if (code >= 0xD800 && code < 0xDC00) {
      if (i + 3 >= bytes.size() || unit(i + 2) < 0xDC00 || unit(i + 2) >= 0xE000) refuse_at(file, text, encoding);
      code = 0x10000 + ((code - 0xD800) << 10) + (unit(i + 2) - 0xDC00);
      i += 2;
    }
    append(text, code);
  }
  return text;
}

std::string from_latin1(std::string_view bytes) {
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); ++i) append(text, byte(bytes, i));
  return text;
}

std::string guessed(std::string_view bytes) {
  if (bytes.starts_with(kMark8)) return "utf-8";
  if (bytes.starts_with(kMark16Little)) return "utf-16le";
  if (bytes.starts_with(kMark16Big)) return "utf-16be";
  const std::string_view start = bytes.substr(0, 1000);
  std::size_t even = 0;
  std::size_t odd = 0;
  for (std::size_t i = 0; i < start.size(); ++i) {
    if (start[i] == '\0') ++(i % 2 == 0 ? even : odd);
  }
  if (3 * odd > start.size()) return "utf-16le";
  if (3 * even > start.size()) return "utf-16be";
  return flaw_in_utf8(bytes) == std::string_view::npos ? "utf-8" : "latin-1";
}

}  // namespace

Decoded decoded(const std::string& file, std::string_view bytes, const std::string& encoding) {
  Decoded result{{}, encoding == "auto" ? guessed(bytes) : encoding};
  for (const std::string_view mark : {kMark8, kMark16Little, kMark16Big}) {
    if (bytes.starts_with(mark) && (result.encoding == "utf-8") == (mark == kMark8) && result.encoding != "latin-1") {
      bytes.remove_prefix(mark.size());
      break;
    }
  }
  if (result.encoding == "latin-1") {
    result.text = from_latin1(bytes);
  } else if (result.encoding == "utf-8") {
    const std::size_t flaw = flaw_in_utf8(bytes);
    if (flaw != std::string_view::npos) refuse_at(file, bytes.substr(0, flaw), result.encoding);
    result.text = bytes;
  } else {
    result.text = from_utf16(file, bytes, result.encoding == "utf-16be", result.encoding);
  }
  if (const std::size_t nil = result.text.find('\0'); nil != std::string::npos) {
    refuse_at(file, std::string_view(result.text).substr(0, nil), result.encoding);
  }
  return result;
}

}  // namespace plumbline::imported
