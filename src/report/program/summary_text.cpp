#include "report/program/summary_text.hpp"

#include <cmath>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/text/hash.hpp"
#include "base/units.hpp"
#include "base/version.hpp"
#include "report/micrometres.hpp"
#include "report/program/expected_text.hpp"
#include "report/program/line_text.hpp"
#include "report/text_table.hpp"

namespace plumbline::report {
namespace {

using compensate::Summary;
using compensate::Worst;
using Json = nlohmann::ordered_json;

// A figure of the summary: of a subprogram beside the program its file is said, too.
template <class Figure>
std::string bracketed_line(const Figure& figure) {
  return figure.line == 0 ? std::string() : fmt::format(" (line {})", line_text(figure.line, figure.file));
}

std::string short_time_text(double seconds) {
  return seconds < 1 ? fmt::format("{:.3g} ms", seconds / kMs) : time_text(seconds);
}

std::string change_text(double before, double after) {
  return before > 0 ? fmt::format("{:+.3f} %", (after / before - 1) * 100) : "no change";
}

void add_counts(TextTable& table, const Summary& s) {
  table.add("blocks", fmt::format("{} read, {} moves changed of {}", count_text(s.blocks), count_text(s.changed_blocks),
                                  count_text(s.moves)));
  if (s.unrolled) {
    table.add("form", "unrolled: loops and subprograms written out as they are executed, parameters as values");
  }
  for (const Summary::InlinedFile& file : s.inlined_files) {
    table.add("subprograms from", fmt::format("{} (hash {})", file.name, to_hex(file.hash)));
  }
  if (s.passed_moves > 0) table.add("left as they stand", count_text(s.passed_moves, "move"));
  table.add("points", count_text(s.points));
}

void add_corrections(TextTable& table, const Summary& s) {
  table.add("largest correction",
            fmt::format("{:.4f} mm{}, {:.5f} deg{}", s.correction_mm.value, bracketed_line(s.correction_mm),
                        s.correction_deg.value, bracketed_line(s.correction_deg)));
  table.add("rms correction", fmt::format("{:.4f} mm", s.rms_correction_mm));
}

void add_time(TextTable& table, const Summary& s) {
  if (s.untimed_moves > 0) {
    table.add("time not known", fmt::format("of {} under G95, or in strokes that a cycle makes in its own way",
                                            count_text(s.untimed_moves, "move")));
  }
  if (s.seconds_before <= 0) return;
  table.add("cutting time", fmt::format("{} before, {} after ({})", time_text(s.seconds_before),
                                        time_text(s.seconds_after), change_text(s.seconds_before, s.seconds_after)));
  table.add("worst of a block", fmt::format("{:.3f} %{}", s.time_change.value * 100, bracketed_line(s.time_change)));
}

// Where a bound that was asked for is not kept.
void add_broken(TextTable& table, const compensate::BrokenBound& broken, std::string_view why) {
  if (broken.pieces == 0) return;
  table.add("", fmt::format("but on {}, for {}: {}, up to {:.3f} um{}", count_text(broken.pieces, "piece"),
                            short_time_text(broken.seconds), why, broken.off_mm.value * kUmPerMm,
                            bracketed_line(broken.off_mm)));
}

void add_arcs(TextTable& table, const compensate::ArcFigures& arcs) {
  if (arcs.stayed + arcs.split + arcs.straight == 0) return;
  std::string text = fmt::format("{} stayed one", arcs.stayed);
  if (arcs.split > 0) {
    text += fmt::format(", {} became {} with arcs among them, at most {:.0f}{}", arcs.split,
                        count_text(arcs.blocks, "block"), arcs.most_blocks.value, bracketed_line(arcs.most_blocks));
  }
  if (arcs.straight > 0) text += fmt::format(", {} became straight pieces alone", arcs.straight);
  table.add("arcs", text);
}

void add_bound(TextTable& table, const Summary& s, const settings::Options& options) {
  const compensate::BoundSettings& asked = options.compensation.bound;
  if (!asked.is_asked() || !s.bound) return;
  table.add("bound",
            fmt::format("{:.4g} um and {:.3g} deg asked for; kept with at most {:.3f} um{}, {:.6f} deg, proven "
                        "piece by piece, rounding included",
                        asked.tolerance_mm * kUmPerMm, asked.tolerance_mm / asked.turn_length_mm / kDeg,
                        s.bound->kept_mm.value * kUmPerMm, bracketed_line(s.bound->kept_mm), s.bound->kept_deg.value));
  add_broken(table, s.bound->at_turns, "the friction of a strut turns, and the tip jumps with it");
  add_broken(table, s.bound->by_time, "no shorter block is allowed");
  add_arcs(table, s.bound->arcs);
}

void add_quality(TextTable& table, const Summary& s, const settings::Options& options, bool says_expected) {
  if (s.replayed > 0) {
    table.add("rounding, subdivision",
              fmt::format("at most {:.3f} um{}, {:.5f} deg, between its points too, with the friction that "
                          "turns: {} played on the model",
                          s.residual_mm.value * kUmPerMm, bracketed_line(s.residual_mm), s.residual_deg.value,
                          count_text(s.replayed, "point")));
    if (!options.compensation.bound.is_asked())
      table.add("", "that is the bound which these steps reach; --tolerance chooses the points by a bound");
    if (!says_expected)
      table.add("", "how far the machine itself is from its model comes on top: plumbline compare tells");
  }
  table.add("rounding",
            fmt::format("at most {:.3f} um{}", s.rounding_mm.value * kUmPerMm, bracketed_line(s.rounding_mm)));
  table.add("condition number", fmt::format("at most {:.1f}{}", s.condition.value, bracketed_line(s.condition)));
  if (s.widened_blocks > 0) {
    table.add("wider steps", fmt::format("{}, up to {:.3f} mm{}: the control's block time asks for it",
                                         count_text(s.widened_blocks, "block"), s.widened_step_mm.value,
                                         bracketed_line(s.widened_step_mm)));
    table.add("", fmt::format("between their points the tip is up to {:.3f} um off{}", s.widening_mm.value * kUmPerMm,
                              bracketed_line(s.widening_mm)));
  }
}

void add_short_pieces(TextTable& table, const Summary& s) {
  const compensate::ShortPieces& found = s.short_pieces;
  if (found.below_1_ms == 0 && found.below_block_time == 0) return;
  std::string counts = fmt::format("{} below 1 ms", count_text(found.below_1_ms));
  if (found.below_block_time > 0) {
    counts += fmt::format(", {} below the control's block time", count_text(found.below_block_time));
  }
  table.add("short pieces",
            fmt::format("{}, the shortest {:.3g} ms{}", counts, found.least_s / kMs, bracketed_line(found)));
  if (found.whole_blocks > 0)
    table.add("", fmt::format("{} of them as short in the program itself", count_text(found.whole_blocks)));
}

void add_offsets(TextTable& table, const Summary& s, const settings::Options& options) {
  if (std::isfinite(s.offset_shift_for_1um_mm)) {
    table.add("work offset", fmt::format("good to {:.3g} mm: that much off costs 1 um", s.offset_shift_for_1um_mm));
  }
  if (s.zero_error && !options.compensation.touch_off) {
    const AxisWords& e = *s.zero_error;
    table.add("zero", fmt::format("the machine stands X{:+.1f} Y{:+.1f} Z{:+.1f} um off at the first cutting block{}",
                                  e[Axis::X] * kUmPerMm, e[Axis::Y] * kUmPerMm, e[Axis::Z] * kUmPerMm,
                                  bracketed_line(Worst{0, s.zero_error_line, s.zero_error_file})));
    table.add("", "an offset probed on the machine holds that already: say where with --touch-off");
  }
  if (!s.assumed_at_zero.empty()) {
    table.add("taken to be zero", fmt::format("{}: no word of the program names them", axis_list(s.assumed_at_zero)));
  }
}

void add_read_back(TextTable& table, const Summary& s) {
  if (!s.read_back) return;
  table.add("read back", fmt::format("{}, {} of the output: all as meant", count_text(s.read_back->blocks, "block"),
                                     count_text(s.read_back->output_blocks)));
  if (s.read_back->guard_lines > 0) {
    table.add("", fmt::format("{} of the guard left out: only the machine decides there",
                              count_text(s.read_back->guard_lines, "line")));
  }
}

void add_files(TextTable& table, const Summary& s, const settings::Options& options) {
  const double growth =
      s.bytes_before > 0 ? static_cast<double>(s.bytes_after) / static_cast<double>(s.bytes_before) : 1;
  table.add("file", fmt::format("{} bytes before, {} after ({:.2f} times)", count_text(s.bytes_before),
                                count_text(s.bytes_after), growth));
  if (!options.machine.empty()) table.add("machine", options.machine);
  for (std::size_t i = 0; i < options.paths.settings_files.size(); ++i)
    table.add(i == 0 ? "settings from" : "", options.paths.settings_files[i]);
}

Json worst(const Worst& value, double unit = 1) {
  Json json{{"value", value.value * unit}, {"line", value.line}};
  if (!value.file.empty()) json["file"] = value.file;
  return json;
}

Json axis_values(const AxisWords& words) {
  Json json;
  for (const Axis axis : kAllAxes) {
    const char lower = static_cast<char>(letter(axis) - 'A' + 'a');
    json[std::string(1, lower) + (is_rotary(axis) ? "_deg" : "_mm")] = words[axis];
  }
  return json;
}

Json short_pieces_json(const compensate::ShortPieces& found) {
  const bool any = found.line > 0;
  Json json{{"below_1_ms", found.below_1_ms},
            {"below_block_time", found.below_block_time},
            {"whole_blocks", found.whole_blocks},
            {"shortest_ms", any ? Json(found.least_s / kMs) : Json()},
            {"line", any ? Json(found.line) : Json()}};
  if (!found.file.empty()) json["file"] = found.file;
  return json;
}

Json broken_json(const compensate::BrokenBound& broken) {
  const bool any = broken.pieces > 0;
  return {{"pieces", broken.pieces},
          {"time_s", broken.seconds},
          {"worst_um", any ? worst(broken.off_mm, kUmPerMm) : Json()},
          {"worst_deg", any ? worst(broken.off_deg) : Json()}};
}

Json arcs_json(const compensate::ArcFigures& arcs) {
  return {{"stayed", arcs.stayed},
          {"split", arcs.split},
          {"split_into", arcs.blocks},
          {"most", arcs.split > 0 ? worst(arcs.most_blocks) : Json()},
          {"straight", arcs.straight}};
}

Json bound_json(const Summary& s, const settings::Options& options) {
  const compensate::BoundSettings& asked = options.compensation.bound;
  if (!asked.is_asked() || !s.bound) return {};
  return {{"tolerance_um", asked.tolerance_mm * kUmPerMm},
          {"tolerance_deg", asked.tolerance_mm / asked.turn_length_mm / kDeg},
          {"yields", asked.yields == compensate::BoundSettings::Yields::bound ? "bound" : "time"},
          {"kept_um", worst(s.bound->kept_mm, kUmPerMm)},
          {"kept_deg", worst(s.bound->kept_deg)},
          {"not_kept_where_friction_turns", broken_json(s.bound->at_turns)},
          {"not_kept_for_block_time", broken_json(s.bound->by_time)},
          {"arcs", arcs_json(s.bound->arcs)}};
}

Json read_back_json(const Summary& s) {
  if (!s.read_back) return {};
  return {{"blocks", s.read_back->blocks},
          {"output_blocks", s.read_back->output_blocks},
          {"guard_lines", s.read_back->guard_lines}};
}

Json warnings_json(const Summary& s) {
  Json list = Json::array();
  for (const Diagnostic& w : s.warnings) {
    list.push_back({{"code", w.code}, {"message", w.message}, {"help", w.help}, {"line", w.place.line}});
    if (!w.place.file.empty() && w.place.file != s.made_of.program) list.back()["file"] = w.place.file;
  }
  return list;
}

Json made_of_json(const compensate::MadeOf& of) {
  Json offsets = Json::object();
  for (const compensate::MadeOf::Offset& offset : of.offsets) {
    offsets[offset.system] = axis_values(offset.origin);
    offsets[offset.system]["rotation_deg"] = offset.rotation_deg;
  }
  Json tools = Json::array();
  for (const nc::Tool& tool : of.tools) {
    tools.push_back({{"number", tool.number},
                     {"name", tool.name.empty() ? Json() : Json(tool.name)},
                     {"length_mm", tool.length_mm},
                     {"mass_kg", tool.mass_kg ? Json(*tool.mass_kg) : Json()},
                     {"centre_of_mass_mm", tool.centre_of_mass_mm ? Json(*tool.centre_of_mass_mm) : Json()}});
  }
  return {{"program", of.program},       {"program_hash", to_hex(of.program_hash)},
          {"dialect", of.dialect},       {"model", of.model},
          {"model_file", of.model_file}, {"model_hash", to_hex(of.model_hash)},
          {"work_offsets", offsets},     {"tools", tools}};
}

}  // namespace

std::string summary_text(const Summary& summary, const settings::Options& options,
                         const std::optional<jobs::ExpectedError>& expected) {
  TextTable table;
  add_counts(table, summary);
  if (summary.moves > 0) {
    add_corrections(table, summary);
    add_time(table, summary);
    if (expected) add_expected(table, *expected);
    add_bound(table, summary, options);
    add_quality(table, summary, options, expected.has_value());
    add_short_pieces(table, summary);
    add_offsets(table, summary, options);
  }
  add_read_back(table, summary);
  add_files(table, summary, options);
  const std::string same = summary.identical ? "nothing had to change: the output is the input\n" : "";
  return same + table.text();
}

namespace {

Json summary_in_json(const Summary& s, const settings::Options& options,
                     const std::optional<jobs::ExpectedError>& expected) {
  Json assumed = Json::array();
  for (const Axis axis : kAllAxes) {
    if (s.assumed_at_zero.contains(axis)) assumed.push_back(std::string(1, letter(axis)));
  }
  Json inlined = Json::array();
  for (const Summary::InlinedFile& file : s.inlined_files) {
    inlined.push_back({{"name", file.name}, {"hash", to_hex(file.hash)}});
  }
  const std::vector<std::string>& files = options.paths.settings_files;
  Json json{
      {"plumbline", "compensation 1"},
      {"version", version()},
      {"made_of", made_of_json(s.made_of)},
      {"identical", s.identical},
      {"unrolled", s.unrolled},
      {"inlined_files", inlined},
      {"blocks", s.blocks},
      {"moves", s.moves},
      {"changed_blocks", s.changed_blocks},
      {"passed_moves", s.passed_moves},
      {"points", s.points},
      {"largest_correction_mm", worst(s.correction_mm)},
      {"largest_correction_deg", worst(s.correction_deg)},
      {"rms_correction_mm", s.rms_correction_mm},
      {"time_before_s", s.seconds_before},
      {"time_after_s", s.seconds_after},
      {"untimed_moves", s.untimed_moves},
      {"worst_block_time_change", worst(s.time_change)},
      {"worst_rounding_um", worst(s.rounding_mm, kUmPerMm)},
      {"worst_residual_um", s.replayed > 0 ? worst(s.residual_mm, kUmPerMm) : Json()},
      {"worst_residual_deg", s.replayed > 0 ? worst(s.residual_deg) : Json()},
      {"replayed_points", s.replayed},
      {"largest_condition", worst(s.condition)},
      {"widened_blocks", s.widened_blocks},
      {"widest_step_mm", s.widened_blocks > 0 ? worst(s.widened_step_mm) : Json()},
      {"widening_cost_um", s.widened_blocks > 0 ? worst(s.widening_mm, kUmPerMm) : Json()},
      {"expected", expected_json(expected)},
      {"bound", bound_json(s, options)},
      {"short_pieces", short_pieces_json(s.short_pieces)},
      {"offset_shift_for_1um_mm", std::isfinite(s.offset_shift_for_1um_mm) ? Json(s.offset_shift_for_1um_mm) : Json()},
      {"zero_error", s.zero_error ? axis_values(*s.zero_error) : Json()},
      {"zero_error_line", s.zero_error ? Json(s.zero_error_line) : Json()},
      {"assumed_at_zero", assumed},
      {"read_back", read_back_json(s)},
      {"bytes_before", s.bytes_before},
      {"bytes_after", s.bytes_after},
      {"hash_after", to_hex(s.hash_after)},
      {"machine", options.machine.empty() ? Json() : Json(options.machine)},
      {"settings_file", files.empty() ? Json() : Json(files.front())},
      {"settings_files", files},
      {"warnings", warnings_json(s)}};
  if (s.zero_error && !s.zero_error_file.empty()) json["zero_error_file"] = s.zero_error_file;
  return json;
}

}  // namespace

std::string summary_json(const Summary& summary, const settings::Options& options,
                         const std::optional<jobs::ExpectedError>& expected) {
  return summary_in_json(summary, options, expected).dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string summary_json_line(const Summary& summary, const settings::Options& options,
                              const std::optional<jobs::ExpectedError>& expected) {
  return summary_in_json(summary, options, expected).dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace plumbline::report
