// The numbered parameters of a control, from a file.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/files/source.hpp"
#include "nc/sequence/program.hpp"

namespace plumbline::settings {

/// Lines "#NUMBER VALUE", "#NUMBER = VALUE", "RNUMBER VALUE" or "NUMBER VALUE" (what LinuxCNC keeps as .var); blank
/// lines and what follows ; are left out. Values are taken as they stand: lengths in mm, angles in deg. Refuses with
/// variables-line, variables-number, variables-value or variables-twice and the place.
std::map<int, double> read_variables(const Source& source);

/// A variable that holds part of a work offset.
struct OffsetVariable {
  int number = 0;
  std::optional<Axis> axis;  // none: it is the rotation
  double value = 0;
};

/// Those of work system 1 (G54) to 9 (G59.3) that are given; of others none.
std::vector<OffsetVariable> offset_variables(int system, const std::map<int, double>& variables);

/// The work systems that the variables state whole: #5221 to #5226 for G54 with its rotation #5230, then every
/// twenty. [RS274/NGC 3.2.1]
std::array<std::optional<nc::WorkOffset>, nc::kWorkSystems> work_offsets_of(const std::map<int, double>& variables);

}  // namespace plumbline::settings
