#include "jobs/new_model/assumptions.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "base/text/number_text.hpp"
#include "base/units.hpp"
#include "identify/unknowns/geometry.hpp"
#include "machine/forward.hpp"
#include "machine/model_keys.hpp"
#include "machine/orientation.hpp"

namespace plumbline::jobs {
namespace {

constexpr double kReferenceStrut = 1263.265;  // mm, of the PM-600 in the middle of its travel
constexpr double kStrutRange = 0.25;          // of the length at home
constexpr double kMostTilt = 30;              // deg
constexpr int kTiltDirections = 24;
constexpr int kTravelPoints = 7;       // along each axis
constexpr double kHalf = 0.5;          // 1 sigma of what is assumed, over its value
constexpr int kSignificantDigits = 4;  // of what is scaled

const std::array<const char*, 3> kTravel{"x_mm", "y_mm", "z_mm"};

// A number of the PM-600 and the power of the scale that it grows with.
struct Scaled {
  const char* table;
  const char* key;
  double value;
  int power;
};
// models/pm600-like.toml, which says which of them are printed by Ibaraki et al.
constexpr std::array kScaled{
    Scaled{"platform", "mass_kg", 100, 3},
    Scaled{"strut", "screw_mass_kg", 20, 3},
    Scaled{"strut", "joint_mass_kg", 5.5, 3},
    Scaled{"strut", "motor_mass_kg", 22, 3},
    Scaled{"strut", "motor_arm_mm", 200, 1},
    Scaled{"strut", "joint_length_mm", 120, 1},
    Scaled{"strut", "screw_length_mm", 1500, 1},
    Scaled{"strut", "compliance_per_length_um_N_m", 0.01287, -2},
    Scaled{"strut", "compliance_um_N", 0.00782, -1},
    Scaled{"strut", "coulomb_friction_N", 140, 2},
    Scaled{"strut", "lead_mm", 20, 1},
};

// A key of [uncertainty] and the key that it is about.
struct Known {
  const char* key;
  const char* table;
  const char* of;
};
constexpr std::array kKnown{
    Known{"platform_mass_kg", "platform", "mass_kg"},
    Known{"strut_mass_kg", "strut", "screw_mass_kg"},
    Known{"motor_mass_kg", "strut", "motor_mass_kg"},
    Known{"coulomb_friction_N", "strut", "coulomb_friction_N"},
};

double rounded(double value) {
  if (value == 0) return 0;
  const double unit = std::pow(10.0, std::floor(std::log10(std::abs(value))) - (kSignificantDigits - 1));
  const double ticks = std::round(value / unit);
  // division by a power of ten is exact to the last bit where a product with 0.001 is not
  return unit < 1 ? ticks / std::round(1 / unit) : ticks * unit;
}

void assume(ModelDraft& draft, const char* table, const char* key, std::vector<double> values, std::string why) {
  if (!draft.has(table, key)) draft.put({table, key, std::move(values), "", std::move(why), true, {}});
}

void assume_frames(ModelDraft& draft) {
  if (!draft.has("", "rotation"))
    draft.put({"", "rotation", {}, "ZYX", "R = Rz(C) Ry(B) Rx(A), as most controls turn", true, {}});
  assume(draft, "", "gravity_m_s2", {0, 0, -kStandardGravity}, "standard gravity, Z of the base points up");
  assume(draft, "platform", "tool_tip_mm", {0, 0, 0}, "the origin of P is the gauge point");
}

void find_home(ModelDraft& draft) {
  if (!draft.home_mm.empty()) return;
  for (const char* const key : kTravel) {
    const DraftValue* const range = draft.find("limits", key);
    if (range == nullptr) {
      refuse("draft-missing", "nothing says where the tool tip stands at home",
             "give --home X,Y,Z, in mm in the frame of the base, or a travel for X, Y and Z");
    }
    draft.home_mm.push_back((range->values[0] + range->values[1]) / 2);
  }
  draft.home_note = "the middle of the travel";
}

Pose<double> pose_at(const ModelDraft& draft) {
  Pose<double> pose;
  for (int a = 0; a < 3; ++a) pose.p_WT[a] = draft.home_mm[static_cast<std::size_t>(a)] * kMm;
  return pose;
}

void assume_strut_lengths(ModelDraft& draft, const machine::PerStrut<double>& home) {
  const double shortest = home.minCoeff() / kMm;
  const double longest = home.maxCoeff() / kMm;
  assume(draft, "strut", "length_min_mm", {rounded(shortest * (1 - kStrutRange))},
         fmt::format("a quarter shorter than at home, {} mm", to_decimal(shortest, 1)));
  assume(draft, "strut", "length_max_mm", {rounded(longest * (1 + kStrutRange))},
         fmt::format("a quarter longer than at home, {} mm", to_decimal(longest, 1)));
}

// Within the struts' lengths, and on the side of singularities where home is.
class Reach {
 public:
  explicit Reach(const ModelDraft& draft)
      : geometry_(draft.geometry()),
        shortest_(six(draft, "length_min_mm")),
        longest_(six(draft, "length_max_mm")),
        side_(machine::side_of(geometry_, pose_at(draft))) {
    if (side_ != 0) return;
    refuse("draft-reach", "at home the machine is singular: its struts do not hold the platform",
           "check home, and that joint N of the platform belongs to the strut of joint N of the base");
  }

