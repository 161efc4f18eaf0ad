// A TOML text as a tree that knows where in the text each key and value stands, so that a refusal can point at it and a
// new value can take its place.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.hpp"

namespace plumbline {

/// A piece of a text, in bytes.
struct TextSpan {
  std::size_t offset = 0;
  std::size_t length = 0;
};

struct TomlEntry;

struct TomlValue {
  enum class Kind { text, number, boolean, array, table, date };
  Kind kind = Kind::table;
  TextSpan span;                   // of the value; of a table its header
  std::string text;                // of a text
  double number = 0;               // of a number, integers too; may be NaN or infinite, which TOML can say
  bool flag = false;               // of a boolean
  std::vector<TomlValue> items;    // of an array
  std::vector<TomlEntry> entries;  // of a table, in the order of the text

  /// The entry of that key, or nothing.
  const TomlEntry* find(std::string_view key) const;
};

struct TomlEntry {
  std::string key;
  TextSpan key_span;
  TomlValue value;
};

struct TomlDocument {
  std::string file;
  std::string text;
  TomlValue root;
  std::vector<std::size_t> lines = {};  // where each begins in the text

  /// Where a piece of this text stands; what crosses a line's end is cut there.
  Place place(TextSpan span) const;
};

/// "text", "number" and so on, as messages name them.
std::string_view name_of(TomlValue::Kind kind);

/// Refuses with toml-syntax, at the byte that TOML does not allow, and with toml-too-deep.
TomlDocument parse_toml(std::string text, std::string file);

}  // namespace plumbline
