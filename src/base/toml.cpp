#include "base/toml.hpp"

#include <algorithm>
#include <optional>

#define TOML_HEADER_ONLY 1
#include <toml++/toml.h>

#include "base/characters.hpp"

namespace plumbline {
namespace {

// Behind the text that begins with the quote at `at`; one of a single line ends with its line at the latest.
std::size_t behind_quoted(std::string_view text, std::size_t at) {
  const char quote = text[at];
  const std::string triple(3, quote);
  const bool many_lines = text.substr(at, 3) == triple;
  for (at += many_lines ? 3 : 1; at < text.size(); ++at) {
    if (text[at] == '\\' && quote == '"') {
      ++at;
    } else if (!many_lines && (text[at] == quote || text[at] == '\n')) {
      return at + 1;
    } else if (many_lines && text.substr(at, 3) == triple) {
      return std::min(text.find_first_not_of(quote, at), text.size());  // quotes before the closing three are content
    }
  }
  return text.size();
}

// The first byte outside quotes and comments that is not ASCII; TOML has no use for one there, and toml++ 3.3 does not
// know of all of them whether they are blanks, which is undefined behaviour.
std::optional<std::size_t> bare_non_ascii(std::string_view text) {
  for (std::size_t at = byte_order_mark_size(text); at < text.size();) {
    if (text[at] == '"' || text[at] == '\'') {
      at = behind_quoted(text, at);
    } else if (text[at] == '#') {
      at = std::min(text.find('\n', at), text.size());
    } else if (static_cast<unsigned char>(text[at]) >= 0x80U) {
      return at;
    } else {
      ++at;
    }
  }
  return std::nullopt;
}

// toml++ counts lines and columns from 1, columns in code points; a Span counts bytes.
class Offsets {
 public:
  explicit Offsets(std::string_view text) : text_(text) {
    lines_.push_back(byte_order_mark_size(text));  // a byte order mark is no column
    for (std::size_t i = 0; i < text.size(); ++i) {
      if (text[i] == '\n') lines_.push_back(i + 1);
    }
  }

  Span of(const toml::source_region& region) {
    const Seen begin = find(region.begin);
    const Seen end = find(region.end, begin);
    last_ = begin;
    return {begin.at, end.at > begin.at ? end.at - begin.at : 1};
  }

 private:
  struct Seen {
    std::size_t line = 0;
    std::size_t column = 1;
    std::size_t at = 0;
  };

  Seen find(const toml::source_position& position) const { return find(position, last_); }

  // Goes on from `from` where that stands before on the same line: values come in the order of the text by and large,
  // and a line may hold thousands of them.
  Seen find(const toml::source_position& position, const Seen& from) const {
    if (position.line == 0) return {};
    if (position.line > lines_.size()) return {position.line, 1, text_.size()};
    Seen seen{position.line, 1, lines_[position.line - 1]};
    if (from.line == seen.line && from.column <= position.column) seen = from;
    for (; seen.column < position.column && seen.at < text_.size() && text_[seen.at] != '\n'; ++seen.column) {
      ++seen.at;
      while (seen.at < text_.size() && (static_cast<unsigned char>(text_[seen.at]) & 0xC0U) == 0x80U) ++seen.at;
    }
    return seen;
  }

  std::string_view text_;
  std::vector<std::size_t> lines_;
  Seen last_;
};

TomlValue convert(const toml::node& node, Offsets& offsets);

std::vector<TomlEntry> entries_of(const toml::table& table, Offsets& offsets) {
  std::vector<TomlEntry> entries;
  for (const auto& [key, value] : table) {
    entries.push_back({std::string(key.str()), offsets.of(key.source()), convert(value, offsets)});
  }
  std::sort(entries.begin(), entries.end(),
            [](const TomlEntry& a, const TomlEntry& b) { return a.key_span.offset < b.key_span.offset; });
  return entries;
}

TomlValue convert(const toml::node& node, Offsets& offsets) {
  TomlValue value;
  value.span = offsets.of(node.source());
  switch (node.type()) {
    case toml::node_type::table:
      value.kind = TomlValue::Kind::table;
      value.entries = entries_of(*node.as_table(), offsets);
      break;
    case toml::node_type::array:
      value.kind = TomlValue::Kind::array;
      for (const toml::node& item : *node.as_array()) value.items.push_back(convert(item, offsets));
      break;
    case toml::node_type::string:
      value.kind = TomlValue::Kind::text;
      value.text = node.as_string()->get();
      break;
    case toml::node_type::integer:
      value.kind = TomlValue::Kind::number;
      value.number = static_cast<double>(node.as_integer()->get());
      break;
    case toml::node_type::floating_point:
      value.kind = TomlValue::Kind::number;
      value.number = node.as_floating_point()->get();
      break;
    case toml::node_type::boolean:
      value.kind = TomlValue::Kind::boolean;
      value.flag = node.as_boolean()->get();
      break;
    default:
      value.kind = TomlValue::Kind::date;
      break;
  }
  return value;
}

}  // namespace

const TomlEntry* TomlValue::find(std::string_view key) const {
  const auto found = std::find_if(entries.begin(), entries.end(), [&](const TomlEntry& e) { return e.key == key; });
  return found == entries.end() ? nullptr : &*found;
}

Place TomlDocument::place(Span span) const {
  Place place = place_in(file, text, span.offset, span.length);
  const std::size_t room = std::max<std::size_t>(place.text.size() + 1 - place.column, 1);
  place.length = std::clamp<std::size_t>(span.length, 1, room);
  return place;
}

std::string_view name_of(TomlValue::Kind kind) {
  switch (kind) {
    case TomlValue::Kind::text:
      return "text";
    case TomlValue::Kind::number:
      return "a number";
    case TomlValue::Kind::boolean:
      return "true or false";
    case TomlValue::Kind::array:
      return "an array";
    case TomlValue::Kind::table:
      return "a table";
    case TomlValue::Kind::date:
      break;
  }
  return "a date";
}

TomlDocument parse_toml(std::string text, std::string file) {
  TomlDocument document{std::move(file), std::move(text), {}};
  if (const std::optional<std::size_t> at = bare_non_ascii(document.text)) {
    refuse("toml-syntax", "outside quotes and comments only ASCII characters may stand",
           "put texts into quotes; a blank or a minus that looks like one may be another character",
           document.place({*at, 1}));
  }
  Offsets offsets(document.text);
  try {
    const toml::table table = toml::parse(document.text, document.file);
    document.root.entries = entries_of(table, offsets);
  } catch (const toml::parse_error& error) {
    std::string_view what = error.description();  // "Error while parsing <what>: <why>"
    constexpr std::string_view kPreface = "Error while parsing ";
    if (what.starts_with(kPreface)) what.remove_prefix(kPreface.size());
    refuse("toml-syntax", std::string(what),
           "write it as TOML wants it: key = value, texts in quotes, a point in decimals",
           document.place(offsets.of(error.source())));
  }
  return document;
}

}  // namespace plumbline
