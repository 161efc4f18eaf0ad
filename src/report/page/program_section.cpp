#include "report/page/program_section.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <functional>
#include <limits>
#include <string_view>
#include <vector>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "base/units.hpp"
#include "report/micrometres.hpp"

namespace plumbline::report {
namespace {

using compensate::DrawnPath;
using compensate::DrawnPoint;
using Value = std::function<double(const DrawnPoint&)>;

constexpr double kMdegPerDeg = 1000;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

// A column, and how its numbers are read.
struct Column {
  std::string key;
  std::string name;
  std::string unit;
  int digits;      // after the point
  double quantum;  // what is kept
  Value value;
};

double in_um(double metres) { return metres / kUm; }

AxisWords correction(const DrawnPoint& point) { return point.recorded.commanded - point.recorded.asked.pose; }

double uncorrected_um(const DrawnPoint& point) {
  return point.gives_way ? kNone : in_um(point.uncorrected.head<3>().norm());
}

double left_um(const DrawnPoint& point) { return point.gives_way ? kNone : in_um(point.left.head<3>().norm()); }

double room_mm(const DrawnPoint& point, const machine::Limits& limits) {
  return compensate::least_room(limits, point.lengths) / kMm;
}

std::vector<Column> place_columns() {
  std::vector<Column> columns{
      {"line", "line", "", 0, 1, [](const DrawnPoint& p) { return static_cast<double>(p.recorded.line); }},
      {"kind", "way", "", 0, 1, [](const DrawnPoint& p) { return static_cast<double>(p.recorded.kind); }},
      {"tool", "tool", "", 0, 1, [](const DrawnPoint& p) { return p.recorded.tool; }},
      {"time", "time", "s", 3, 1e-4, [](const DrawnPoint& p) { return p.recorded.time_s; }}};
  for (const Axis axis : kAllAxes) {
    const std::string key(1, static_cast<char>(letter(axis) - 'A' + 'a'));
    columns.push_back({key, std::string(1, letter(axis)), is_rotary(axis) ? "deg" : "mm", 4, 1e-5,
                       [axis](const DrawnPoint& p) { return p.recorded.asked.pose[axis]; }});
  }
  return columns;
}

void add_correction(std::vector<Column>& columns, const PathKind& kind) {
  for (const Axis axis : kAllAxes) {
    const double factor = is_rotary(axis) ? kMdegPerDeg : kUmPerMm;
    columns.push_back({fmt::format("c{}", static_cast<char>(letter(axis) - 'A' + 'a')),
                       fmt::format("{} of {}", kind.shift, letter(axis)), is_rotary(axis) ? "mdeg" : "um", 2, 1e-3,
                       [axis, factor](const DrawnPoint& p) { return correction(p)[axis] * factor; }});
  }
  columns.push_back(
      {"shift", kind.shift, "um", 2, 1e-3, [](const DrawnPoint& p) { return length_mm(correction(p)) * kUmPerMm; }});
}

void add_error(std::vector<Column>& columns, const PathKind& kind) {
  if (kind.corrected) columns.push_back({"left", "left by rounding and subdivision", "um", 3, 1e-3, left_um});
  for (int i = 0; i < 3; ++i) {
    const char axis = static_cast<char>('x' + i);
    columns.push_back({fmt::format("e{}", axis), fmt::format("error in {}", static_cast<char>('X' + i)), "um", 2, 1e-3,
                       [i](const DrawnPoint& p) { return p.gives_way ? kNone : in_um(p.uncorrected[i]); }});
  }
  columns.push_back(
      {"error", kind.corrected ? "error without correction" : "error at the tip", "um", 2, 1e-3, uncorrected_um});
}

// What is expected at the tip, and what 95 % are within.
void add_doubts(std::vector<Column>& columns, const DrawnPath& path, const PathKind& kind) {
  if (kind.doubts.size() != path.points.size()) return;
  using Figure = double jobs::TipDoubt::*;
  const auto add = [&](const char* key, const char* name, bool touched_off, Figure figure) {
    columns.push_back({key, name, "um", 2, 1e-3, [&path, &kind, touched_off, figure](const DrawnPoint& p) {
                         const auto& doubt = kind.doubts[static_cast<std::size_t>(&p - path.points.data())];
                         if (!doubt || (touched_off && !doubt->touched_off)) return kNone;
                         return in_um((touched_off ? *doubt->touched_off : doubt->stands).*figure);
                       }});
  };
  add("expected", "expected", false, &jobs::TipDoubt::mean);
  add("within", "95 % are within", false, &jobs::TipDoubt::within);
  add("expected_off", "expected, zero touched off", true, &jobs::TipDoubt::mean);
  add("within_off", "95 % are within, zero touched off", true, &jobs::TipDoubt::within);
}

void add_struts(std::vector<Column>& columns, const machine::Limits& limits) {
  for (int j = 0; j < machine::kStruts; ++j) {
    columns.push_back({fmt::format("s{}", j + 1), fmt::format("strut {}", j + 1), "mm", 3, 1e-4,
                       [j](const DrawnPoint& p) { return p.lengths[j] / kMm; }});
  }
  for (int j = 0; j < machine::kStruts; ++j) {
    columns.push_back({fmt::format("f{}", j + 1), fmt::format("strut {}", j + 1), "N", 1, 1e-2,
                       [j](const DrawnPoint& p) { return p.gives_way ? kNone : p.tension[j]; }});
  }
  columns.push_back({"force", "largest strut force", "N", 1, 1e-2,
                     [](const DrawnPoint& p) { return p.gives_way ? kNone : p.tension.cwiseAbs().maxCoeff(); }});
  columns.push_back({"room", "room to the nearest strut limit", "mm", 2, 1e-3,
                     [&limits](const DrawnPoint& p) { return room_mm(p, limits); }});
  columns.push_back({"condition", "condition number", "", 2, 1e-3, [](const DrawnPoint& p) { return p.condition; }});
}

void add_motion(std::vector<Column>& columns) {
  columns.push_back({"feed", "speed of the tip", "mm/min", 1, 1e-2,
                     [](const DrawnPoint& p) { return p.recorded.mm_s ? *p.recorded.mm_s * kMinute : kNone; }});
  columns.push_back({"block", "time of a block", "ms", 3, 1e-3,
                     [](const DrawnPoint& p) { return p.recorded.piece_s ? *p.recorded.piece_s / kMs : kNone; }});
}

// How the machine stands, for its drawing: where the tip is sent, the orientation, the tool's length.
void add_stand(std::vector<Column>& columns) {
  for (int i = 0; i < 3; ++i) {
    columns.push_back({fmt::format("p{}", static_cast<char>('x' + i)), "tip as told", "mm", 4, 1e-5,
                       [i](const DrawnPoint& p) { return p.stands.p_WT[i] / kMm; }});
  }
  constexpr std::string_view kParts = "xyzw";
  for (int i = 0; i < 4; ++i) {
    columns.push_back({fmt::format("q{}", kParts[static_cast<std::size_t>(i)]), "orientation", "", 6, 1e-7,
                       [i](const DrawnPoint& p) { return Eigen::Quaterniond(p.stands.R_WP).coeffs()[i]; }});
  }
  columns.push_back({"tip", "tip along the spindle", "mm", 3, 1e-4, [](const DrawnPoint& p) { return p.tip_z / kMm; }});
}

bool has_tools(const DrawnPath& path) {
  return std::any_of(path.points.begin(), path.points.end(),
                     [&](const DrawnPoint& p) { return p.recorded.tool != path.points.front().recorded.tool; });
}

Json column_json(const Column& column, const DrawnPath& path) {
  std::vector<double> values;
  values.reserve(path.points.size());
  for (const DrawnPoint& point : path.points) values.push_back(column.value(point));
  Json json{{"name", column.name}, {"unit", column.unit}, {"digits", column.digits}};
  json.update(packed(values, column.quantum));
  return json;
}

std::string name_in_folder(const std::string& file) { return file.substr(file.find_last_of('/') + 1); }

// The blocks that points belong to: line, text, the text that replaced it, how many bytes that has, and the name of its
// file where that is not the program's own.
void add_blocks(Json& section, const DrawnPath& path, const std::string& program) {
  Json blocks = Json::array();
  std::vector<double> of_point;
  const compensate::RecordedPoint* last = nullptr;
  for (const DrawnPoint& point : path.points) {
    const compensate::RecordedPoint& here = point.recorded;
    if (last == nullptr || here.line != last->line || here.text != last->text || here.file != last->file ||
        here.after_begin != last->after_begin) {
      blocks.push_back({here.line, here.text, here.after, here.after_end - here.after_begin});
      if (!program.empty() && name_in_folder(here.file) != program) {
        blocks.back().push_back(name_in_folder(here.file));
      }
    }
    last = &here;
    of_point.push_back(static_cast<double>(blocks.size() - 1));
  }
  section["blocks"] = std::move(blocks);
  section["columns"]["text"] = Json{{"name", "block"}, {"unit", ""}, {"digits", 0}};
  section["columns"]["text"].update(packed(of_point, 1));
}

Json points_json(const machine::StrutVectors<double>& points) {
  Json json = Json::array();
  for (int j = 0; j < machine::kStruts; ++j) {
    json.push_back({points(0, j) / kMm, points(1, j) / kMm, points(2, j) / kMm});
  }
  return json;
}

Json struts_json(const machine::PerStrut<double>& lengths) {
  Json json = Json::array();
  for (const double length : lengths) json.push_back(length / kMm);
  return json;
}

Json machine_json(const machine::MachineModel& model) {
  Json json{{"name", model.name},
            {"base", points_json(model.geometry.base_joints_W)},
            {"platform", points_json(model.geometry.platform_joints_P)},
            {"tip", {model.geometry.tool_tip_P.x() / kMm, model.geometry.tool_tip_P.y() / kMm}},
            {"shortest", struts_json(model.limits.length_min)},
            {"longest", struts_json(model.limits.length_max)}};
  Json& travel = json["travel"] = Json::array();
  for (const machine::Range& range : model.limits.travel) travel.push_back({range.lower / kMm, range.upper / kMm});
  return json;
}

std::string sentence(std::string text) {
  if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

Json track(std::string title, std::string unit, int digits, std::initializer_list<const char*> keys) {
  return Json{{"title", std::move(title)}, {"unit", std::move(unit)}, {"digits", digits}, {"keys", keys}};
}

Json tracks_json(const machine::MachineModel* model, const PathKind& kind) {
  Json tracks = Json::array();
  if (kind.corrected) {
    tracks.push_back(track(sentence(kind.shift) + " of X, Y, Z", "um", 2, {"cx", "cy", "cz"}));
    tracks.push_back(track(sentence(kind.shift) + " of A, B, C", "mdeg", 2, {"ca", "cb", "cc"}));
    if (model != nullptr) tracks.push_back(track("Error at the tip", "um", 2, {"error", "left"}));
  } else {
    tracks.push_back(track("Error at the tip", "um", 2, {"ex", "ey", "ez", "error"}));
  }
  if (!kind.doubts.empty()) {
    const std::string of = kind.corrected ? "Expected to be left on the machine" : "The machine beside its model";
    tracks.push_back(track(of, "um", 2, {"expected", "within"}));
    tracks.push_back(track(of + ", zero touched off", "um", 2, {"expected_off", "within_off"}));
  }
  if (model != nullptr) {
    tracks.push_back(track("Strut lengths", "mm", 2, {"s1", "s2", "s3", "s4", "s5", "s6"}));
    tracks.back()["limits"] = {{{"value", model->limits.length_min.maxCoeff() / kMm}, {"name", "shortest"}},
                               {{"value", model->limits.length_max.minCoeff() / kMm}, {"name", "longest"}}};
    tracks.push_back(track("Strut forces", "N", 1, {"f1", "f2", "f3", "f4", "f5", "f6"}));
    tracks.push_back(track("Condition number", "", 1, {"condition"}));
  }
  tracks.push_back(track("Speed of the tip", "mm/min", 0, {"feed"}));
  tracks.push_back(track("Time of a block", "ms", 3, {"block"}));
  tracks.back()["logarithmic"] = true;
  const double block_time = model != nullptr && model->control.block_time > 0 ? model->control.block_time : kMs;
  tracks.back()["limits"] = {{{"value", block_time / kMs}, {"name", "least block time"}, {"below", "short"}}};
  tracks.push_back(track("Tip, X and Y", "mm", 3, {"x", "y"}));
  tracks.push_back(track("Tip, Z", "mm", 3, {"z"}));
  tracks.push_back(track("Orientation", "deg", 4, {"a", "b", "c"}));
  return tracks;
}

// The points where a figure is largest (sign +1) or least (-1).
void add_worst(Json& worst, const DrawnPath& path, const Column& column, std::string_view what, int sign) {
  std::size_t at = path.points.size();
  double most = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < path.points.size(); ++i) {
    if (path.points[i].recorded.kind == compensate::WayKind::gap) continue;
    const double value = sign * column.value(path.points[i]);
    if (!(value > most)) continue;
    most = value;
    at = i;
  }
  if (at == path.points.size()) return;
  worst.push_back(
      {{"what", what}, {"value", sign * most}, {"unit", column.unit}, {"digits", column.digits}, {"point", at}});
}

Json worst_json(const DrawnPath& path, const std::vector<Column>& columns, const PathKind& kind) {
  struct Wanted {
    std::string_view key;
    std::string what;
    int sign;
  };
  const std::array wanted_places{
      Wanted{"shift", "largest " + kind.shift, 1},
      Wanted{"error", kind.corrected ? "largest error without correction" : "largest error at the tip", 1},
      Wanted{"left", "most left by rounding and subdivision, at a drawn point", 1},
      Wanted{"within", "most uncertain: 95 % are within", 1},
      Wanted{"within_off", "most uncertain with the zero touched off: 95 % are within", 1},
      Wanted{"force", "largest strut force", 1},
      Wanted{"room", "nearest to a strut limit", -1},
      Wanted{"condition", "nearest to a singularity (condition number)", 1},
      Wanted{"block", "shortest block", -1},
      Wanted{"feed", "fastest", 1}};
  Json worst = Json::array();
  for (const Wanted& wanted : wanted_places) {
    const auto found =
        std::find_if(columns.begin(), columns.end(), [&](const Column& column) { return column.key == wanted.key; });
    if (found != columns.end()) add_worst(worst, path, *found, wanted.what, wanted.sign);
  }
  return worst;
}

}  // namespace

Json program_section(const DrawnPath& path, const machine::MachineModel* model, const PathKind& kind) {
  std::vector<Column> columns = place_columns();
  if (kind.corrected) add_correction(columns, kind);
  if (model != nullptr) {
    add_error(columns, kind);
    add_doubts(columns, path, kind);
    add_struts(columns, model->limits);
    add_stand(columns);
  }
  add_motion(columns);

  Json section{{"type", "program"},
               {"title", "The path"},
               {"points", path.points.size()},
               {"of_points", path.of_points},
               {"corrected", kind.corrected},
               {"told", kind.told},
               {"replaced", kind.replaced},
               {"machine", model == nullptr ? Json() : machine_json(*model)},
               {"tracks", tracks_json(model, kind)},
               {"worst", worst_json(path, columns, kind)}};
  Json& all = section["columns"] = Json::object();
  for (const Column& column : columns) all[column.key] = column_json(column, path);
  add_blocks(section, path, name_in_folder(kind.program));
  Json& colours = section["colours"] = Json::array();
  for (const char* const key :
       {"shift", "left", "error", "within", "within_off", "feed", "block", "condition", "force", "room", "kind"}) {
    if (all.contains(key)) colours.push_back(key);
  }
  if (has_tools(path)) colours.push_back("tool");
  return section;
}

}  // namespace plumbline::report
