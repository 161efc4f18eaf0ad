#include "jobs/new_model/hal_file.hpp"

#include <catch2/catch.hpp>

#include "support/scratch.hpp"

using namespace plumbline;
using namespace plumbline::jobs;

namespace {

HalPins pins_of(const testing::Scratch& scratch, const std::string& hal, const std::string& ini = "") {
  return read_hal({scratch.file("a.hal", hal)}, read_ini(scratch.file("a.ini", ini)), "genhexkins.");
}

double value(const HalPins& pins, const std::string& name) {
  const HalPin* const pin = pins.find("genhexkins." + name);
  REQUIRE(pin != nullptr);
  return pin->value;
}

}  // namespace

TEST_CASE("setp sets a pin: by a number, over two lines, as an equation, from the INI file") {
  const testing::Scratch scratch;
  const HalPins pins = pins_of(scratch,
                               "setp genhexkins.base.0.x -22.950 # inch\nsetp  genhexkins.base.0.y \\\n  13.25\n"
                               "genhexkins.base.0.z = 1e-1\nsetp genhexkins.base.1.x [HEXA]X1\n"
                               "setp genhexkins.base.1.y [HEXA](Y1)\nsetp other.pin 3\n# setp genhexkins.base.2.x 9\n",
                               "[HEXA]\nX1 = 5\nY1 = 6.5\n");
  CHECK(value(pins, "base.0.x") == -22.95);
  CHECK(value(pins, "base.0.y") == 13.25);
  CHECK(value(pins, "base.0.z") == 0.1);
  CHECK(value(pins, "base.1.x") == 5);
  CHECK(value(pins, "base.1.y") == 6.5);
  CHECK(pins.pins.size() == 5);
  CHECK(pins.find("genhexkins.base.0.y")->place.line == 3);
  CHECK(pins.find("genhexkins.base.0.y")->place.column == 3);
}

TEST_CASE("the INI file names HAL files and commands; sourced files are read, Tcl is not") {
  const testing::Scratch scratch;
  scratch.file("one.hal", "source two.hal\n");
  scratch.file("two.hal", "setp genhexkins.base.0.x 1\n");
  scratch.file("post.hal", "setp genhexkins.base.0.z 3\n");
  const IniFile ini =
      read_ini(scratch.file("a.ini",
                            "[HAL]\nHALFILE = LIB:basic_sim.tcl\nHALFILE = one.hal\nHALFILE = my.tcl -x\nHALCMD = setp "
                            "genhexkins.base.0.y 2\nHALCMD = loadusr -W hexagui\nPOSTGUI_HALFILE = post.hal\n"));
  const HalPins pins = read_hal({}, ini, "genhexkins.");
  CHECK(value(pins, "base.0.x") == 1);
  CHECK(value(pins, "base.0.y") == 2);
  CHECK(value(pins, "base.0.z") == 3);
  CHECK(pins.files.size() == 3);
  CHECK(pins.other_files == std::vector<std::string>{"LIB:basic_sim.tcl", "my.tcl"});
}

TEST_CASE("pins that say nothing certain are refused") {
  const testing::Scratch scratch;
  const auto refused = [&](const std::string& hal) { return testing::refusal_of([&] { pins_of(scratch, hal); }); };
  const Diagnostic comma = refused("\nsetp genhexkins.base.0.x -22,95\n");
  CHECK(comma.code == "draft-number");
  CHECK(comma.place.line == 2);
  CHECK(comma.place.column == 26);
  const Diagnostic twice = refused("setp genhexkins.base.0.x 1\nsetp genhexkins.base.0.x 2\n");
  CHECK(twice.code == "draft-contradiction");
  CHECK(twice.place.line == 2);
  CHECK(twice.message.find("a.hal:1") != std::string::npos);
  CHECK(refused("setp genhexkins.base.0.x 1\nsetp genhexkins.base.0.x 1.0\n").code.empty());
  CHECK(refused("net x genhexkins.base.0.x\n").code == "draft-signal");
  CHECK(refused("net tool-offset genhexkins.tool-offset motion.tooloffset.z\n").code.empty());
  CHECK(refused("setp genhexkins.base.0.x [HEXA]X\n").code == "draft-missing");
  CHECK(refused("source nowhere.hal\n").code == "draft-file");
  CHECK(refused("source a.hal\n").message.find("without end") != std::string::npos);
}
