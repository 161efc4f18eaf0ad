#include "batch/work.hpp"

#include <catch2/catch.hpp>

#include "batch/shop.hpp"

using namespace plumbline;
using namespace plumbline::testing;

TEST_CASE("the output of a program waits, and its entry says what it is made from") {
  const Shop shop;
  std::filesystem::create_directories(shop.scratch.path("out"));
  batch::SettingsByFolder settings(shop.request().settings);
  const batch::Task task{3, shop.scratch.path("parts/a.nc"), "a.nc", shop.scratch.path("out/a.nc")};
  const batch::Work work = batch::compensate_one(task, settings.of(task.program), std::nullopt);
  CHECK(work.item.state == State::done);
  REQUIRE(work.output);
  CHECK_FALSE(work.undo);
  CHECK_FALSE(shop.scratch.has("out/a.nc"));
  CHECK(work.entry.place == "a.nc");
  CHECK(work.entry.dialect == "linuxcnc");
  CHECK(work.entry.program.hash == file_hash(task.program));
  CHECK(work.entry.settings == settings.of(task.program).hash);
  CHECK(work.item.summary.find('\n') == std::string::npos);
}

TEST_CASE("what a program calls is known, and so is what is not there") {
  const Shop shop;
  std::filesystem::create_directories(shop.scratch.path("out"));
  shop.scratch.file("parts/a.nc", "O1\nG90 G21 G94\nG0 X0. Y0. Z0. A0. B0. C0.\nM98 P1000\nM30\n");
  shop.scratch.file("parts/O1000.nc", "O1000\nG1 X5. F500.\nM99\n");
  shop.scratch.file("parts/plumbline.toml", "dialect = \"fanuc\"\n" + shop.scratch.text("parts/plumbline.toml"));
  batch::SettingsByFolder settings(shop.request().settings);
  const batch::Task task{0, shop.scratch.path("parts/a.nc"), "a.nc", shop.scratch.path("out/a.nc")};
  const batch::Work work = batch::compensate_one(task, settings.of(task.program), std::nullopt);
  REQUIRE(work.entry.called.size() == 1);
  CHECK(work.entry.called[0].path == "O1000.nc");
  CHECK(work.entry.called[0].file.hash == file_hash(shop.scratch.path("parts/O1000.nc")));
}

TEST_CASE("whatever is thrown on behalf of a program is a message about it") {
  const auto problem = [](const auto& thrown) {
    try {
      throw thrown;
    } catch (...) {
      return batch::current_problem("a.nc");
    }
  };
  CHECK(problem(std::bad_alloc()).code == "out-of-memory");
  CHECK(problem(std::runtime_error("odd")).code == "internal-error");
  CHECK(problem(std::system_error(EAGAIN, std::generic_category())).code == "system-refused");
  CHECK(problem(Refusal({"x-y", "", "", {}, Severity::error})).code == "x-y");
  CHECK(problem(std::bad_alloc()).place.file == "a.nc");
}
