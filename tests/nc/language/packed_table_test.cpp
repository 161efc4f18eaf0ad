#include "nc/language/packed_table.hpp"

#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "base/text/toml.hpp"
#include "nc/language/dialect_list.hpp"
#include "support/scratch.hpp"

using namespace plumbline;
using nc::PackedValue;

namespace {

using Kind = TomlValue::Kind;

// What differs from the text that was packed; empty if nothing does. Counts the values that were compared.
std::string difference(const TomlValue& text, const PackedValue& packed, int& values) {
  ++values;
  switch (text.kind) {
    case Kind::text:
      return packed.kind() == PackedValue::Kind::text && packed.text() == text.text ? "" : text.text;
    case Kind::number:
      return packed.kind() == PackedValue::Kind::number && packed.number() == text.number ? "" : "a number";
    case Kind::boolean:
      return packed.kind() == PackedValue::Kind::boolean && packed.flag() == text.flag ? "" : "a boolean";
    case Kind::array: {
      if (packed.kind() != PackedValue::Kind::array) return "an array";
      std::size_t i = 0;
      for (const PackedValue item : packed.items()) {
        if (i == text.items.size()) return "an item too many";
        if (std::string wrong = difference(text.items[i++], item, values); !wrong.empty()) return wrong;
      }
      return i == text.items.size() ? "" : "an item too few";
    }
    case Kind::table: {
      if (packed.kind() != PackedValue::Kind::table) return "a table";
      std::size_t entries = 0;
      packed.each_entry([&](std::string_view, const PackedValue&) { ++entries; });
      if (entries != text.entries.size()) return "the number of entries";
      for (const TomlEntry& entry : text.entries) {
        const auto value = packed.find(entry.key);
        if (!value) return entry.key;
        if (std::string wrong = difference(entry.value, *value, values); !wrong.empty())
          return entry.key + ": " + wrong;
      }
      return "";
    }
    case Kind::date:
      break;
  }
  return "a date";
}

}  // namespace

TEST_CASE("the packed tables say what the tables of grammar/ say") {
  for (const nc::EmbeddedTable& table : nc::embedded_tables()) {
    INFO(table.name);
    const std::string path = testing::source_file("grammar/" + std::string(table.name) + ".toml");
    const TomlDocument document = parse_toml(read_text(path), path);
    int values = 0;
    CHECK(difference(document.root, PackedValue(*table.packed), values).empty());
    CHECK(values > 500);
  }
}

TEST_CASE("a packed value is read where it lies") {
  using namespace std::string_literals;
  const std::string bytes =
      "o\x2c\0\0\0"
      "\x04size"
      "n\x08\0\0\0"
      "\0\0\0\0\0\0\xf8\xbf"
      "\x03who"
      "t\x01\0\0\0"
      "x"
      "\x02on"
      "b\x01\0\0\0"
      "\x01"
      "\x01"
      "l"
      "a\0\0\0\0"s;
  const PackedValue table(bytes);
  CHECK(table.find("size")->number() == -1.5);
  CHECK(table.find("who")->text() == "x");
  CHECK(table.find("on")->flag());
  CHECK_FALSE(table.find("l")->items().begin() != table.find("l")->items().end());
  CHECK_FALSE(table.find("none"));
}
