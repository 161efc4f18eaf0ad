#include "jobs/expected/tip_box.hpp"

#include <cmath>
#include <numeric>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "base/diagnostic.hpp"
#include "base/parallel.hpp"
#include "base/text/number_text.hpp"
#include "base/units.hpp"
#include "machine/axis_words.hpp"
#include "machine/forward.hpp"
#include "machine/limits.hpp"
#include "physics/error.hpp"

namespace plumbline::jobs {
namespace {

using machine::Range;

constexpr double kFurthestEnd = 50;  // m
constexpr double kSteepest = 90 * kDeg;
constexpr double kMiddleShare = 0.5;  // of the travel, where nobody states a box

Range middle_of(const Range& travel) {
  const double inset = (1 - kMiddleShare) / 2 * (travel.upper - travel.lower);
  return {travel.lower + inset, travel.upper - inset};
}

std::array<Range, 3> box_of(const machine::MachineModel& model, const TipBoxOptions& options) {
  std::array<Range, 3> box;
  for (std::size_t a = 0; a < 3; ++a) {
    box[a] = options.box[a] ? *options.box[a] : middle_of(model.limits.travel[a]);
    const auto [lower, upper] = box[a];
    // what is no number is in no range
    if (!(std::abs(lower) <= kFurthestEnd && std::abs(upper) <= kFurthestEnd)) {
      refuse("plan-box",
             fmt::format("{} of the box, {:.4g} to {:.4g} mm, is no range, or further out than any machine",
                         kAxisLetters[a], lower / kMm, upper / kMm),
             "give the box in mm, in the machine's base frame W, where the model has its travel");
    }
    if (!(upper > lower)) {
      refuse("plan-box",
             fmt::format("the box has no width in {}: {} to {} mm", kAxisLetters[a], to_decimal(lower / kMm),
                         to_decimal(upper / kMm)),
             "give the lower end of each axis first, and then a higher one");
    }
  }
  return box;
}

void check_tilt(double tilt) {
  if (tilt >= 0 && tilt <= kSteepest) return;
  refuse("plan-box", fmt::format("a tilt of {:.4g} deg is none", tilt / kDeg),
         "give angles from 0 to 90 deg; the platform is tilted to all four sides");
}

// Tilted so far to all four sides.
std::vector<AxisWords> sides_of(double tilt) {
  if (tilt == 0) return {AxisWords{}};
  std::vector<AxisWords> sides;
  for (const Axis axis : {Axis::A, Axis::B}) {
    for (const double sign : {1.0, -1.0}) sides.emplace_back()[axis] = sign * tilt / kDeg;
  }
  return sides;
}

std::vector<AxisWords> grid_of(const std::array<Range, 3>& box, double tilt, std::size_t points) {
  const auto at = [&](std::size_t axis, std::size_t i) {
    return std::lerp(box[axis].lower, box[axis].upper, static_cast<double>(i) / static_cast<double>(points - 1)) / kMm;
  };
  std::vector<AxisWords> grid;
  for (AxisWords pose : sides_of(tilt)) {
    for (std::size_t i = 0; i < points * points * points; ++i) {
      pose[Axis::X] = at(0, i % points);
      pose[Axis::Y] = at(1, i / points % points);
      pose[Axis::Z] = at(2, i / points / points);
      grid.push_back(pose);
    }
  }
  return grid;
}

// What is the same for all poses.
class Stander {
 public:
  Stander(const machine::MachineModel& model, const identify::Unknowns& unknowns)
      : model_(model),
        forces_(unknowns.at(unknowns.start())),
        sensitivity_(forces_, unknowns),
        at_rest_(forces_.environment()),
        side_(machine::side_of(model.geometry, machine::home_pose(model))) {
    at_rest_.friction = false;
  }
  Stander(const Stander&) = delete;  // the sensitivity refers to the forces beside it
  Stander& operator=(const Stander&) = delete;

