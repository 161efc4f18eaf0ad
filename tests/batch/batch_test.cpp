#include "batch/batch.hpp"

#include <algorithm>

#include <catch2/catch.hpp>
#ifndef _WIN32
#include <sys/stat.h>
#endif

#include "base/version.hpp"
#include "batch/shop.hpp"

using namespace plumbline;
using namespace plumbline::testing;

TEST_CASE("batch: outputs have the places of their programs, and are what compensate makes of each") {
  const Shop shop;
  const auto items = shop.run();
  REQUIRE(items.size() == 2);
  CHECK(items[0].output == shop.scratch.path("out/a.nc"));
  CHECK(items[1].output == shop.scratch.path("out/inner/b.nc"));
  CHECK(items[0].state == State::done);
  CHECK(shop.scratch.text("out/a.nc").find(std::string("plumbline ") + std::string(version())) != std::string::npos);
  CHECK(items[0].summary.find("\"program_hash\":\"") != std::string::npos);
}

TEST_CASE("batch: what has not changed stays as it is, to the number of its file") {
  const Shop shop;
  shop.run();
  const auto before = file_state(shop.scratch.path("out/a.nc"));
  const auto items = shop.run();
  CHECK(items[0].state == State::unchanged);
  CHECK(items[1].state == State::unchanged);
  CHECK(items[0].summary.find("compensation 1") != std::string::npos);
  CHECK(file_state(shop.scratch.path("out/a.nc")) == before);
}

TEST_CASE("batch: a program, a setting, an output: each that changes makes the output anew") {
  const Shop shop;
  shop.run();
  shop.scratch.file("parts/a.nc", std::string(kPart) + "(more)\n");
  auto items = shop.run();
  CHECK(items[0].state == State::done);
  CHECK(items[1].state == State::unchanged);
  shop.scratch.file("out/a.nc", "something else\n");
  CHECK(shop.run()[0].state == State::done);
  std::filesystem::remove(shop.scratch.path("out/inner/b.nc"));
  CHECK(shop.run()[1].state == State::done);
  const std::string settings = shop.scratch.text("parts/plumbline.toml");
  shop.scratch.file("parts/plumbline.toml", "step_length = 0.5\n" + settings);
  items = shop.run();
  CHECK(items[0].state == State::done);
  CHECK(items[1].state == State::done);
}

TEST_CASE("batch: files that look new and hold the same are no reason to make anything") {
  const Shop shop;
  shop.run();
  const std::string text = shop.scratch.text("parts/a.nc");
  std::filesystem::remove(shop.scratch.path("parts/a.nc"));
  shop.scratch.file("parts/a.nc", text);
  CHECK(shop.run()[0].state == State::unchanged);
}

TEST_CASE("batch: a program that is refused does not end the others, and an old output is named") {
  const Shop shop;
  shop.run();
  shop.scratch.file("parts/a.nc", "G0 X0 Y0 Z0 A0 B0 C0\nG1 X1 X2 F100\n");
  shop.scratch.file("parts/inner/b.nc", "G0 X0 Y0 Z0 A0 B0 C0\nG1 X8 F500\nM2\n");
  const auto items = shop.run();
  CHECK(items[0].state == State::done);
  CHECK(items[1].state == State::failed);
  REQUIRE(items[1].diagnostics.size() == 2);
  CHECK(items[1].diagnostics[0].code == "nc-word-twice");
  CHECK(items[1].diagnostics[0].place.line == 2);
  CHECK(items[1].diagnostics[1].code == "batch-old-output");
}

TEST_CASE("batch: a subprogram that others call is no failure, and its change makes them anew") {
  const Shop shop;
  shop.scratch.file("parts/plumbline.toml", "dialect = \"fanuc\"\n" + shop.scratch.text("parts/plumbline.toml"));
  shop.scratch.file("parts/a.nc", "O1\nG90 G21 G94\nG0 X0. Y0. Z0. A0. B0. C0.\nM98 P1000\nM30\n");
  shop.scratch.file("parts/O1000.nc", "O1000\nG1 X5. F500.\nM99\n");
  shop.scratch.file("parts/inner/b.nc", "O2\nG90 G21 G94\nG0 X0. Y0. Z0. A0. B0. C0.\nG1 X5. F500.\nM30\n");
  auto items = shop.run();
  REQUIRE(items.size() == 3);
  CHECK(items[2].program == shop.scratch.path("parts/O1000.nc"));
  CHECK(items[2].state == State::subprogram);
  items = shop.run();
  CHECK(items[0].state == State::unchanged);
  CHECK(items[2].state == State::subprogram);
  shop.scratch.file("parts/O1000.nc", "O1000\nG1 X6. F500.\nM99\n");
  items = shop.run();
  CHECK(items[0].state == State::done);
  CHECK(items[1].state == State::unchanged);
}

