#include "nc/control/state/control.hpp"

#include <catch2/catch.hpp>

using namespace plumbline;
using namespace plumbline::nc;

TEST_CASE("the work system that the variables say is in force is at the start") {
  ProgramSettings settings;
  settings.work_offsets[1] = WorkOffset{};
  settings.work_offsets[1]->origin[Axis::X] = 10;
  for (const double system : {2.0, 9.0}) {
    settings.variables = {{5220, system}};
    CHECK(Control(dialect("linuxcnc"), settings).modal.work_system == static_cast<int>(system));
    CHECK(Control(dialect("fanuc"), settings).modal.work_system == 1);
  }
  settings.variables = {{5220, 2.0}};
  CHECK(Control(dialect("linuxcnc"), settings).frame.origin[Axis::X] == 10);
  for (const double none : {0.0, 10.0, 1.5}) {
    settings.variables = {{5220, none}};
    CHECK(Control(dialect("linuxcnc"), settings).modal.work_system == 1);
  }
}
