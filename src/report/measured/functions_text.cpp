#include "report/measured/functions_text.hpp"

#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/units.hpp"
#include "physics/generic_formula.hpp"

namespace plumbline::report {
namespace {

using Channel = diagnose::Term::Channel;
using diagnose::LearntFunction;
using namespace diagnose::coordinates;

// As physics::Residual counts coordinates, from 1.
constexpr std::array<ShownCoordinate, 14> kCoordinates{{{"x", "mm", 100},
                                                        {"y", "mm", 100},
                                                        {"z", "mm", 100, -1000},
                                                        {"z_x", ""},
                                                        {"z_y", ""},
                                                        {"time", "h"},
                                                        {"length", "m", diagnose::kCoordinateLength},
                                                        {"speed", "mm/s", 10},
                                                        {"direction", ""},
                                                        {"tension", "kN"},
                                                        {"tension, whatever its sign", "kN"},
                                                        {"u_x", ""},
                                                        {"u_y", ""},
                                                        {"u_z", ""}}};

std::string value_text(const LearntFunction& function, const diagnose::FunctionValue& value,
                       const physics::MachineConstants& machine) {
  const ShownUnit unit = shown_unit(function);
  std::vector<std::string> at;
  for (std::size_t d = 0; d < value.at.size(); ++d) {
    const ShownCoordinate shown = shown_coordinate(function, d, machine);
    const std::string_view gap = shown.unit.empty() ? "" : " ";
    at.push_back(value.at.size() == 1
                     ? fmt::format("{:.4g}{}{}", shown.value(value.at[d]), gap, shown.unit)
                     : fmt::format("{} = {:.4g}{}{}", shown.name, shown.value(value.at[d]), gap, shown.unit));
  }
  return fmt::format("{:+.3g} +- {:.2g} {} at {}", value.value / unit.si, value.sigma / unit.si, unit.name,
                     fmt::join(at, ", "));
}

// Laws that have a name: by what a length depends on, and its power.
struct NamedLaw {
  int coordinate;  // of diagnose::coordinates
  double exponent;
  std::string_view says;
};
constexpr std::array<NamedLaw, 3> kNamedLaws{
    {{kTension, 2.0 / 3, "the exponent of Hertz's contacts, which give way at their balls or rollers"},
     {kTension, 2, "the exponent of a compliance that changes with the load"},
     {kLength, 2, "the exponent of what changes with the square of a strut's length"}}};

constexpr double kSameExponent = 0.02;  // functions come no nearer to a power whose slope has no bound

std::string_view name_of(const diagnose::PowerLaw& law, int coordinate) {
  for (const NamedLaw& named : kNamedLaws) {
    const bool is_it = named.exponent > law.least - kSameExponent && named.exponent < law.most + kSameExponent;
    if (named.coordinate == coordinate && is_it) return named.says;
  }
  return "";
}

// What the power is taken of, with its sign.
std::string_view base_text(int coordinate) {
  switch (coordinate) {
    case kTension:
      return "sign(t) |t / kN|";
    case kSpeed:
      return "sign(v) |v / (10 mm/s)|";
    default:
      return "(L / L_mid)";
  }
}

std::string law_text(const LearntFunction& function) {
  const diagnose::PowerLaw& law = *function.law;
  const int coordinate = function.shape.coordinates[0];
  const ShownUnit unit = shown_unit(function);
  const std::string formula =
      fmt::format("{:+.3g} +- {:.2g} {} x {}^{:.2f} (exponent {:.2f} to {:.2f} with 95 %)", law.size / unit.si,
                  law.size_sigma / unit.si, unit.name, base_text(coordinate), law.exponent, law.least, law.most);
  const bool length = function.shape.channel == Channel::length;
  const std::string_view name = length ? name_of(law, coordinate) : "";
  return fmt::format("; it is a power: {}{}{}", formula, name.empty() ? "" : ", ", name);
}

}  // namespace

ShownUnit shown_unit(const LearntFunction& function) {
  switch (function.shape.channel) {
    case Channel::length:
    case Channel::tip:
      return {"um", kUm};
    case Channel::torque:
      return {"N m", 1};
    case Channel::drive:
    case Channel::force:
    case Channel::centre:
      break;
  }
  return {"N", 1};
}

ShownCoordinate shown_coordinate(const LearntFunction& function, std::size_t dimension,
                                 const physics::MachineConstants& machine) {
  const auto place = static_cast<std::size_t>(function.shape.coordinates[dimension] - 1);
  ShownCoordinate shown = kCoordinates.at(place);
  if (function.shape.coordinates[dimension] == kLength)
    shown.offset = function.part < 0 ? machine.middle_length.mean() : machine.middle_length[function.part];
  return shown;
}

std::string function_name(const LearntFunction& function) {
  constexpr std::array<std::string_view, 6> kWhat{"length",           "drive tension", "torque reading",
                                                  "force at the tip", "tip",           "force at the centre of mass"};
  const std::string_view what = kWhat.at(static_cast<std::size_t>(function.shape.channel));
  if (!diagnose::is_per_strut(function.shape.channel))
    return fmt::format("{}, along {}", what,
                       std::string_view("xyz").substr(static_cast<std::size_t>(function.part), 1));
  if (function.part < 0) return fmt::format("{} of each strut", what);
  return fmt::format("{} of strut {}", what, function.part + 1);
}

std::string function_text(const LearntFunction& function, const physics::MachineConstants& machine) {
  if (!function.formula.empty()) {
    std::vector<std::string> lines;
    for (const diagnose::Term& term : function.formula)
      lines.push_back(physics::generic_formula(diagnose::generic_parameters(term)));
    return fmt::format("{}", fmt::join(lines, "\n"));
  }
  std::vector<std::string_view> of;
  for (std::size_t d = 0; d < function.shape.coordinates.size(); ++d)
    of.push_back(shown_coordinate(function, d, machine).name);
  const bool own = diagnose::is_per_strut(function.shape.channel);
  const std::string powers = physics::powers_formula(function.shape.strut_powers, function.shape.shared_powers);
  return fmt::format("{}, as a function of {}{}: {} to {}{}", function_name(function), own ? "its " : "",
                     fmt::join(of, own ? " and its " : ", "), value_text(function, function.least, machine),
                     value_text(function, function.most, machine), powers.empty() ? "" : "," + powers) +
         (function.mean_aside ? ", beside its mean" : "") + (function.law ? law_text(function) : "");
}

std::vector<std::string> function_lines(const diagnose::Diagnosis& diagnosis) {
  std::vector<std::string> lines;
  for (const LearntFunction& function : diagnosis.functions)
    lines.push_back(function_text(function, diagnosis.forces.machine));
  return lines;
}

}  // namespace plumbline::report