TEST_CASE("batch: outputs of compensate beside their programs are passed over, others with a warning") {
  const Shop shop;
  shop.run();
  const std::string compensated = shop.scratch.text("out/a.nc");
  shop.scratch.file("parts/a_straight.nc", compensated);
  shop.scratch.file("parts/inner/lost.nc", compensated);
  const auto of = [&](const std::vector<jobs::BatchItem>& items, const char* place) {
    return *std::find_if(items.begin(), items.end(),
                         [&](const jobs::BatchItem& item) { return item.program == shop.scratch.path(place); });
  };
  auto items = shop.run();
  REQUIRE(items.size() == 4);
  CHECK(of(items, "parts/a_straight.nc").state == State::compensated);
  CHECK(of(items, "parts/a_straight.nc").diagnostics.empty());
  const jobs::BatchItem lost = of(items, "parts/inner/lost.nc");
  CHECK(lost.state == State::compensated);
  REQUIRE(lost.diagnostics.size() == 1);
  CHECK(lost.diagnostics[0].severity == Severity::warning);
  CHECK_FALSE(shop.scratch.has("out/a_straight.nc"));
  const batch::Result result = batch::run(shop.request(), {});
  CHECK(result.summary.compensated == 2);
  CHECK(result.summary.failed == 0);

  // By the name that the settings give it.
  shop.scratch.file("parts/inner/hex_a.nc", compensated);
  shop.scratch.file("parts/plumbline.toml",
                    "output_name = \"{folder}/inner/hex_{name}{ext}\"\n" + shop.scratch.text("parts/plumbline.toml"));
  items = shop.run();
  CHECK(of(items, "parts/inner/hex_a.nc").diagnostics.empty());
  CHECK(of(items, "parts/a_straight.nc").diagnostics.size() == 1);
}

TEST_CASE("batch: a program that is compensated now, and was not before, leaves an output that is named") {
  const Shop shop;
  shop.run();
  shop.scratch.file("parts/a.nc", shop.scratch.text("out/a.nc"));
  const auto items = shop.run();
  REQUIRE(items.size() == 2);
  CHECK(items[1].state == State::failed);
  REQUIRE(items[1].diagnostics.size() == 2);
  CHECK(items[1].diagnostics[0].code == "compensate-stamped");
  CHECK(items[1].diagnostics[1].code == "batch-old-output");
}

#ifndef _WIN32
TEST_CASE("batch: what is not looked at is named: links, programs among the outputs") {
  const Shop shop;
  std::filesystem::create_directories(shop.scratch.path("far"));
  shop.scratch.file("far/f.nc", kPart);
  std::filesystem::create_directory_symlink(shop.scratch.path("far"), shop.scratch.path("parts/link"));
  std::filesystem::create_symlink("nowhere.nc", shop.scratch.path("parts/broken.nc"));
  std::filesystem::create_directories(shop.scratch.path("parts/out"));
  shop.scratch.file("parts/out/b.nc", kPart);
  batch::Request request = shop.request();
  request.programs.output = shop.scratch.path("parts/out");
  for (int round = 0; round < 2; ++round) {
    const batch::Result result = batch::run(request, {});
    CHECK(result.summary.passed_over ==
          std::vector<std::string>{shop.scratch.path("parts/broken.nc"), shop.scratch.path("parts/link"),
                                   shop.scratch.path("parts/notes.txt"), shop.scratch.path("parts/plumbline.toml")});
    CHECK(result.summary.among_outputs == std::vector<std::string>{shop.scratch.path("parts/out/b.nc")});
    CHECK(result.summary.failed == 0);
  }
}

#endif

