#include "jobs/new_model/ini_file.hpp"

#include <catch2/catch.hpp>

#include "support/scratch.hpp"

using namespace plumbline;
using namespace plumbline::jobs;

TEST_CASE("an INI file is sections, keys and values; the first of a name counts") {
  const testing::Scratch scratch;
  const IniFile ini = read_ini(scratch.file("a.ini",
                                            "# a comment\r\n[TRAJ]\r\n  HOME =  1 2.5  -3 # mm\r\nHOME = 9\n\n;\n"
                                            "[JOINT_0]\nHOME=4\n"));
  REQUIRE(ini.find("TRAJ", "HOME") != nullptr);
  CHECK(numbers_of(*ini.find("TRAJ", "HOME")) == std::vector<double>{1, 2.5, -3});
  CHECK(ini.find("TRAJ", "HOME")->place.line == 3);
  CHECK(ini.find("TRAJ", "HOME")->place.column == 11);
  CHECK(ini.find("JOINT_0", "HOME")->value == "4");
  CHECK(ini.find("JOINT_1", "HOME") == nullptr);
  CHECK(ini.entries.size() == 3);
}

TEST_CASE("other files are included, from where the including file lies") {
  const testing::Scratch scratch;
  std::filesystem::create_directory(scratch.path("sub"));
  scratch.file("sub/inner.inc", "HOME = 7\n");
  const std::string outer = scratch.file("a.ini", "[TRAJ]\n#INCLUDE sub/inner.inc\n");
  const IniFile ini = read_ini(outer);
  REQUIRE(ini.find("TRAJ", "HOME") != nullptr);
  CHECK(ini.find("TRAJ", "HOME")->place.file.ends_with("inner.inc"));

  const Diagnostic missing =
      testing::refusal_of([&] { read_ini(scratch.file("b.ini", "[A]\n#INCLUDE nowhere.inc\n")); });
  CHECK(missing.code == "draft-file");
  CHECK(missing.place.line == 2);
  const Diagnostic endless = testing::refusal_of([&] { read_ini(scratch.file("c.ini", "#INCLUDE c.ini\n")); });
  CHECK(endless.code == "draft-file");
  CHECK(endless.message.find("without end") != std::string::npos);
}

TEST_CASE("what is no line of an INI file is refused where it stands") {
  const testing::Scratch scratch;
  const Diagnostic section = testing::refusal_of([&] { read_ini(scratch.file("a.ini", "\n[TRAJ\n")); });
  CHECK(section.code == "draft-syntax");
  CHECK(section.place.line == 2);
  const Diagnostic line = testing::refusal_of([&] { read_ini(scratch.file("a.ini", "[TRAJ]\n HOME 0 0 20\n")); });
  CHECK(line.code == "draft-syntax");
  CHECK(line.place.column == 2);
}

TEST_CASE("what is no number is underlined") {
  const testing::Scratch scratch;
  const IniFile ini = read_ini(scratch.file("a.ini", "[TRAJ]\nHOME = 1 2,5 3\nEMPTY =\n"));
  const Diagnostic comma = testing::refusal_of([&] { numbers_of(*ini.find("TRAJ", "HOME")); });
  CHECK(comma.code == "draft-number");
  CHECK(comma.place.column == 10);
  CHECK(comma.place.length == 3);
  CHECK(testing::refusal_of([&] { numbers_of(*ini.find("TRAJ", "EMPTY")); }).code == "draft-number");
}
