#include "batch/freshness.hpp"

#include <filesystem>

#include <catch2/catch.hpp>

#include "base/text/hash.hpp"
#include "support/scratch.hpp"

using namespace plumbline;
using namespace plumbline::testing;
using batch::Entry;
using batch::KnownFile;

namespace {

namespace fs = std::filesystem;

// Long ago enough for any clock.
void age(const std::string& path) {
  fs::last_write_time(path, fs::file_time_type::clock::now() - std::chrono::hours(1));
}

KnownFile known(const std::string& path) { return {*file_state(path), file_hash(path)}; }

struct Made {
  Made() {
    program = scratch.file("a.nc", "M98 P1000\n");
    sub = scratch.file("O1000.nc", "M99\n");
    output = scratch.file("out.nc", "done\n");
    for (const std::string& path : {program, sub, output, scratch.path("")}) age(path);
    entry.program = known(program);
    entry.output = known(output);
    entry.dialect = "fanuc";
    entry.called = {{"1000", "O1000.nc", known(sub)}};
    entry.folder_changed_ns = batch::folder_change(program);
    entry.settings = settings.hash = 7;
  }
  batch::Freshness look() { return batch::freshness(entry, program, output, settings); }

  Scratch scratch;
  std::string program, sub, output;
  batch::FolderSettings settings;
  Entry entry;
};

}  // namespace

TEST_CASE("an output is fresh as long as all that it was made from is as it was") {
  Made made;
  CHECK(made.look().is_fresh);
  CHECK_FALSE(made.look().looks_new);
  SECTION("settings") {
    made.settings.hash = 8;
    CHECK_FALSE(made.look().is_fresh);
  }
  SECTION("the program") {
    made.scratch.file("a.nc", "M98 P1001\n");
    CHECK_FALSE(made.look().is_fresh);
  }
  SECTION("a file that it calls") {
    made.scratch.file("O1000.nc", "M00\n");
    CHECK_FALSE(made.look().is_fresh);
    fs::remove(made.sub);
    CHECK_FALSE(made.look().is_fresh);
  }
  SECTION("another file that the control would take for the call") {
    made.scratch.file("O1000", "M99\n");
    CHECK_FALSE(made.look().is_fresh);
  }
  SECTION("the output") {
    made.scratch.file("out.nc", "DONE\n");
    CHECK_FALSE(made.look().is_fresh);
  }
  SECTION("an undo file that is asked for") {
    made.settings.options.undo = true;
    CHECK_FALSE(made.look().is_fresh);
    made.entry.has_undo = true;
    CHECK_FALSE(made.look().is_fresh);
    made.scratch.file("out.nc.undo", "");
    CHECK(made.look().is_fresh);
  }
}

TEST_CASE("files that were copied, and hold the same, are fresh and known anew") {
  Made made;
  for (const std::string& path : {made.program, made.sub, made.output}) {
    made.scratch.file("copy", read_text(path));
    fs::rename(made.scratch.path("copy"), path);
    age(path);
  }
  age(made.scratch.path(""));
  const batch::Freshness found = made.look();
  CHECK(found.is_fresh);
  CHECK(found.looks_new);
  CHECK_FALSE(made.look().looks_new);
}

TEST_CASE("a file that was written to just before it was read is read again next time") {
  const FileState state{10, 5'000'000'000, 3};
  CHECK(batch::known_file(state, 1, 8'000'000'000).state == state);
  CHECK(batch::known_file(state, 1, 6'000'000'000).state != state);
}
