// Circular tests that are to be made, drawn in the machine, each with its NC program.
#pragma once

#include <string>
#include <vector>

#include "machine/model.hpp"
#include "measure/dataset.hpp"
#include "report/page/page.hpp"

namespace plumbline::report {

struct ShownTest {
  std::string name;
  measure::Run run;     // its design
  std::string note;     // what it is for
  std::string program;  // NC
};
Json tests_section(std::string title, const machine::MachineModel& machine, const std::vector<ShownTest>& tests);

}  // namespace plumbline::report
