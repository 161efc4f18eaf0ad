#include "nc/control/state/control.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "base/units.hpp"

namespace plumbline::nc {
namespace {

constexpr int kFirstHome = 5161;    // parameters of G28, twenty further G30 [LinuxCNC; RS274/NGC 3.2.1]
constexpr int kFirstSystem = 5221;  // of G54
constexpr int kG92 = 5211;
constexpr int kSystemInForce = 5220;
constexpr double kNoShift = 1e-9;  // mm and deg

// The inches that are so many mm; of neighbours that are the same mm, the one with the fewest digits.
double inches_of(double mm) {
  const double quotient = mm / kMmPerInch;
  double best = quotient;
  std::size_t fewest = std::numeric_limits<std::size_t>::max();
  for (const double inches : {quotient, std::nextafter(quotient, -HUGE_VAL), std::nextafter(quotient, HUGE_VAL)}) {
    const std::size_t digits = fmt::format("{}", inches).size();
    if (inches * kMmPerInch != mm || digits >= fewest) continue;
    best = inches;
    fewest = digits;
  }
  return best;
}

// Work systems whose offsets are parameters: G54 to G59.3, of macro B G54 to G59.
std::size_t rows_of_offsets(const Dialect& dialect) {
  const SystemVariables own = dialect.syntax.system_variables;
  if (own == SystemVariables::none) return 0;
  return own == SystemVariables::rs274 ? 9 : 6;
}

// Those of six parameters in a row that somebody gave.
AxisSet given(const Parameters& parameters, int first, AxisWords& into) {
  AxisSet axes;
  for (const Axis axis : kAllAxes) {
    const int number = first + static_cast<int>(index(axis));
    if (!parameters.has(number)) continue;
    into[axis] = parameters.get(number).number;
    axes.insert(axis);
  }
  return axes;
}

}  // namespace

Control::Control(const Dialect& dialect, const ProgramSettings& settings)
    : behaviour(dialect.behaviour), feed_rule(settings.feed_rule.value_or(dialect.feed_rule)) {
  for (const CodeRow& row : dialect.at_start) {
    if (row.action == Action::retract_to_start) modal.retract_to_r = false;
    if (row.action == Action::exact_stop) modal.path_control = PathControl::exact_stop;
    if (row.action == Action::work_system) modal.work_system = row.value;
  }
  modal.rotary = settings.rotary;
  modal.inches = settings.inches.value_or(false);
  modal.unit_stated = settings.inches.has_value();
  if (dialect.behaviour.no_work_system_at_start) modal.work_system = 0;
  if (dialect.syntax.statements == Statements::user_task) parameters.watch_names();
  if (dialect.syntax.declared) parameters.keep_names_apart();
  if (settings.as_with_empty_tables) no_system.known = AxisSet::all();
  if (dialect.syntax.system_variables == SystemVariables::rs274) {
    const auto active = settings.variables.find(kSystemInForce);
    const double system = active == settings.variables.end() ? 0 : active->second;
    if (system >= 1 && system <= dialect.work_systems && system == std::floor(system)) {
      modal.work_system = static_cast<int>(system);
    }
    parameters.set("_value", {});
    parameters.set("_value_returned", {});
    parameters.set("_task", {settings.as_with_empty_tables ? 0.0 : 1.0, true});  // 0: rs274 and previews
  }
  for (const auto& [number, value] : settings.variables) {
    if (number >= 0 && number <= kLastParameter) parameters.set(number, {value, true});
  }
  for (std::size_t i = 0; i < systems.size(); ++i) {
    if (i < rows_of_offsets(dialect)) {
      const int first = kFirstSystem + kParametersPerRow * static_cast<int>(i);
      systems[i].known = given(parameters, first, systems[i].origin);
    }
    if (settings.as_with_empty_tables) systems[i].known = AxisSet::all();
    if (!settings.work_offsets[i]) continue;
    systems[i] = {settings.work_offsets[i]->origin, settings.work_offsets[i]->rotation_deg, AxisSet::all()};
  }
  for (std::size_t i = 0; i < homes.size(); ++i) {
    const int first = kFirstHome + kParametersPerRow * static_cast<int>(i);
    homes[i].known = given(parameters, first, homes[i].machine);
    if (settings.as_with_empty_tables) homes[i].known = AxisSet::all();
  }
  g92.known = given(parameters, kG92, g92.suspended) == AxisSet::all() || settings.as_with_empty_tables;
  if (settings.as_with_empty_tables) g92.applied = false;
  if (parameters.has(kG92InForce)) g92.applied = parameters.get(kG92InForce).number != 0;
  if (g92.applied.value_or(false)) frame.g92 = g92.suspended;
  frame.origin = active().origin;
  frame.rotation_deg = active().rotation_deg;
  modal.tool_in_spindle = settings.tool_in_spindle.value_or(-1);
  for (const Axis axis : kAllAxes) {
    const auto& start = settings.start[index(axis)];
    position[axis] = start.value_or(0);
    const bool stands = start.has_value() && active().known.contains(axis);
    if (stands || settings.as_with_empty_tables) known.insert(axis);
  }
}

double Control::length_unit() const { return modal.inches ? kMmPerInch : 1; }

void Control::change_unit(bool inches) {
  modal.inches = inches;
  modal.feed = feed_linear / length_unit();
  if (!inches) return;
  constexpr double kInchesPerMm = 1 / kMmPerInch;  // a product with which is not the quotient [interp_convert.cc]
  for (const Axis axis : {Axis::X, Axis::Y, Axis::Z}) {
    inch_places[index(axis)] = {position[axis], position[axis] * kInchesPerMm};
  }
}

double Control::position_in_unit(Axis axis) const {
  const double value = position[axis];
  if (is_rotary(axis) || !modal.inches) return value;
  const InchPlace& place = inch_places[index(axis)];
  return place.mm == value ? place.inches : inches_of(value);
}

// Axes whose increments may bring the change along or not: which of both is not known.
AxisSet Control::shifted_by(const Frame& next, const AxisWords& moved) const {
  AxisSet axes;
  for (const Axis axis : kAllAxes) {
    const bool offset = frame.origin[axis] != next.origin[axis] || frame.g92[axis] != next.g92[axis];
    const bool unknown = (behaviour.increment_unknown_after_offset && offset) ||
                         (behaviour.increment_unknown_after_length && frame.tool[axis] != next.tool[axis]) ||
                         (behaviour.increment_unknown_after_turn &&
                          (frame.rotation_deg != next.rotation_deg || frame.plane != next.plane));
    if (unknown && std::abs(position[axis] - moved[axis]) > kNoShift) axes.insert(axis);
  }
  return axes;
}

void Control::change_frame(const Frame& next) {
  const AxisWords machine = frame.to_machine(position);
  const AxisWords moved = next.from_machine(machine);
  shifted = shifted | shifted_by(next, moved);
  const auto same = [&](Axis axis) {
    return frame.origin[axis] == next.origin[axis] && frame.g92[axis] == next.g92[axis] &&
           frame.tool[axis] == next.tool[axis];
  };
  const AxisSet mixed = frame.mixed() | next.mixed();
  const bool same_turn =
      frame.rotation_deg == next.rotation_deg && frame.tilted == next.tilted && frame.plane == next.plane;
  // The length of a tool on a tilted plane counts along the plane's Z alone.
  const auto same_shift = [&](Axis axis) {
    const bool same_tool = frame.tool[axis] == next.tool[axis] || frame.tilted;
    return frame.origin[axis] == next.origin[axis] && frame.g92[axis] == next.g92[axis] && same_tool;
  };
  const bool same_mixed = same_turn && std::all_of(kAllAxes.begin(), kAllAxes.end(), [&](Axis axis) {
                            return same_shift(axis) || !mixed.contains(axis);
                          });
  for (const Axis axis : kAllAxes) {
    if (same(axis) && (same_mixed || !mixed.contains(axis))) continue;
    position[axis] = moved[axis];
  }
  // A turned X is made of both X and Y.
  if (!same_mixed && !known.contains(mixed)) known = known - mixed;
  turned = AxisSet{};
  frame = next;
}

void Control::use_active_system() {
  Frame next = frame;
  next.origin = active().origin + local + plane_origin;
  next.rotation_deg = active().rotation_deg + turn_deg;
  change_frame(next);
}

// The control leaves the shift of G92 out when it turns where it stands into the new row's words, so that in a turned
// work system it takes itself to stand elsewhere [LinuxCNC, measured].
void Control::use_changed_row() {
  const AxisWords shift = frame.g92;
  frame.g92 = AxisWords{};
  use_active_system();
  frame.g92 = shift;
}

}  // namespace plumbline::nc
