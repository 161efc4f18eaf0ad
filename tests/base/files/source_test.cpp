#include "base/files/source.hpp"

#include <stdexcept>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "base/files/files.hpp"
#include "support/scratch.hpp"

using namespace plumbline;

TEST_CASE("a held text is read as a file of that name would be") {
  const InputFile file(Source::held("part.ngc", std::string("G0 X1\nM2\n")));
  CHECK(file.name() == "part.ngc");
  CHECK(file.size() == 9);
  std::string some(4, '-');
  CHECK(file.read(6, some.data(), some.size()) == 3);
  CHECK(some == "M2\n-");
  CHECK(file.read(9, some.data(), some.size()) == 0);
  CHECK(file.read(1000, some.data(), some.size()) == 0);
  CHECK_FALSE(file.is_same_as("part.ngc"));
  file.check_unchanged();
  CHECK(read_text(Source::held("-", std::string("all"))) == "all");
  CHECK(InputFile(Source::held("-", std::string())).name() == "-");
}

TEST_CASE("a path is a file, - is standard input, nothing is empty") {
  CHECK(Source("-").is_standard_input());
  CHECK(Source("-").name() == "<stdin>");
  CHECK(Source("a.ngc").name() == "a.ngc");
  CHECK(Source().empty());
  CHECK_FALSE(Source::held("", std::string()).empty());
}

TEST_CASE("who takes the bytes of an output gets them when it is whole, and nothing before") {
  std::string taken = "as it was";
  int calls = 0;
  const Destination to = Destination::taken("<text>", [&](std::string_view bytes) {
    if (calls++ == 0) taken.clear();
    taken += bytes;
  });
  {
    OutputFile dropped(to);
    dropped.write("never committed");
  }
  CHECK(calls == 0);
  OutputFile whole(to);
  const std::string large(1'000'000, 'x');
  whole.write(large);
  CHECK(calls == 0);
  whole.commit();
  CHECK(taken == large);
  OutputFile empty(to);
  calls = 0;
  empty.commit();
  CHECK(taken.empty());
  CHECK_FALSE(empty.is_file());
}

TEST_CASE("files of a set appear after what is taken, and not at all where the taker throws") {
  const testing::Scratch scratch;
  OutputFile file(scratch.path("out.txt"));
  file.write("text");
  OutputFile taken(Destination::taken("<text>", [](std::string_view) { throw std::runtime_error("no"); }));
  OutputSet set;
  set.add(file);
  set.add(taken);
  CHECK_THROWS_AS(set.commit(), std::runtime_error);
  CHECK_FALSE(scratch.has("out.txt"));
}
