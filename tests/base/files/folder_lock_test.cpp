// That a lock is refused after a minute is not tested, as no test waits that long.
#include "base/files/folder_lock.hpp"

#include <atomic>
#include <thread>

#include <catch2/catch.hpp>
#include <unistd.h>

#include "support/scratch.hpp"

using namespace plumbline;

TEST_CASE("one has a folder at a time, until it gives it back") {
  const testing::Scratch scratch;
  {
    const FolderLock lock(scratch.folder().string(), FolderLock::Kind::exclusive);
    CHECK_FALSE(FolderLock::try_lock(scratch.folder().string()));
  }
  const std::optional<FolderLock> next = FolderLock::try_lock(scratch.folder().string());
  CHECK(next);
  CHECK_FALSE(FolderLock::try_lock(scratch.folder().string()));
}

TEST_CASE("who only reads shares a folder, and keeps out who writes") {
  const testing::Scratch scratch;
  const FolderLock one(scratch.folder().string(), FolderLock::Kind::shared);
  const FolderLock two(scratch.folder().string(), FolderLock::Kind::shared);
  CHECK_FALSE(FolderLock::try_lock(scratch.folder().string()));
}

TEST_CASE("a lock is waited for") {
  const testing::Scratch scratch;
  std::optional<FolderLock> other = FolderLock::try_lock(scratch.folder().string());
  REQUIRE(other);
  std::atomic<bool> given_back = false;
  std::thread owner([&] {
    usleep(30'000);
    given_back = true;
    other.reset();
  });
  const FolderLock lock(scratch.folder().string(), FolderLock::Kind::exclusive);
  CHECK(given_back);
  owner.join();
  CHECK_FALSE(FolderLock::try_lock(scratch.folder().string()));
}

TEST_CASE("a lock makes no file, and is on one folder alone") {
  const testing::Scratch scratch;
  std::filesystem::create_directory(scratch / "inner");
  const FolderLock lock(scratch.folder().string(), FolderLock::Kind::exclusive);
  CHECK(FolderLock::try_lock(scratch / "inner"));
  CHECK(std::filesystem::is_empty(scratch / "inner"));
  CHECK(lock.sync());
}

TEST_CASE("what cannot be opened is no lock, and keeps nobody from going on") {
  const testing::Scratch scratch;
  const FolderLock none(scratch / "none", FolderLock::Kind::exclusive);
  CHECK(none.sync());
  CHECK_FALSE(FolderLock::try_lock(scratch / "none"));
  CHECK_FALSE(FolderLock::try_lock(scratch.file("file", "")));
}
