#include "nc/language/dialect.hpp"

#include <bit>
#include <cstdint>
#include <set>
#include <string>

#include <catch2/catch.hpp>

#include "base/check.hpp"
#include "base/diagnostic.hpp"
#include "base/text/toml.hpp"
#include "nc/language/dialect_table.hpp"

using namespace plumbline;
using namespace plumbline::nc;

namespace {

std::string low_first(std::uint64_t number, int bytes) {
  std::string text;
  for (int i = 0; i < bytes; ++i) text += static_cast<char>(number >> (8 * i) & 0xff);
  return text;
}

// As cmake/pack_table.py packs a table (nc/language/packed_table.hpp).
std::string packed(const TomlValue& value) {
  using Kind = TomlValue::Kind;
  std::string content;
  for (const TomlValue& item : value.items) content += packed(item);
  for (const TomlEntry& entry : value.entries) {
    content += static_cast<char>(entry.key.size()) + entry.key + packed(entry.value);
  }
  if (value.kind == Kind::text) content = value.text;
  if (value.kind == Kind::number) content = low_first(std::bit_cast<std::uint64_t>(value.number), 8);
  if (value.kind == Kind::boolean) content = std::string(1, value.flag ? '\1' : '\0');
  const char letter = value.kind == Kind::text      ? 't'
                      : value.kind == Kind::number  ? 'n'
                      : value.kind == Kind::boolean ? 'b'
                      : value.kind == Kind::array   ? 'a'
                                                    : 'o';
  return letter + low_first(content.size(), 4) + content;
}

}  // namespace

TEST_CASE("the rows of the LinuxCNC dialect say what its documentation says") {
  const Dialect& linuxcnc = dialect("linuxcnc");
  CHECK(linuxcnc.feed_rule == FeedRule::xyz_first);
  CHECK(linuxcnc.feed_rate_min == 0.1);
  REQUIRE(linuxcnc.g_code(20) != nullptr);
  CHECK(linuxcnc.g_code(20)->meaning == "arc_cw");
  CHECK(linuxcnc.g_code(20)->order == Order::with_motion);
  CHECK(linuxcnc.g_code(901)->action == Action::arc_centre_absolute);
  CHECK(linuxcnc.g_code(593)->value == 9);
  CHECK(linuxcnc.m_code(300)->order == Order::after_motion);
  CHECK(linuxcnc.m_code(60)->loses_position);
  CHECK(linuxcnc.m_code(70)->harmless);
  CHECK(linuxcnc.g_code(11) == nullptr);
  CHECK(linuxcnc.g_code(-10) == nullptr);
  CHECK(linuxcnc.g_code(99999) == nullptr);
}

TEST_CASE("every dialect goes by its own name, and an unknown one is told of them") {
  for (const std::string_view name : dialect_names()) CHECK(dialect(name).name == name);
  CHECK_THROWS_AS(dialect("gcode"), Refusal);
}

TEST_CASE("F acts before the unit of its own block, motion after both, M0 at the end") {
  const Dialect& linuxcnc = dialect("linuxcnc");
  CHECK(linuxcnc.feed_row.step < linuxcnc.g_code(200)->step);
  CHECK(linuxcnc.g_code(940)->step < linuxcnc.feed_row.step);
  CHECK(linuxcnc.g_code(200)->step < linuxcnc.g_code(10)->step);
  CHECK(linuxcnc.g_code(10)->step < linuxcnc.m_code(0)->step);
}

TEST_CASE("a table that does not hold together is a bug of plumbline") {
  const auto table = [](const char* rows) {
    const std::string text = std::string(
                                 "name = \"t\"\nline_length = 80\ncomment_open = \"(\"\ncomment_close = \")\"\n"
                                 "feed_rule = \"xyz_first\"\nuser_m_codes = [100, 199]\n"
                                 "execution = [\"F\", \"S\", \"T\", \"user\", \"motion\"]\nm = []\n") +
                             rows;
    return packed(parse_toml(text, "t").root);
  };
  CHECK(read_dialect("t", table("g = [{ code = \"1\", group = 1, does = \"feed\", step = \"motion\" }]\n"))
            .g_code(10)
            ->action == Action::feed);
  CHECK_THROWS_AS(read_dialect("t", table("g = [{ code = \"1\", does = \"fly\", step = \"motion\" }]\n")),
                  InternalError);
  CHECK_THROWS_AS(read_dialect("t", table("g = [{ code = \"1\", does = \"feed\", step = \"late\" }]\n")),
                  InternalError);
  const std::string rows = "g = []\n[syntax]\nstatements = \"macro_b\"\nsystem_variables = \"none\"\n";
  CHECK(read_dialect("t", table((rows + "bitwise = true\nlast_variable = 7\n").c_str())).syntax.last_variable == 7);
  CHECK_THROWS_AS(read_dialect("t", table((rows + "bitwize = true\n").c_str())), InternalError);
  CHECK_THROWS_AS(read_dialect("t", table((rows + "labels = \"none\"\n").c_str())), InternalError);
  CHECK_THROWS_AS(read_dialect("t", table("g = []\n[habits]\nno_habit = 1\n")), InternalError);
  CHECK_THROWS_AS(read_dialect("t", table("g = [{ code = \"x\", does = \"feed\", step = \"motion\" }]\n")),
                  InternalError);
}
