#include "base/text/toml_depth.hpp"

#include <string>

#include <catch2/catch.hpp>

#include "base/text/toml.hpp"
#include "support/scratch.hpp"

using namespace plumbline;

namespace {

std::string repeated(const std::string& text, int count) {
  std::string all;
  for (int i = 0; i < count; ++i) all += text;
  return all;
}

}  // namespace

TEST_CASE("depth counts points of keys and brackets") {
  CHECK_FALSE(too_deep("a.b.c = 1\n[x.y]\nz = [[1.5, 2.5], [3.5]]\n", 2));
  CHECK(too_deep("a.b.c.d = 1\n", 2) == 5);
  CHECK(too_deep("[a . b.c.d]\n", 2) == 8);
  CHECK(too_deep("x = [[[1]]]\n", 2) == 6);
  CHECK(too_deep("x = {a = {b = {c = 1}}}\n", 2) == 14);
}

TEST_CASE("points in texts and comments are none of a key") {
  const std::string points = repeated(".", 100);
  for (const std::string& text :
       {"a = \"" + points + "\"", "a = '" + points + "'", "# " + points,
        std::string(R"(a = """)") + "\n" + points + "\n" + R"(""")", "a = '''\n" + points + "\n'''",
        R"(a = "\")" + points + "\"", "a = 1 # [[[" + points}) {
    INFO(text);
    CHECK_FALSE(too_deep(text + "\nb = 1\n", 2));
  }
}

TEST_CASE("texts end where the parser ends them: what stands after them counts") {
  for (const std::string text : {R"(a = """x"""" )", R"(a = """x""""" )", R"(a = '''x''''' )", R"(a = "x\\" )",
                                 R"(a = '\' )", R"(a = """\"""" )", R"(a = "" )"}) {
    INFO(text);
    CHECK(too_deep("[q." + repeated("a.", 1) + "a]\nt = { " + text + ", b" + repeated(".b", 40) + " = 1 }\n", 32));
  }
}

TEST_CASE("a text far too deep is refused at its place, before it is parsed") {
  for (const std::string& text :
       {"ok = 1\na" + repeated(".a", 200000) + " = 1\n", "ok = 1\n[" + repeated("a.", 200000) + "a]\n",
        "ok = 1\nx = " + repeated("[", 200000), "ok = 1\nx = " + repeated("{a = ", 200000),
        "ok = 1\nx = " + repeated("{a.a.a = ", 200000)}) {
    const Diagnostic refused = testing::refusal_of([&] { parse_toml(text, "m.toml"); });
    CHECK(refused.code == "toml-too-deep");
    CHECK(refused.place.line == 2);
  }
}