TEST_CASE("batch: a program does not take the place of another one's output while that is there") {
  const Shop shop;
  shop.run();
  std::filesystem::create_directories(shop.scratch.path("others"));
  shop.scratch.file("others/a.nc", "G0 X0 Y0 Z0 A0 B0 C0\nG1 X9 F500\nM2\n");
  batch::Request request = shop.request();
  request.programs.folder = shop.scratch.path("others");
  const std::string output = shop.scratch.text("out/a.nc");
  auto items = Shop::run(request);
  REQUIRE(items.size() == 1);
  CHECK(items[0].diagnostics[0].code == "batch-other-source");
  CHECK(items[0].diagnostics.size() == 1);
  CHECK(shop.scratch.text("out/a.nc") == output);
  std::filesystem::remove(shop.scratch.path("parts/a.nc"));  // moved, say
  items = Shop::run(request);
  CHECK(items[0].state == State::done);
}

TEST_CASE("batch: a list may name a program in two ways, begin with a mark, and name no pipe") {
  const Shop shop;
  batch::Request request = shop.request();
  const std::string name = shop.scratch.path("parts/a.nc");
  request.programs.list = shop.scratch.path("list");
  shop.scratch.file("list", "\xEF\xBB\xBF" + name + "\n" + shop.scratch.path("parts/./inner/../a.nc") + "\n");
  CHECK(Shop::run(request).size() == 1);
  const auto items = Shop::run(request);
  REQUIRE(items.size() == 1);
  CHECK(items[0].state == State::unchanged);
#ifndef _WIN32
  REQUIRE(mkfifo(shop.scratch.path("parts/p.nc").c_str(), 0600) == 0);
  shop.scratch.file("list", shop.scratch.path("parts/p.nc") + "\n");
  CHECK(Shop::run(request)[0].diagnostics[0].code == "batch-no-file");
#endif
}

TEST_CASE("batch: nothing of the user's is written over") {
  const Shop shop;
  batch::Request request = shop.request();
  request.programs.output = shop.scratch.path("parts/inner/..");
  CHECK(refusal_of([&] { Shop::run(request); }).code == "file-overwrites-input");
  std::filesystem::create_directories(shop.scratch.path("out"));
  shop.scratch.file("out/a.nc", "G0 X1\n");
  const auto items = shop.run();
  CHECK(items[1].state == State::failed);
  CHECK(items[1].diagnostics[0].code == "file-exists");
  CHECK(shop.scratch.text("out/a.nc") == "G0 X1\n");
}

TEST_CASE("batch: outputs among the programs' folders are no programs, and two may not have one name") {
  const Shop shop;
  batch::Request request = shop.request();
  request.programs.output = shop.scratch.path("parts/out");
  CHECK(Shop::run(request).size() == 2);
  CHECK(Shop::run(request).size() == 2);
  shop.scratch.file("parts/a.tap", kPart);
  shop.scratch.file("parts/plumbline.toml",
                    "output_name = \"{folder}/{name}.ngc\"\n" + shop.scratch.text("parts/plumbline.toml"));
  const auto items = Shop::run(request);
  REQUIRE(items.size() == 3);
  CHECK(items[0].output == shop.scratch.path("parts/out/a.ngc"));
  CHECK(items[2].diagnostics[0].code == "file-written-twice");
}

TEST_CASE("batch: an output whose program is gone is named") {
  const Shop shop;
  shop.run();
  std::filesystem::remove(shop.scratch.path("parts/a.nc"));
  const batch::Result result = batch::run(shop.request(), {});
  CHECK(result.summary.vanished == std::vector<std::string>{shop.scratch.path("out/a.nc")});
  CHECK(result.summary.unchanged == 1);
  CHECK(result.summary.passed_over ==
        std::vector<std::string>{shop.scratch.path("parts/notes.txt"), shop.scratch.path("parts/plumbline.toml")});
}

TEST_CASE("batch: where no model is named each program says so") {
  const Shop shop;
  shop.scratch.file("parts/plumbline.toml", "plumbline = \"settings 1\"\n");
  const auto items = shop.run();
  REQUIRE(items.size() == 2);
  CHECK(items[0].diagnostics[0].code == "settings-no-model");
}

TEST_CASE("batch: what was read can be told") {
  const Shop shop;
  const batch::Result result = batch::run(shop.request(), {});
  for (const char* const name : {"parts", "parts/a.nc", "parts/inner/b.nc", "parts/plumbline.toml"}) {
    CHECK(std::count(result.files_read.begin(), result.files_read.end(), shop.scratch.path(name)) == 1);
  }
  CHECK(result.tables_read.contains(source_file("models/pm600-like.toml")));
}
