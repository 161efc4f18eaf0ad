#include "machine/model_checks.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/units.hpp"
#include "machine/condition.hpp"
#include "machine/inverse.hpp"

namespace plumbline::machine {
namespace {

constexpr double kGravityTolerance = 0.05;  // m/s^2; between the equator and the poles it varies by 0.026 from the mean
constexpr double kSmallestMachine = 10 * kMm;  // no joint circle is smaller
constexpr double kSamePoint = 1 * kUm;
constexpr double kNarrowestTravel = 2 * kMm;
constexpr double kWorstHome = 1e6;  // condition number

void check_gravity(const MachineModel& model) {
  const ModelValue& gravity = model.value("", "gravity_m_s2");
  if (model.gravity.z() > 0) {
    refuse("model-gravity", "gravity points up", "Z of W points up, so gravity's z is negative: [0, 0, -9.80665]",
           model.document.place(gravity.span));
  }
  if (std::abs(model.gravity.norm() - kStandardGravity) > kGravityTolerance) {
    refuse("model-gravity", fmt::format("gravity is {:.6g} m/s^2, which it is nowhere on Earth", model.gravity.norm()),
           "write it in m/s^2: [0, 0, -9.80665], or what is known of the place", model.document.place(gravity.span));
  }
}

bool same_point(const StrutVectors<double>& joints, int i, int j) {
  return (joints.col(i) - joints.col(j)).norm() <= kSamePoint;
}

// Two struts at each of three points, an octahedron's corners: meant, where a slip makes one pair.
bool at_three_points(const StrutVectors<double>& joints) {
  for (int j = 0; j < kStruts; ++j) {
    int others = 0;
    for (int i = 0; i < kStruts; ++i) others += i != j && same_point(joints, i, j) ? 1 : 0;
    if (others != 1) return false;
  }
  return true;
}

// A single joint in metres lies near the origin of its frame: beside the ring or the plane of the others, and on their
// ring a thousand times as far.
bool is_in_metres(const StrutVectors<double>& joints, int j) {
  Eigen::Matrix<double, 3, kStruts - 1> others;
  for (int i = 0; i < kStruts - 1; ++i) others.col(i) = joints.col(i < j ? i : i + 1);
  const Vector3<double> joint = joints.col(j);
  const double size = joint.cwiseAbs().maxCoeff();
  if (size == 0 || size > others.cwiseAbs().maxCoeff() / 100) return false;
  const Vector3<double> centre = others.rowwise().mean();
  const double radius = (others.colwise() - centre).colwise().norm().mean();
  const auto is_on_ring = [&](const Vector3<double>& point, double most) {
    const double share = (point - centre).norm() / radius;
    return share < most && share > 1 / most;
  };
  const Vector3<double> room = Vector3<double>::Constant(0.6 * radius);
  const bool is_beside = ((joint - others.rowwise().maxCoeff() - room).array() > 0).any() ||
                         ((others.rowwise().minCoeff() - room - joint).array() > 0).any();
  return (is_beside || !is_on_ring(joint, 1.25)) && is_on_ring(joint * 1000, 2);
}

void check_joints(const MachineModel& model, std::string_view table, const StrutVectors<double>& joints) {
  const ModelValue& value = model.value(table, "joints_mm");
  if (joints.cwiseAbs().maxCoeff() < kSmallestMachine) {
    refuse("model-unit", fmt::format("all coordinates of the joints of [{}] are below 10 mm", table),
           "joints_mm are in millimetres: multiply metres by 1000", model.document.place(value.span));
  }
  for (int j = 0; j < kStruts; ++j) {
    if (!is_in_metres(joints, j)) continue;
    refuse("model-unit", fmt::format("joint {} of [{}] lies among the others only if it is in metres", j + 1, table),
           "joints_mm are in millimetres: multiply this one by 1000",
           model.document.place(value.spans[3 * static_cast<std::size_t>(j)]));
  }
  if (at_three_points(joints)) return;
  for (int j = 1; j < kStruts; ++j) {
    for (int i = 0; i < j; ++i) {
      if (!same_point(joints, i, j)) continue;
      refuse("model-coincident-joints", fmt::format("joints {} and {} of [{}] are the same point", i + 1, j + 1, table),
             "each strut has a joint of its own, or all six meet two by two at three points: correct the one that was "
             "copied",
             model.document.place(value.spans[3 * static_cast<std::size_t>(j)]));
    }
  }
}

void check_travel(const MachineModel& model) {
  for (const char* key : {"x_mm", "y_mm", "z_mm"}) {
    const ModelValue& range = model.value("limits", key);
    const double width = range.values[1] - range.values[0];
    if (width <= 0) {
      refuse("model-limit-order", fmt::format("[limits] {} ends before it begins", key),
             "write the lower limit first, as [-300, 300]", model.document.place(range.span));
    }
    if (width < kNarrowestTravel) {
      refuse("model-unit", fmt::format("[limits] {} leaves only {:.6g} mm of travel", key, width / kMm),
             "the limits are in millimetres: multiply metres by 1000", model.document.place(range.span));
    }
  }
}

void check_lengths(const MachineModel& model) {
  for (int j = 0; j < kStruts; ++j) {
    if (model.limits.length_min[j] < model.limits.length_max[j]) continue;
    const ModelValue& least = model.value("strut", "length_min_mm");
    refuse("model-length-order", fmt::format("strut {}: length_min_mm is not below length_max_mm", j + 1),
           "length_min_mm is the shortest that a strut may become, length_max_mm the longest",
           model.document.place(least.spans[static_cast<std::size_t>(j)]));
  }
}

void check_home(const MachineModel& model) {
  const StrutGeometry<double> struts = strut_geometry(model.geometry, home_pose(model));
  const TextSpan span = model.value("platform", "joints_mm").span;
  if (struts.length.minCoeff() < kSmallestMachine) {
    refuse("model-singular-home", "in the middle of the travel a strut has no length",
           "check that [base] joints_mm are in W, [platform] joints_mm in P, and the travel is of the tool tip",
           model.document.place(span));
  }
  const double condition = condition_number(struts, platform_radius(model.geometry));
  if (condition < kWorstHome) return;
  refuse("model-singular-home",
         "in the middle of the travel the machine is singular: its struts do not hold the platform",
         "platform joints that repeat the base's hexagon do that: pair each joint of the platform with the base joint "
         "of its strut",
         model.document.place(span));
}

}  // namespace

void check_model(const MachineModel& model) {
  check_gravity(model);
  check_joints(model, "base", model.geometry.base_joints_W);
  check_joints(model, "platform", model.geometry.platform_joints_P);
  check_travel(model);
  check_lengths(model);
  check_home(model);
}

}  // namespace plumbline::machine
