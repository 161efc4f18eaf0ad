#include "batch/sqlite.hpp"

#include <catch2/catch.hpp>

#include "support/scratch.hpp"

using namespace plumbline;
using namespace plumbline::testing;

TEST_CASE("sqlite: statements give rows, and a transaction that is not ended leaves nothing") {
  const Scratch scratch;
  batch::Database database(scratch / "file");
  database.run("CREATE TABLE t (name TEXT, number INTEGER)");
  batch::Statement put(database, "INSERT INTO t VALUES (?1, ?2)");
  {
    batch::Transaction given_up(database);
    put.bind(1, "lost").bind(2, std::int64_t{1}).step();
  }
  {
    batch::Transaction kept(database);
    put.bind(1, std::string_view("a\0b", 3)).bind(2, std::uint64_t{0xffffffffffffffffULL}).step();
    kept.commit();
  }
  batch::Statement all(database, "SELECT * FROM t");
  REQUIRE(all.step());
  CHECK(all.text(0) == std::string("a\0b", 3));
  CHECK(all.unsigned_number(1) == 0xffffffffffffffffULL);
  CHECK_FALSE(all.step());
}

TEST_CASE("sqlite: what goes wrong says which file it is") {
  const Scratch scratch;
  batch::Database database(scratch / "file");
  const Diagnostic wrong = refusal_of([&] { database.run("NONSENSE"); });
  CHECK(wrong.code == "batch-record");
  CHECK(wrong.place.file == scratch / "file");
  CHECK(wrong.message.find("syntax error") != std::string::npos);
  CHECK(refusal_of([&] { batch::Statement(database, "SELECT * FROM none"); }).code == "batch-record");
}
