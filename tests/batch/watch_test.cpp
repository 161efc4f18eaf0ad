#include "batch/watch.hpp"

#include <catch2/catch.hpp>

#include "batch/shop.hpp"

using namespace plumbline;
using namespace plumbline::testing;

TEST_CASE("watch: each change is followed by another round, and a refusal is told once") {
  const Shop shop;
  shop.scratch.file("parts/inner/b.nc", "G0 X0 Y0 Z0 A0 B0 C0\nG1 X1 X2 F100\n");
  for (const char* const name : {"parts/a.nc", "parts/inner/b.nc"}) {
    std::filesystem::last_write_time(shop.scratch.path(name),
                                     std::filesystem::file_time_type::clock::now() - std::chrono::hours(1));
  }
  std::vector<std::string> told;
  int rounds = 0;
  batch::Watcher watcher;
  watcher.item = [&](const jobs::BatchItem& item) {
    told.push_back(std::filesystem::path(item.program).filename().string() + (item.state == State::done ? " done"
                                                                              : item.state == State::failed
                                                                                  ? " refused"
                                                                                  : " as it was"));
  };
  watcher.round = [&](const batch::Result&) {
    ++rounds;
    if (rounds == 1) shop.scratch.file("parts/c.nc", kPart);
    // A file that all programs are made with.
    if (rounds == 2) {
      shop.scratch.file("parts/plumbline.toml", "step_length = 0.5\n" + shop.scratch.text("parts/plumbline.toml"));
    }
  };
  watcher.goes_on = [&] { return rounds < 3; };
  batch::watch(shop.request(), {{}, std::chrono::milliseconds(200)}, watcher);
  CHECK(told ==
        std::vector<std::string>{"a.nc done", "b.nc refused", "a.nc as it was", "c.nc done", "a.nc done", "c.nc done"});
}
