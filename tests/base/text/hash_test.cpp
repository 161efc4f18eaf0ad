#include "base/text/hash.hpp"

#include <catch2/catch.hpp>

using namespace plumbline;

TEST_CASE("the fingerprint is FNV-1a of 64 bits, as its authors' vectors have it") {
  CHECK(to_hex(fnv1a("")) == "cbf29ce484222325");
  CHECK(to_hex(fnv1a("a")) == "af63dc4c8601ec8c");
  CHECK(to_hex(fnv1a("foobar")) == "85944171f73967e8");
}

TEST_CASE("a text hashed in parts has the hash of the whole") {
  CHECK(fnv1a("bar", fnv1a("foo")) == fnv1a("foobar"));
  CHECK(fnv1a("foo", fnv1a("bar")) != fnv1a("foobar"));
  CHECK(fnv1a("", fnv1a("foo")) == fnv1a("foo"));
}

TEST_CASE("sixteen digits are written, zeros in front kept") {
  CHECK(to_hex(0) == "0000000000000000");
  CHECK(to_hex(0xABC) == "0000000000000abc");
  CHECK(to_hex(~std::uint64_t{0}) == "ffffffffffffffff");
}
