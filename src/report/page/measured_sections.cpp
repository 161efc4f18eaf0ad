#include "report/page/measured_sections.hpp"

#include <cmath>
#include <utility>

namespace plumbline::report {
namespace {

constexpr double kDegQuantum = 1e-3;
constexpr double kUmQuantum = 1e-3;

Json picture_section(std::string_view type, std::string title, std::string words) {
  Json made{{"type", type}, {"title", std::move(title)}};
  if (!words.empty()) made["words"] = std::move(words);
  return made;
}

Json number_json(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
}

Json line_json(const std::string& name, Style style, Style dash) {
  Json json{{"name", name}, {"style", style}};
  if (dash > 0) json["dash"] = dash;
  return json;
}

Json limits_json(const std::vector<CurveLimit>& limits) {
  Json json = Json::array();
  for (const CurveLimit& limit : limits) json.push_back({{"name", limit.name}, {"value", limit.value}});
  return json;
}

Json panel_json(const CurvePanel& panel) {
  Json json{{"name", panel.name}, {"unit", panel.unit}, {"digits", panel.digits}, {"series", Json::array()}};
  for (const Curve& curve : panel.curves) {
    Json one = line_json(curve.name, curve.style, curve.dash);
    one["values"] = packed(curve.values, panel.quantum);
    if (curve.has_points) one["points"] = true;
    json["series"].push_back(std::move(one));
  }
  if (!panel.limits.empty()) json["limits"] = limits_json(panel.limits);
  if (panel.from_zero) json["from_zero"] = true;
  return json;
}

Json axis_json(const HeatAxis& axis) {
  Json json{{"name", axis.name}, {"unit", axis.unit}};
  if (axis.labels.empty()) {
    json["values"] = axis.values;
  } else {
    json["labels"] = axis.labels;
  }
  return json;
}

Json plane_json(const HeatPlane& plane, double quantum) {
  Json json{{"name", plane.name}, {"values", packed(plane.values, quantum)}};
  for (std::size_t i = 0; i < plane.reasons.size(); ++i) {
    if (plane.reasons[i] >= 0) json["reasons"][std::to_string(i)] = plane.reasons[i];
  }
  return json;
}

}  // namespace

Json curves_section(std::string title, const CurveAxis& axis, const std::vector<CurveGroup>& groups,
                    const CurveOptions& options) {
  Json json = picture_section("curves", std::move(title), options.words);
  json["choose"] = options.choose;
  json["same_scale"] = options.same_scale;
  json["axis"] = {{"name", axis.name}, {"unit", axis.unit}, {"digits", axis.digits}};
  if (!axis.names.empty()) json["axis"]["names"] = axis.names;
  if (axis.range) json["axis"]["range"] = {axis.range->first, axis.range->second};
  json["groups"] = Json::array();
  for (const CurveGroup& group : groups) {
    Json one{{"name", group.name}, {"note", group.note}, {"x", packed(group.x, kDegQuantum)}};
    one["panels"] = Json::array();
    for (const CurvePanel& panel : group.panels) one["panels"].push_back(panel_json(panel));
    json["groups"].push_back(std::move(one));
  }
  return json;
}

Json polar_section(std::string title, const std::vector<PolarGroup>& groups, std::string words) {
  Json json = picture_section("polar", std::move(title), std::move(words));
  json["unit"] = "um";
  json["choose"] = "Run";
  json["groups"] = Json::array();
  for (const PolarGroup& group : groups) {
    Json one{{"name", group.name}, {"note", group.note}, {"radius_mm", group.radius_mm}};
    one["curves"] = Json::array();
    for (const PolarCurve& curve : group.curves) {
      Json line = line_json(curve.name, curve.style, curve.dash);
      line["angle"] = packed(curve.angle_deg, kDegQuantum);
      line["values"] = packed(curve.deviation_um, kUmQuantum);
      one["curves"].push_back(std::move(line));
    }
    one["facts"] = Json::array();
    for (const PolarFigure& fact : group.figures) {
      one["facts"].push_back(
          {{"name", fact.name}, {"value", fact.value}, {"unit", fact.unit}, {"digits", fact.digits}});
    }
    json["groups"].push_back(std::move(one));
  }
  return json;
}

Json heat_section(std::string title, const HeatMap& map) {
  Json json = picture_section("heat", std::move(title), map.words);
  json["rows"] = axis_json(map.rows);
  json["columns"] = axis_json(map.columns);
  json["choose_plane"] = map.choose_plane;
  json["reasons"] = map.reasons;
  json["square"] = map.has_square_cells;
  json["figures"] = Json::array();
  for (const HeatFigure& figure : map.figures) {
    Json one{{"name", figure.name}, {"unit", figure.unit}, {"digits", figure.digits}, {"log", figure.is_logarithmic}};
    if (figure.range) one["range"] = {figure.range->first, figure.range->second};
    one["planes"] = Json::array();
    for (const HeatPlane& plane : figure.planes) one["planes"].push_back(plane_json(plane, figure.quantum));
    json["figures"].push_back(std::move(one));
  }
  return json;
}

Json bars_section(std::string title, const BarChart& chart) {
  Json json = picture_section("bars", std::move(title), chart.words);
  json["unit"] = chart.unit;
  json["digits"] = chart.digits;
  json["series"] = Json::array();
  for (const auto& [name, style] : chart.series) json["series"].push_back({{"name", name}, {"style", style}});
  json["references"] = limits_json(chart.references);
  json["rows"] = Json::array();
  for (const BarRow& row : chart.rows) {
    Json bars = Json::array();
    for (const Bar& bar : row.bars) {
      Json one{{"value", number_json(bar.value)}, {"style", bar.style}};
      if (bar.low) one["low"] = number_json(bar.low);
      if (bar.high) one["high"] = number_json(bar.high);
      if (!bar.why.empty()) one["why"] = bar.why;
      bars.push_back(std::move(one));
    }
    json["rows"].push_back({{"name", row.name}, {"bars", std::move(bars)}});
  }
  return json;
}

}  // namespace plumbline::report
