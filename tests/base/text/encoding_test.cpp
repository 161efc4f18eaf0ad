#include "base/text/encoding.hpp"

#include <catch2/catch.hpp>

#include "base/text/csv.hpp"
#include "base/text/toml.hpp"
#include "support/scratch.hpp"

using namespace plumbline;

TEST_CASE("text that editors of Windows keep in other encodings is refused with the way out") {
  const auto refused = [](const char* text, std::size_t size) {
    return testing::refusal_of([&] { parse_toml(std::string(text, size), "m.toml"); });
  };
  const Diagnostic latin = refused("name = \"M\xFC\"\n", 12);
  CHECK(latin.code == "toml-syntax");
  CHECK(latin.help.find("UTF-8") != std::string::npos);
  const Diagnostic wide = refused("\xFF\xFEn\0", 4);
  CHECK(wide.code == "file-not-text");
  CHECK(wide.help == "save it as plain text (ASCII or UTF-8)");
  const Diagnostic packed = refused("PK\x03\x04model.toml", 14);
  CHECK(packed.code == "file-not-text");
  CHECK(packed.help == "unpack it, and name the file that is in it");
  CHECK(testing::refusal_of([] { CsvLines("t.csv", "\xFE\xFF"); }).code == "file-not-text");
}
