// What was learnt of an effect that no catalogue has, in words.
#pragma once

#include <string>
#include <vector>

#include "diagnose/diagnose.hpp"

namespace plumbline::report {

/// "length of strut 3, as a function of its length: -2.1 +- 0.3 um at 1.05 m to +6.0 +- 0.4 um at 1.4 m"
std::string function_text(const diagnose::LearntFunction& function, const physics::MachineConstants& machine);
/// All of a diagnosis, a line each.
std::vector<std::string> function_lines(const diagnose::Diagnosis& diagnosis);

/// "length of strut 3"
std::string function_name(const diagnose::LearntFunction& function);
/// A coordinate of a function as people count it, and its value there.
struct ShownCoordinate {
  std::string_view name, unit;
  double scale = 1;
  double offset = 0;

  double value(double coordinate) const { return offset + scale * coordinate; }
};
ShownCoordinate shown_coordinate(const diagnose::LearntFunction& function, std::size_t dimension,
                                 const physics::MachineConstants& machine);
/// The unit of its values, and SI per unit.
struct ShownUnit {
  std::string_view name;
  double si = 1;
};
ShownUnit shown_unit(const diagnose::LearntFunction& function);

}  // namespace plumbline::report
