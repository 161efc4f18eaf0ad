#include "batch/folder_watch.hpp"

#include <filesystem>
#include <fstream>

#include <catch2/catch.hpp>

#include "support/scratch.hpp"

using namespace plumbline;
using namespace plumbline::testing;
using batch::FolderWatch;
using std::chrono::milliseconds;

namespace {

constexpr milliseconds kLong{20'000};
constexpr milliseconds kRest{300};

batch::ProgramRequest request(const Scratch& scratch) { return {scratch.path("in"), "", scratch.path("out"), {}}; }

FolderWatch::Settings told() { return {{}, kRest}; }
FolderWatch::Settings looking() { return {milliseconds(50), kRest}; }

}  // namespace

TEST_CASE("a program is taken when it has come, not while it is being written") {
  const FolderWatch::Settings how = GENERATE(told(), looking());
  const Scratch scratch;
  std::filesystem::create_directories(scratch.path("in"));
  const auto programs = request(scratch);
  FolderWatch watch(programs, how);
  CHECK_FALSE(watch.wait(milliseconds(200)));
  std::ofstream writer(scratch.path("in/a.nc"));
  writer << "G0\n" << std::flush;
  for (int i = 0; i < 5; ++i) {
    CHECK_FALSE(watch.wait(milliseconds(120)));
    CHECK(watch.busy() == std::set<std::string>{scratch.path("in/a.nc")});
    writer << "G1\n" << std::flush;
  }
  writer.close();
  CHECK(watch.wait(kLong));
  CHECK(watch.busy().empty());
}

TEST_CASE("folders that come are watched too, what is no program is not, and what goes is told") {
  const FolderWatch::Settings how = GENERATE(told(), looking());
  const Scratch scratch;
  std::filesystem::create_directories(scratch.path("in"));
  const auto programs = request(scratch);
  FolderWatch watch(programs, how);
  scratch.file("in/notes.txt", "no program");
  CHECK_FALSE(watch.wait(milliseconds(400)));
  std::filesystem::create_directories(scratch.path("in/new/deep"));
  scratch.file("in/new/deep/b.nc", "G0\n");
  CHECK(watch.wait(kLong));
  while (!watch.busy().empty()) watch.wait(kLong);
  std::filesystem::remove(scratch.path("in/new/deep/b.nc"));
  CHECK(watch.wait(kLong));
}

TEST_CASE("a program that was written to a moment before is waited for") {
  const Scratch scratch;
  std::filesystem::create_directories(scratch.path("in"));
  scratch.file("in/a.nc", "G0\n");
  scratch.file("in/b.nc", "G0\n");
  std::filesystem::last_write_time(scratch.path("in/b.nc"),
                                   std::filesystem::file_time_type::clock::now() - std::chrono::hours(1));
  const auto programs = request(scratch);
  FolderWatch watch(programs, told());
  CHECK(watch.busy() == std::set<std::string>{scratch.path("in/a.nc")});
  CHECK(watch.wait(kLong));
  CHECK(watch.busy().empty());
}
