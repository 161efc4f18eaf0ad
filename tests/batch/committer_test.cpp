#include "batch/committer.hpp"

#include <filesystem>

#include <catch2/catch.hpp>

#include "support/scratch.hpp"

using namespace plumbline;
using namespace plumbline::testing;
using batch::Work;

namespace {

Work work_of(const Scratch& scratch, const std::string& name) {
  Work work;
  work.task = {0, name, name, scratch.path(name)};
  work.item.program = name;
  work.entry.place = name;
  work.output = std::make_unique<WaitingOutput>(scratch.path(name));
  work.output->destination().taker()("of " + name);
  return work;
}

}  // namespace

TEST_CASE("outputs take their places, and the record knows them as they are there") {
  const Scratch scratch;
  batch::Record record(scratch / "record");
  std::vector<std::string> settled;
  batch::Committer committer(record, [&](Work&& work) { settled.push_back(work.item.program); });
  CHECK(committer.take(work_of(scratch, "a")));
  CHECK(committer.take(work_of(scratch, "b")));
  committer.finish();
  CHECK(settled == std::vector<std::string>{"a", "b"});
  CHECK(scratch.text("a") == "of a");
  CHECK(record.find("b")->output.state == file_state(scratch.path("b")));
  CHECK(record.find("b")->output.hash == file_hash(scratch.path("b")));
}

TEST_CASE("an output that cannot take its place is that program's failure alone") {
  const Scratch scratch;
  batch::Record record(scratch / "record");
  std::vector<Work> settled;
  batch::Committer committer(record, [&](Work&& work) { settled.push_back(std::move(work)); });
  Work blocked = work_of(scratch, "a");
  std::filesystem::create_directory(scratch.path("a"));
  committer.take(std::move(blocked));
  committer.take(work_of(scratch, "b"));
  committer.finish();
  REQUIRE(settled.size() == 2);
  CHECK(settled[0].item.state == jobs::BatchItem::State::failed);
  CHECK(settled[0].item.diagnostics[0].code == "file-unwritable");
  CHECK(settled[1].item.state == jobs::BatchItem::State::done);
  CHECK(scratch.text("b") == "of b");
}

TEST_CASE("a record that fails ends it, and no output appears that it does not know") {
  const Scratch scratch;
  batch::Record record(scratch / "record");
  batch::Database(scratch / "record").run("DROP TABLE outputs");
  batch::Committer committer(record, [](Work&&) {});
  committer.take(work_of(scratch, "a"));
  CHECK(refusal_of([&] { committer.finish(); }).code == "batch-record");
  CHECK_FALSE(scratch.has("a"));
  CHECK_FALSE(committer.take(work_of(scratch, "b")));
}
