#include "report/program/new_model_text.hpp"

#include <fmt/format.h>

#include "base/text/printable.hpp"
#include "base/units.hpp"

namespace plumbline::report {
namespace {

std::string value_text(const jobs::DraftValue& value) {
  if (value.values.empty()) return value.text;
  std::string text;
  for (const double number : value.values) text += (text.empty() ? "" : ", ") + jobs::draft_number(number);
  return value.values.size() == 1 ? text : "[" + text + "]";
}

std::string corners_text(const jobs::CornerCheck& corners) {
  std::string text = fmt::format("corners of the travel, not tilted: {} of 8 in reach", corners.reached);
  if (!corners.first_limit.empty()) text += fmt::format("; at the first that is not, {}", corners.first_limit);
  if (corners.other_side > 0)
    text +=
        fmt::format("; {} beyond a singularity, where the machine cannot go from home: narrow the travel in [limits]",
                    corners.other_side);
  return text + "\n";
}

}  // namespace

std::string new_model_text(const jobs::NewModel& made) {
  std::string text;
  for (const std::string& note : made.notes) text += printable(note) + "\n";
  if (!made.assumed.empty()) text += "assumed, as nothing says it:\n";
  for (const jobs::DraftValue& value : made.assumed) {
    const std::string table = value.table.empty() ? "" : fmt::format("[{}] ", value.table);
    text += fmt::format("  {}{} = {}: {}\n", table, value.key, value_text(value), printable(value.note));
  }
  text += fmt::format(
      "checked: it is read without fault; in the middle of its travel gravity moves the tip by {:.3g} um, "
      "condition number {:.3g}, at most {:.3g} in the corners\n",
      made.home_error / kUm, made.home_condition, made.corners.largest_condition);
  return text + corners_text(made.corners);
}

}  // namespace plumbline::report
