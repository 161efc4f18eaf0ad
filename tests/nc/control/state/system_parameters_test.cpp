// Also named_parameters.cpp, whose names it reads: tests/nc/programs/named_parameters.ngc and names_of_*.ngc have all
// of them, beside what LinuxCNC makes of them.
#include "nc/control/state/system_parameters.hpp"

#include <utility>

#include <catch2/catch.hpp>

#include "nc/syntax/parsed.hpp"
#include "support/scratch.hpp"

using namespace plumbline;
using namespace plumbline::nc;
using nc::tests::Parsed;

namespace {

// A control, and a block that reads its parameters.
struct ReadControl {
  explicit ReadControl(std::string_view name = "linuxcnc", ProgramSettings how = {})
      : parsed("G0 X12", name),
        settings(std::move(how)),
        control(dialect(name), settings),
        parameters(control, settings, dialect(name)) {}
  ReadControl(const ReadControl&) = delete;
  template <class What>
  Value read(const What& what) {
    return parameters.read(parsed.block, what, {4, 6});
  }
  template <class What>
  std::string refusal(const What& what) {
    return testing::refusal_of([&] { read(what); }).code;
  }
  Parsed parsed;
  ProgramSettings settings;
  Control control;
  SystemParameters parameters;
};

ProgramSettings with_empty_tables() {
  ProgramSettings settings;
  settings.as_with_empty_tables = true;
  return settings;
}

ProgramSettings with_readable_position() {
  ProgramSettings settings;
  settings.position_may_be_read = true;
  return settings;
}

}  // namespace

TEST_CASE("a program may set the parameters that are no tables of the control") {
  const ReadControl linuxcnc;
  for (const int number : {1, 31, 5000, 5160, 5170, 5180, 5190, 5200, 5231, 5240, 5251, 5391, 5414, 5419, 5429, 5500})
    CHECK_FALSE(linuxcnc.parameters.is_read_only(number));
  for (const int number : {5161, 5169, 5181, 5189, 5210, 5220, 5221, 5230, 5241, 5250, 5390, 5400, 5413, 5420, 5428}) {
    INFO(number);
    CHECK(linuxcnc.parameters.is_read_only(number));
  }
  const ReadControl fanuc("fanuc");
  for (const int number : {1, 33, 100, 199, 500, 999, 3000, 3003, 3004, 3006}) {
    INFO(number);
    CHECK_FALSE(fanuc.parameters.is_read_only(number));
  }
  for (const int number : {34, 99, 200, 499, 1000, 3001, 5041, 5221}) CHECK(fanuc.parameters.is_read_only(number));
  CHECK_FALSE(ReadControl("siemens").parameters.is_read_only(5221));
}

TEST_CASE("parameters begin with 1 or 0 and end where the control has no more") {
  CHECK(ReadControl().parameters.limits().first == 1);
  CHECK(ReadControl("fanuc").parameters.limits().first == 0);
  CHECK(ReadControl("okuma").parameters.limits().last == 200);
  CHECK(ReadControl("siemens").parameters.limits().last == 999);
}

TEST_CASE("where the axes of macro B are is read by who only looks") {
  ReadControl locked("fanuc");
  locked.control.known = AxisSet::all();
  CHECK(locked.refusal(5041) == "nc-position-read");
  ReadControl read("fanuc", with_readable_position());
  read.control.known = AxisSet::all();
  read.control.position = {{50.8, 0, 0, 30, 0, 0}};
  CHECK(read.read(5041).number == 50.8);
  read.control.frame.tool[Axis::Z] = 100;  // #5041 and on have it in them, #5001 and on have not
  CHECK(read.refusal(5041) == "nc-not-interpreted");
  CHECK(read.read(5001).number == 50.8);
  CHECK(read.read(5044).number == 30);
}

TEST_CASE("where a program of RS274/NGC has put the control is read, in the unit of the program") {
  ReadControl read;
  CHECK(read.refusal(5420) == "nc-position-unknown");
  CHECK_FALSE(read.control.position_read);
  read.control.known = AxisSet{Axis::X, Axis::A};
  read.control.position = {{50.8, 0, 0, 30, 0, 0}};
  CHECK(read.read(5420).number == 50.8);
  CHECK(read.read("_x").number == 50.8);
  read.control.modal.inches = true;
  CHECK(read.read(5420).number == Approx(2));
  CHECK(read.read(5423).number == 30);
  CHECK(read.refusal(5421) == "nc-position-unknown");
}

TEST_CASE("the display of the machine holds every offset, and an axis that is turned needs the other") {
  ReadControl read("linuxcnc", with_readable_position());
  read.control.known = AxisSet{Axis::X, Axis::Z};
  read.control.position = {{1, 2, 3, 0, 0, 0}};
  read.control.frame.origin = {{10, 20, 30, 0, 0, 0}};
  read.control.frame.tool[Axis::Z] = 100;
  CHECK(read.read("_abs_x").number == 11);
  CHECK(read.read("_abs_z").number == 133);
  read.control.frame.rotation_deg = 90;
  CHECK(read.refusal("_abs_x") == "nc-position-unknown");
  read.control.known.insert(Axis::Y);
  CHECK(read.read("_abs_x").number == Approx(8));  // 10 - 2
  read.control.modal.inches = true;                // the length of the tool is taken for inches then
  CHECK(read.refusal("_abs_z") == "nc-not-interpreted");
}

