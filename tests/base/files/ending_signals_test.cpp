#include "base/files/ending_signals.hpp"

#include <csignal>
#include <filesystem>
#include <utility>

#include <catch2/catch.hpp>
#include <sys/wait.h>
#include <unistd.h>

#include "support/scratch.hpp"

using namespace plumbline;
namespace fs = std::filesystem;

namespace {

// Runs `work` in a process of its own in which `signal` has its usual end; gives how that process ended.
template <class Work>
int ended(int signal, const Work& work) {
  const pid_t child = fork();
  if (child == 0) {
    std::signal(signal, SIG_DFL);
    remove_names_on_signals();
    work();
    _exit(0);
  }
  int status = 0;
  REQUIRE(waitpid(child, &status, 0) == child);
  return status;
}

}  // namespace

TEST_CASE("a passing name goes with its owner, a file or an empty folder, and need not exist") {
  const testing::Scratch scratch;
  {
    const PassingName file(scratch.file("file", "text"));
    const PassingName nothing(scratch / "nothing");
    fs::create_directories(scratch / "empty");
    const PassingName empty(scratch / "empty");
    fs::create_directories(scratch / "full/inner");
    const PassingName full(scratch / "full");
    CHECK(scratch.has("file"));
  }
  CHECK_FALSE(scratch.has("file"));
  CHECK_FALSE(scratch.has("empty"));
  CHECK(scratch.has("full/inner"));
}

TEST_CASE("a name that was let go stays, and one that moved has one owner") {
  const testing::Scratch scratch;
  {
    PassingName kept(scratch.file("kept", ""));
    kept.let_go();
    PassingName one(scratch.file("one", ""));
    PassingName other(scratch.file("other", ""));
    other = std::move(one);  // what it had goes
    CHECK_FALSE(scratch.has("other"));
    CHECK(scratch.has("one"));
    CHECK(other.path() == scratch / "one");
  }
  CHECK(scratch.has("kept"));
  CHECK_FALSE(scratch.has("one"));
}

TEST_CASE("a signal removes the names and ends the process as it always does") {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGXFSZ}) {
    INFO("signal " << signal);
    const testing::Scratch scratch;
    const int status = ended(signal, [&] {
      fs::create_directory(scratch / "made");
      const PassingName folder(scratch / "made");
      const PassingName file(scratch.file("made/half", "text"));
      PassingName done(scratch.file("whole", "text"));
      done.let_go();
      raise(signal);
    });
    CHECK(WIFSIGNALED(status));
    CHECK(WTERMSIG(status) == signal);
    CHECK_FALSE(scratch.has("made"));
    CHECK(scratch.has("whole"));
  }
}

TEST_CASE("a signal waits as long as files that belong together are renamed") {
  const testing::Scratch scratch;
  const int status = ended(SIGTERM, [&] {
    const PassingName half(scratch.file("half", ""));
    {
      const SignalsWait outer;
      {
        const SignalsWait inner;
        raise(SIGTERM);
      }
      scratch.file("renamed", "");  // the outer one waits still
    }
    scratch.file("too late", "");
  });
  CHECK(WIFSIGNALED(status));
  CHECK(WTERMSIG(status) == SIGTERM);
  CHECK(scratch.has("renamed"));
  CHECK_FALSE(scratch.has("half"));
  CHECK_FALSE(scratch.has("too late"));
}

TEST_CASE("what its parent had the process ignore stays ignored") {
  const testing::Scratch scratch;
  const int status = ended(SIGTERM, [&] {
    std::signal(SIGHUP, SIG_IGN);
    remove_names_on_signals();
    PassingName name(scratch.file("half", ""));
    raise(SIGHUP);
    scratch.file("went on", "");
    name.let_go();
  });
  CHECK(WIFEXITED(status));
  CHECK(scratch.has("went on"));
  CHECK(scratch.has("half"));
}
