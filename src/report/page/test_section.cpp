#include "report/page/test_section.hpp"

#include <cmath>
#include <utility>

#include "base/units.hpp"
#include "machine/orientation.hpp"

namespace plumbline::report {
namespace {

Json point_mm(const Vector3<double>& p) { return Json{p.x() / kMm, p.y() / kMm, p.z() / kMm}; }

Json points_mm(const machine::StrutVectors<double>& points) {
  Json json = Json::array();
  for (int j = 0; j < machine::kStruts; ++j) json.push_back(point_mm(points.col(j)));
  return json;
}

// Travel that the model does not bound is left out.
Json travel_json(const machine::Limits& limits) {
  Json json = Json::object();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const machine::Range& range = limits.travel.at(axis);
    if (!std::isfinite(range.lower) || !std::isfinite(range.upper)) continue;
    json[std::string(1, static_cast<char>('x' + axis))] = {range.lower / kMm, range.upper / kMm};
  }
  return json;
}

Json test_json(const machine::MachineModel& machine, const ShownTest& test) {
  const measure::Run& run = test.run;
  const Vector3<double> start = run.centre_W + Vector3<double>(run.radius, 0, 0);
  // p_W = p_WT + R (p_P - c)
  const Matrix3<double> R = machine::rotation<double>(machine.rotation, run.tilt);
  const machine::Geometry& geometry = machine.geometry;
  const machine::StrutVectors<double> from_tip = geometry.platform_joints_P.colwise() - geometry.tool_tip_P;
  const machine::StrutVectors<double> platform = (R * from_tip).colwise() + start;
  Json json{
      {"name", test.name}, {"note", test.note}, {"centre_mm", point_mm(run.centre_W)}, {"radius_mm", run.radius / kMm}};
  json["bar_mm"] = run.bar ? Json(*run.bar / kMm) : Json(nullptr);
  json["tilt_deg"] = {run.tilt.x() / kDeg, run.tilt.y() / kDeg, run.tilt.z() / kDeg};
  json["direction"] = to_text(run.direction);
  json["feed_mm_min"] = run.feed / kMmPerMin;
  json["payload_kg"] = run.payload_mass;
  json["start_mm"] = point_mm(start);
  json["platform_mm"] = points_mm(platform);
  if (!test.program.empty()) json["program"] = test.program;
  return json;
}

}  // namespace

Json tests_section(std::string title, const machine::MachineModel& machine, const std::vector<ShownTest>& tests) {
  Json json{{"type", "circles"}, {"title", std::move(title)}};
  json["machine"] = {{"base_mm", points_mm(machine.geometry.base_joints_W)},
                     {"limits_mm", travel_json(machine.limits)}};
  json["tests"] = Json::array();
  for (const ShownTest& test : tests) json["tests"].push_back(test_json(machine, test));
  return json;
}

}  // namespace plumbline::report
