#include "report/depfile.hpp"

#include <catch2/catch.hpp>

using plumbline::report::depfile_text;

TEST_CASE("a depfile is a rule, and an empty one of each file") {
  CHECK(depfile_text("out.nc", {"a.nc", "m.toml"}) == "out.nc: \\\n  a.nc \\\n  m.toml\na.nc:\nm.toml:\n");
}

TEST_CASE("names are written as make reads them") {
  CHECK(depfile_text("o", {"a b#$c:d"}) == "o: \\\n  a\\ b\\#$$c\\:d\na\\ b\\#$$c\\:d:\n");
  CHECK(depfile_text("o", {R"(a\ b)"}) == "o: \\\n  a\\\\\\ b\na\\\\\\ b:\n");
  CHECK(depfile_text("o", {"two\nlines", ""}) == "o:\n");
}