TEST_CASE("the tables of LinuxCNC are read as far as somebody gave them") {
  ReadControl read;
  CHECK(read.refusal(5221) == "nc-parameter-unset");
  CHECK(read.refusal(5161) == "nc-parameter-unset");
  CHECK(read.refusal(5211) == "nc-parameter-unset");
  CHECK(read.read(5220).number == 1);
  read.control.modal.work_system = 9;
  CHECK(read.read(5220).number == 9);
  read.control.systems[1] = {{{1, 2, 3, 4, 5, 6}}, 45, AxisSet{Axis::Y}};
  CHECK(read.read(5242).number == 2);
  CHECK(read.refusal(5241) == "nc-parameter-unset");
  CHECK(read.read(5250).number == 45);  // its rotation
  read.control.homes[1] = {{{7, 8, 9, 0, 0, 0}}, AxisSet::all()};
  CHECK(read.read(5183).number == 9);
  read.control.g92.known = true;
  read.control.g92.applied = true;
  read.control.g92.suspended[Axis::C] = 15;
  CHECK(read.read(5210).number == 1);
  CHECK(read.read(5216).number == 15);
  CHECK(ReadControl("linuxcnc", with_empty_tables()).read(5221).number == 0);
}

TEST_CASE("what was never set is refused, zero with empty tables, and vacant where the language has that") {
  ReadControl linuxcnc;
  CHECK(linuxcnc.refusal(31) == "nc-parameter-unset");
  CHECK(linuxcnc.refusal("depth") == "nc-parameter-unset");
  linuxcnc.control.parameters.set(31, {2.5, true});
  CHECK(linuxcnc.read(31).number == 2.5);
  CHECK(linuxcnc.refusal(5400) == "nc-tool-unknown");
  ReadControl fanuc("fanuc");
  CHECK(fanuc.read(0).vacant);
  CHECK(fanuc.read(33).vacant);
  CHECK(fanuc.refusal(100) == "nc-parameter-unset");
  CHECK(fanuc.refusal(1000) == "nc-not-interpreted");
  CHECK_FALSE(fanuc.read(3011).known);  // the date
  CHECK(ReadControl("fanuc", with_empty_tables()).read(100).vacant);
  ReadControl siemens("siemens");
  CHECK(siemens.refusal(5) == "nc-parameter-unset");
  CHECK_FALSE(ReadControl("siemens", with_empty_tables()).read(5).vacant);
}

TEST_CASE("macro B reads the offsets and the end of the block in the unit of the program") {
  ReadControl fanuc("fanuc", with_readable_position());
  CHECK(fanuc.refusal(5222) == "nc-parameter-unset");
  fanuc.control.systems[1] = {{{25.4, 0, 0, 90, 0, 0}}, 0, AxisSet::all()};
  CHECK(fanuc.read(5241).number == 25.4);
  fanuc.control.modal.inches = true;
  CHECK(fanuc.read(5241).number == Approx(1));
  CHECK(fanuc.read(5244).number == 90);
  fanuc.control.known = AxisSet::all();
  fanuc.control.position[Axis::Y] = 50.8;
  CHECK(fanuc.read(5002).number == Approx(2));
  CHECK(fanuc.read(5042).number == Approx(2));
}

TEST_CASE("names of the control show its modes and are read only") {
  ReadControl read;
  CHECK(read.read("_metric").number == 1);
  read.control.modal.inches = true;
  CHECK(read.read("_metric").number == 0);
  CHECK(read.read("_ Imperial").number == 1);
  read.control.modal.plane = Plane::zx;
  CHECK(read.read("_plane").number == 180);
  read.control.modal.work_system = 7;
  CHECK(read.read("_coord_system").number == 591);  // G59.1
  CHECK(read.read("_call_level").number == 0);
  CHECK_FALSE(read.read("_current_pocket").known);
  CHECK(read.parameters.is_read_only("_METRIC"));
  CHECK_FALSE(read.parameters.is_read_only("metric"));
  CHECK_FALSE(ReadControl("fanuc").parameters.is_read_only(1));
}

TEST_CASE("a name exists that the control or the program made; one that others keep may") {
  ReadControl read;
  CHECK(read.parameters.exists({}, "_metric", {}).number == 1);
  CHECK(read.parameters.exists({}, "depth", {}).number == 0);
  CHECK(read.parameters.exists({}, "depth", {}).known);
  CHECK_FALSE(read.parameters.exists({}, "_depth", {}).known);
  read.control.parameters.set("depth", {3, true});
  CHECK(read.parameters.exists({}, "Depth", {}).number == 1);
  CHECK(ReadControl("linuxcnc", with_empty_tables()).parameters.exists({}, "_depth", {}).known);
}