  // No columns, and why: the machine cannot stand there.
  std::pair<Eigen::Matrix3Xd, std::string> slopes_at(const AxisWords& words) const {
    physics::Motion<double> motion;
    motion.pose = machine::pose_of(model_.rotation, words);
    const auto broken = machine::check_compensated(model_.limits, model_.geometry, motion.pose);
    if (!broken.empty()) return {{}, machine::to_text(broken.front())};
    if (machine::side_of(model_.geometry, motion.pose) != side_) return {{}, "it lies beyond a singularity"};
    const physics::TipError<double> error = physics::tip_error(forces_, at_rest_, motion);
    if (!error.converged()) return {{}, "there the machine gives way"};
    identify::Slopes slopes(identify::kOutcomes, sensitivity_.unknowns());
    sensitivity_.at(at_rest_, motion, error, slopes);
    return {slopes.middleRows<3>(identify::kTipRow), {}};
  }

 private:
  const machine::MachineModel& model_;
  physics::ForceModel forces_;
  identify::Sensitivity sensitivity_;
  physics::Environment at_rest_;
  int side_;
};

// The figures of variances that come one by one.
class Figures {
 public:
  void add(const Eigen::Matrix3Xd& slopes, const Eigen::MatrixXd& covariance, const AxisWords& pose) {
    const double variance = ((slopes * covariance).array() * slopes.array()).sum();
    sum_ += variance;
    ++count_;
    if (count_ == 1 || variance > worst_) {
      worst_ = variance;
      worst_at_ = pose;
    }
  }
  TipFigures take() const { return {std::sqrt(sum_ / count_), std::sqrt(worst_), worst_at_}; }

 private:
  double sum_ = 0, worst_ = 0, count_ = 0;
  AxisWords worst_at_;
};

}  // namespace

TipBox::TipBox(const machine::MachineModel& model, const identify::Unknowns& unknowns, const TipBoxOptions& options)
    : box_(box_of(model, options)) {
  const Stander stander(model, unknowns);
  for (const double tilt : options.tilts) {
    check_tilt(tilt);
    const std::vector<AxisWords> grid = grid_of(box_, tilt, options.points);
    std::vector<std::pair<Eigen::Matrix3Xd, std::string>> found(grid.size());
    for_each_index(grid.size(), [&](std::size_t i) { found[i] = stander.slopes_at(grid[i]); });
    const std::size_t before = places_.size();
    for (std::size_t i = 0; i < grid.size(); ++i) {
      if (found[i].second.empty()) places_.push_back({grid[i], std::move(found[i].first)});
    }
    poses_ += grid.size();
    if (places_.size() > before) continue;
    refuse(
        "plan-box",
        fmt::format("the machine reaches no pose of the box at a tilt of {} deg: {}", to_decimal(tilt / kDeg),
                    found.front().second),
        "choose a box within the travel of the model, and tilts within tilt_deg: plumbline map says what is in reach",
        {model.document.file});
  }
  AxisWords middle;
  for (std::size_t a = 0; a < 3; ++a) middle[kAllAxes[a]] = std::midpoint(box_[a].lower, box_[a].upper) / kMm;
  auto [slopes, why] = stander.slopes_at(middle);
  if (!why.empty()) {
    refuse("plan-box", fmt::format("no zero can be touched off in the middle of the box: {}", why),
           "choose a box whose middle is in reach, not tilted", {model.document.file});
  }
  middle_ = std::move(slopes);
  mean_square_ = Eigen::MatrixXd::Zero(middle_.cols(), middle_.cols());
  mean_square_touched_off_ = mean_square_;
  for (const Place& place : places_) {
    const Eigen::Matrix3Xd from_middle = place.slopes - middle_;
    mean_square_ += place.slopes.transpose() * place.slopes / static_cast<double>(places_.size());
    mean_square_touched_off_ += from_middle.transpose() * from_middle / static_cast<double>(places_.size());
  }
}

TipOverBox TipBox::with(const Eigen::MatrixXd& covariance) const {
  Figures stands;
  Figures touched_off;
  for (const Place& place : places_) {
    stands.add(place.slopes, covariance, place.pose);
    touched_off.add(place.slopes - middle_, covariance, place.pose);
  }
  return {stands.take(), touched_off.take()};
}

}  // namespace plumbline::jobs