  bool holds(const Pose<double>& pose) const {
    const machine::PerStrut<double> lengths = machine::strut_lengths<double>(geometry_, pose);
    return (lengths.array() >= shortest_.array()).all() && (lengths.array() <= longest_.array()).all() &&
           machine::side_of(geometry_, pose) == side_;
  }

 private:
  static machine::PerStrut<double> six(const ModelDraft& draft, const char* key) {
    const std::vector<double>& values = draft.find("strut", key)->values;
    machine::PerStrut<double> lengths;
    for (int j = 0; j < machine::kStruts; ++j)
      lengths[j] = values[values.size() == 1 ? 0 : static_cast<std::size_t>(j)] * kMm;
    return lengths;
  }

  machine::Geometry geometry_;
  machine::PerStrut<double> shortest_;
  machine::PerStrut<double> longest_;
  int side_ = 0;
};

void check_home_lengths(const ModelDraft& draft, const machine::PerStrut<double>& home) {
  const DraftValue* const shortest = draft.find("strut", "length_min_mm");
  const DraftValue* const longest = draft.find("strut", "length_max_mm");
  for (std::size_t j = 0; j < machine::kStruts; ++j) {
    const double least = shortest->values[shortest->values.size() == 1 ? 0 : j];
    const double most = longest->values[longest->values.size() == 1 ? 0 : j];
    const double length = home[static_cast<int>(j)] / kMm;
    if (length >= least && length <= most) continue;
    const DraftValue& broken = length < least ? *shortest : *longest;
    refuse("draft-reach",
           fmt::format("at home strut {} is {:.7g} mm long, which is not within {:.7g} to {:.7g} mm", j + 1, length,
                       least, most),
           "check home, the joints, and the lengths of the struts", broken.place);
  }
}

bool tilts(const Reach& reach, Pose<double> pose, double degrees) {
  for (int k = 0; k < kTiltDirections; ++k) {
    const double about = 2 * std::numbers::pi * k / kTiltDirections;
    const Vector3<double> axis(std::cos(about), std::sin(about), 0);
    pose.R_WP = machine::exponential<double>(degrees * kDeg * axis);
    if (!reach.holds(pose)) return false;
  }
  return true;
}

void assume_tilt(ModelDraft& draft, const Reach& reach) {
  if (draft.has("limits", "tilt_deg")) return;
  double degrees = 0;
  while (degrees < kMostTilt && tilts(reach, pose_at(draft), degrees + 1)) ++degrees;
  assume(draft, "limits", "tilt_deg", {degrees},
         fmt::format("as far as the struts let it tilt at home in every direction, at most {:g} deg", kMostTilt));
}

// The travel that is stated, and where none is, home and `half` mm to either side.
std::array<std::array<double, 2>, 3> travel_of(const ModelDraft& draft, double half) {
  std::array<std::array<double, 2>, 3> travel{};
  for (std::size_t a = 0; a < 3; ++a) {
    const DraftValue* const range = draft.find("limits", kTravel[a]);
    if (range != nullptr)
      travel[a] = {range->values[0], range->values[1]};
    else
      travel[a] = {draft.home_mm[a] - half, draft.home_mm[a] + half};
  }
  return travel;
}

bool all_in_reach(const Reach& reach, const std::array<std::array<double, 2>, 3>& travel) {
  for (int i = 0; i < kTravelPoints * kTravelPoints * kTravelPoints; ++i) {
    const std::array<int, 3> at{i % kTravelPoints, i / kTravelPoints % kTravelPoints,
                                i / (kTravelPoints * kTravelPoints)};
    Pose<double> pose;
    for (std::size_t a = 0; a < 3; ++a) {
      const double share = static_cast<double>(at[a]) / (kTravelPoints - 1);
      pose.p_WT[static_cast<int>(a)] = std::lerp(travel[a][0], travel[a][1], share) * kMm;
    }
    if (!reach.holds(pose)) return false;
  }
  return true;
}

void assume_travel(ModelDraft& draft, const Reach& reach, double longest_mm) {
  if (draft.has("limits", "x_mm") && draft.has("limits", "y_mm") && draft.has("limits", "z_mm")) return;
  double half = 0;
  double beyond = std::floor(longest_mm);
  while (beyond - half > 1) {
    const double middle = std::floor((half + beyond) / 2);
    (all_in_reach(reach, travel_of(draft, middle)) ? half : beyond) = middle;
  }
  if (half < 1) {
    refuse("draft-reach", "there is no travel about home that the struts reach",
           "check home, the joints and the lengths of the struts, or give --travel-x, --travel-y and --travel-z");
  }
  const auto travel = travel_of(draft, half);
  for (std::size_t a = 0; a < 3; ++a) {
    assume(draft, "limits", kTravel[a], {travel[a][0], travel[a][1]},
           fmt::format("{:g} mm to either side of home: all of it is in reach, not tilted", half));
  }
}

void assume_parts(ModelDraft& draft, double scale) {
  for (const Scaled& part : kScaled) {
    const bool same = part.power == 1;
    assume(draft, part.table, part.key, {rounded(part.value * std::pow(scale, part.power))},
           fmt::format("the PM-600's {:g} in the scale {:.3f} of the struts at home{}", part.value, scale,
                       same ? "" : fmt::format(", to the power of {}", part.power)));
  }
  const Vector3<double> middle = draft.geometry().platform_joints_P.rowwise().mean() / kMm;
  std::vector<double> centre;
  for (const double coordinate : middle) centre.push_back(from_ticks(to_ticks(coordinate, 3), 3));
  assume(draft, "platform", "centre_of_mass_mm", centre, "the middle of the platform's joints");
}

void assume_sigma(ModelDraft& draft, const char* key, double of, const char* why) {
  const double most = machine::key_spec("uncertainty", key).upper;
  assume(draft, "uncertainty", key, {std::min(rounded(kHalf * of), most)}, why);
}

void assume_uncertainty(ModelDraft& draft) {
  const auto is_assumed = [&](const char* table, const char* key) { return draft.find(table, key)->assumed; };
  const char* const half = "half of the assumed value";
  for (const Known& known : kKnown) {
    if (is_assumed(known.table, known.of)) assume_sigma(draft, known.key, draft.largest(known.table, known.of), half);
  }
  if (is_assumed("strut", "compliance_per_length_um_N_m") || is_assumed("strut", "compliance_um_N"))
    assume_sigma(draft, "compliance_relative", 1, half);
  const identify::GeometryOptions unmeasured;
  const char* const as_calibrate = "joints and lengths that nobody measured, as calibrate takes them";
  assume(draft, "uncertainty", "joint_position_um", {unmeasured.joint_sigma / kUm}, as_calibrate);
  assume(draft, "uncertainty", "strut_offset_um", {unmeasured.offset_sigma / kUm}, as_calibrate);
  if (is_assumed("platform", "centre_of_mass_mm"))
    assume_sigma(draft, "centre_of_mass_mm", machine::platform_radius(draft.geometry()) / kMm,
                 "half of the radius of the platform's joints");
}

}  // namespace

void assume_the_rest(ModelDraft& draft) {
  assume_frames(draft);
  find_home(draft);
  const machine::PerStrut<double> home = machine::strut_lengths<double>(draft.geometry(), pose_at(draft));
  assume_strut_lengths(draft, home);
  const Reach reach(draft);
  check_home_lengths(draft, home);
  assume_travel(draft, reach, home.maxCoeff() / kMm);
  assume_tilt(draft, reach);
  assume_parts(draft, home.mean() / kMm / kReferenceStrut);
  assume_uncertainty(draft);
}

}  // namespace plumbline::jobs
