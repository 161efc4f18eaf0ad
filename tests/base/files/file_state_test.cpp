#include "base/files/file_state.hpp"

#include <filesystem>

#include <catch2/catch.hpp>

#include "base/text/hash.hpp"
#include "support/scratch.hpp"

using namespace plumbline;
using namespace plumbline::testing;

TEST_CASE("the state of a file tells when it is written to, replaced or gone") {
  const Scratch scratch;
  const std::string path = scratch.file("a", "one");
  const auto first = file_state(path);
  REQUIRE(first);
  CHECK(first->size == 3);
  CHECK(file_state(path) == first);
  scratch.file("a", "two");  // another file takes the name
  CHECK(file_state(path) != first);
  std::filesystem::last_write_time(path, std::filesystem::file_time_type::clock::now() + std::chrono::hours(1));
  CHECK(file_state(path)->changed_ns > now_ns());
  CHECK_FALSE(file_state(scratch.path("none")));
  CHECK_FALSE(file_state(scratch.path("")));
  CHECK(folder_state(scratch.path("")));
  CHECK_FALSE(folder_state(path));
}

TEST_CASE("the hash of a file is that of its text, however long") {
  const Scratch scratch;
  const std::string text(200'000, 'x');
  CHECK(file_hash(scratch.file("a", text)) == fnv1a(text));
  CHECK(file_hash(scratch.file("b", "")) == fnv1a({}));
  CHECK(refusal_of([&] { file_hash(scratch.path("none")); }).code == "file-missing");
}
