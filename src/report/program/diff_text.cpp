#include "report/program/diff_text.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "report/text_table.hpp"

namespace plumbline::report {
namespace {

constexpr std::size_t kOutOfLineShown = 20;
using Json = nlohmann::ordered_json;

std::string lines_text(std::size_t first, std::size_t last) {
  if (first == 0) return "nothing";
  return first == last ? fmt::format("line {}", first) : fmt::format("lines {} to {}", first, last);
}

std::string axis_text(Axis axis, const jobs::AxisShift& shift) {
  const std::string_view unit = is_rotary(axis) ? "deg" : "mm";
  const int decimals = is_rotary(axis) ? 6 : 5;
  if (shift.largest == 0) return fmt::format("{:>10} {}", "0", unit);
  return fmt::format("{:>10.{}f} {:<3} largest (line {} of A, {} of B), rms {:.{}f}", shift.largest, decimals, unit,
                     shift.line_a, shift.line_b, shift.rms, decimals);
}

std::string time_change_text(const jobs::DiffSummary& s) {
  std::string times = fmt::format("{} in A, {} in B", time_text(s.seconds_a), time_text(s.seconds_b));
  if (s.seconds_a <= 0) return times;
  return times + fmt::format(" ({:+.3f} %)", (s.seconds_b / s.seconds_a - 1) * 100);
}

}  // namespace

std::string diff_text(const jobs::DiffSummary& s) {
  TextTable table;
  table.add("moves", fmt::format("{} in A, {} in B, {} matched, {} points compared", count_text(s.moves_a),
                                 count_text(s.moves_b), count_text(s.matched), count_text(s.points)));
  for (const Axis axis : kAllAxes) {
    table.add(fmt::format("shift of {}", letter(axis)), axis_text(axis, s.shift[index(axis)]));
  }
  table.add("cutting time", time_change_text(s));
  table.add("worst of a move",
            fmt::format("{:.3f} %{}", s.time_change.value * 100,
                        s.time_change.line > 0 ? fmt::format(" (line {})", s.time_change.line) : ""));
  if (s.untimed.count > 0) {
    table.add(
        "time not known",
        fmt::format(
            "of {} of A, first in line {} (feeds per revolution, strokes that a cycle makes in its own way, or turns "
            "without a feed rule)",
            count_text(s.untimed.count, "move"), s.untimed.first_line));
  }
  table.add("out of line",
            fmt::format("{} of A, {} of B", count_text(s.out_of_line_a, "move"), count_text(s.out_of_line_b)));
  const std::size_t shown = std::min(kOutOfLineShown, s.out_of_line.size());
  for (std::size_t i = 0; i < shown; ++i) {
    const jobs::OutOfLine& place = s.out_of_line[i];
    table.add("", fmt::format("A: {}, B: {}", lines_text(place.first_line_a, place.last_line_a),
                              lines_text(place.first_line_b, place.last_line_b)));
  }
  if (s.out_of_line.size() > shown) table.add("", "and further ones");
  return table.text();
}

std::string diff_json(const jobs::DiffSummary& s) {
  Json shift;
  for (const Axis axis : kAllAxes) {
    const jobs::AxisShift& of_axis = s.shift[index(axis)];
    const std::string unit = is_rotary(axis) ? "_deg" : "_mm";
    shift[std::string(1, letter(axis))] = {{"largest" + unit, of_axis.largest},
                                           {"line_a", of_axis.line_a},
                                           {"line_b", of_axis.line_b},
                                           {"rms" + unit, of_axis.rms}};
  }
  Json places = Json::array();
  for (const jobs::OutOfLine& place : s.out_of_line) {
    places.push_back({{"first_line_a", place.first_line_a},
                      {"last_line_a", place.last_line_a},
                      {"first_line_b", place.first_line_b},
                      {"last_line_b", place.last_line_b}});
  }
  const Json json{{"plumbline", "diff 1"},
                  {"moves_a", s.moves_a},
                  {"moves_b", s.moves_b},
                  {"matched", s.matched},
                  {"points", s.points},
                  {"shift", shift},
                  {"time_a_s", s.seconds_a},
                  {"time_b_s", s.seconds_b},
                  {"time_difference_s", s.seconds_b - s.seconds_a},
                  {"worst_move_time_change", {{"value", s.time_change.value}, {"line", s.time_change.line}}},
                  {"moves_without_time", s.untimed.count},
                  {"out_of_line_a", s.out_of_line_a},
                  {"out_of_line_b", s.out_of_line_b},
                  {"out_of_line", places}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace plumbline::report
