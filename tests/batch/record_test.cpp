#include "batch/record.hpp"

#include <thread>

#include <catch2/catch.hpp>

#include "support/scratch.hpp"

using namespace plumbline;
using namespace plumbline::testing;
using batch::Entry;
using batch::Record;

namespace {

Entry entry_of(const std::string& place) {
  Entry entry;
  entry.place = place;
  entry.source = "/parts/\xfc.nc";  // no UTF-8
  entry.program = {{12, -3, 0xffffffffffffffffULL}, 0x8000000000000001ULL};
  entry.settings = 0xfedcba9876543210ULL;
  entry.dialect = "fanuc";
  entry.called = {{"1000", "O1000\xe4.nc", {{5, 6, 7}, 8}}, {"2000", "", {}}};
  entry.folder_changed_ns = 99;
  entry.output = {{1, 2, 3}, 4};
  entry.has_undo = true;
  entry.summary = "{}";
  return entry;
}

}  // namespace

TEST_CASE("record: an entry comes back as it was, in the next run too") {
  const Scratch scratch;
  const Entry entry = entry_of("a/b.nc");
  { Record(scratch / "record").put({&entry}); }
  Record record(scratch / "record");
  const auto found = record.find("a/b.nc");
  REQUIRE(found);
  CHECK(found->source == entry.source);
  CHECK(found->program.state == entry.program.state);
  CHECK(found->program.hash == entry.program.hash);
  CHECK(found->settings == entry.settings);
  CHECK(found->dialect == "fanuc");
  REQUIRE(found->called.size() == 2);
  CHECK(found->called[0].path == entry.called[0].path);
  CHECK(found->called[0].file.hash == 8);
  CHECK(found->called[1].path.empty());
  CHECK(found->folder_changed_ns == 99);
  CHECK(found->output.state == entry.output.state);
  CHECK(found->has_undo);
  CHECK(found->summary == "{}");
  CHECK_FALSE(record.find("a"));
}

TEST_CASE("record: entries are replaced, gone through and removed") {
  const Scratch scratch;
  Record record(scratch / "record");
  Entry one = entry_of("one");
  const Entry two = entry_of("two");
  record.put({&one, &two});
  one.settings = 5;
  record.put({&one});
  CHECK(record.find("one")->settings == 5);
  std::vector<std::string> places;
  record.each([&](const Entry& entry) { places.push_back(entry.place); });
  CHECK(places == std::vector<std::string>{"one", "two"});
  record.remove({"one"});
  CHECK_FALSE(record.find("one"));
  CHECK(record.find("two"));
}

TEST_CASE("record: several processes, each with a connection of its own, write at a time") {
  const Scratch scratch;
  constexpr int kEach = 40;
  {
    std::vector<std::jthread> writers;
    for (int w = 0; w < 3; ++w) {
      writers.emplace_back([&, w] {
        Record record(scratch / "record");
        for (int i = 0; i < kEach; ++i) {
          const Entry entry = entry_of(std::to_string(w) + "/" + std::to_string(i));
          record.put({&entry});
        }
      });
    }
  }
  Record record(scratch / "record");
  int count = 0;
  record.each([&](const Entry&) { ++count; });
  CHECK(count == 3 * kEach);
}

TEST_CASE("record: what is none, or a later version's, is refused with the way out") {
  const Scratch scratch;
  scratch.file("text", std::string(5000, 'x'));
  const Diagnostic none = refusal_of([&] { Record(scratch / "text"); });
  CHECK(none.code == "batch-record");
  CHECK(none.help.find("name another file with --record") != std::string::npos);
  CHECK(none.help.find("remove") == std::string::npos);
  batch::Database(scratch / "later").run("PRAGMA user_version = 2");
  CHECK(refusal_of([&] { Record(scratch / "later"); }).message.find("later version") != std::string::npos);
  CHECK(refusal_of([&] { Record(scratch / "no/folder"); }).code == "batch-record");
}
