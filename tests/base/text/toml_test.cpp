#include "base/text/toml.hpp"

#include <catch2/catch.hpp>

#include "support/scratch.hpp"

using namespace plumbline;

namespace {

// Line and column at which a text is refused.
std::pair<std::size_t, std::size_t> place_of(const char* text) {
  const Diagnostic refused = testing::refusal_of([&] { parse_toml(text, "m.toml"); });
  CHECK(refused.code == "toml-syntax");
  return {refused.place.line, refused.place.column};
}

}  // namespace

TEST_CASE("each key and value knows its bytes") {
  const std::string text =
      "# h\xc3\xa4\nname = \"\xc3\xa4x\"  # c\n[strut]\na = [1, 2.5]\n[[row]]\nb = true\n[[row]]\nb = -3\n";
  const TomlDocument document = parse_toml(text, "m.toml");
  const auto cut = [&](TextSpan span) { return text.substr(span.offset, span.length); };
  const TomlEntry* name = document.root.find("name");
  REQUIRE(name != nullptr);
  CHECK(cut(name->key_span) == "name");
  CHECK(cut(name->value.span) == "\"\xc3\xa4x\"");
  const TomlEntry* a = document.root.find("strut")->value.find("a");
  CHECK(cut(a->value.span) == "[1, 2.5]");
  CHECK(cut(a->value.items[1].span) == "2.5");
  CHECK(document.place(a->value.items[1].span).line == 4);
  CHECK(document.place(a->value.items[1].span).column == 9);
  const TomlValue& rows = document.root.find("row")->value;
  REQUIRE(rows.items.size() == 2);
  CHECK(rows.items[0].find("b")->value.flag);
  CHECK(rows.items[1].find("b")->value.number == -3);
  CHECK(document.root.find("none") == nullptr);
}

TEST_CASE("a byte order mark and Windows line ends move nothing") {
  const std::string text =
      "\xEF\xBB\xBF"
      "a = 12\r\nb = [3, 45]\r\nc = 6";
  const TomlDocument document = parse_toml(text, "m.toml");
  const auto cut = [&](const char* key) {
    const TextSpan span = document.root.find(key)->value.span;
    return text.substr(span.offset, span.length);
  };
  CHECK(cut("a") == "12");
  CHECK(cut("b") == "[3, 45]");
  CHECK(cut("c") == "6");
  CHECK(document.place(document.root.find("b")->value.span).text == "b = [3, 45]");
}

TEST_CASE("keys and values of one line are found in any order") {
  const std::string text = "t = {z = [[1, \"\xc3\xa4\"], [22]], a = 333, m = {q = 4, b = 55}}\n";
  const TomlDocument document = parse_toml(text, "m.toml");
  const auto cut = [&](TextSpan span) { return text.substr(span.offset, span.length); };
  const TomlValue& t = document.root.find("t")->value;
  CHECK(cut(t.find("z")->value.items[1].items[0].span) == "22");
  CHECK(cut(t.find("a")->value.span) == "333");
  CHECK(cut(t.find("m")->key_span) == "m");
  CHECK(cut(t.find("m")->value.find("b")->value.span) == "55");
  CHECK(cut(t.find("m")->value.find("q")->value.span) == "4");
}

TEST_CASE("characters that are not ASCII stand in quotes and comments, and are refused elsewhere") {
  for (const char* text : {"a = \"\xc3\xa4\"", "a = '\xc3\xa4\\' # \xc3\xa4", "a = \"\\\"\xc3\xa4\"",
                           "\"\xc3\xa4\" = 1", "a = \"\"\"\xc3\xa4\n\"\xc3\xa4\"\"\"\"\nb = 1",
                           "a = \'\'\'\n\xc3\xa4\'\'\' # \xc3\xa4\n", "a = \"\"\"x \\\n  \xc3\xa4\"\"\"\n"}) {
    INFO(text);
    CHECK_FALSE(parse_toml(text, "m.toml").root.entries.empty());
  }
  CHECK(place_of("a = [0, 35\xd0\xa8]\n") == std::pair<std::size_t, std::size_t>(1, 11));
  CHECK(place_of("a = 1 # \xc3\xa4\nb =\xc2\xa0"
                 "2\n") == std::pair<std::size_t, std::size_t>(2, 4));
  CHECK(place_of("\xc3\xa4 = 1\n") == std::pair<std::size_t, std::size_t>(1, 1));
  CHECK(place_of("a = \"\"\"x\"\"\" \xd4\xa4") == std::pair<std::size_t, std::size_t>(1, 13));
  CHECK(place_of("a = \"open\n\xd4\xa4") == std::pair<std::size_t, std::size_t>(1, 10));
  CHECK(place_of("a = \"\"\"\\\xc6\xad\"\"\"") == std::pair<std::size_t, std::size_t>(1, 9));
}

TEST_CASE("what is no TOML is refused where it stands") {
  CHECK(place_of("a = 1\na = 2\n").first == 2);
  CHECK(place_of("a = \n").first == 1);
  CHECK(place_of("[x\nb = 1").first == 1);
  CHECK(place_of("#\r") == std::pair<std::size_t, std::size_t>(1, 2));
  CHECK(place_of("x = 1\ny = 1e999") == std::pair<std::size_t, std::size_t>(2, 10));
}

TEST_CASE("a place is that which counting lines from the begin gives") {
  std::string text = "a = 1\r\n\n";
  for (int i = 0; i < 50; ++i) text += "[[row]]\nname = \"x\"\r\nvalues = [\n1,\n2]\n";
  const TomlDocument document = parse_toml(text, "m.toml");
  const auto check = [&](TextSpan span) {
    const Place place = document.place(span);
    const Place counted = place_in("m.toml", text, span.offset, span.length);
    CHECK(place.line == counted.line);
    CHECK(place.column == counted.column);
    CHECK(place.text == counted.text);
  };
  for (const TomlValue& row : document.root.find("row")->value.items) {
    for (const TomlEntry& entry : row.entries) {
      check(entry.key_span);
      check(entry.value.span);
    }
  }
  check({text.size(), 1});
  check({0, 1});
}
