#include "identify/tip_field.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/parallel.hpp"
#include "identify/equations/sensitivity.hpp"
#include "identify/plausible.hpp"
#include "measure/circular_motion.hpp"

namespace plumbline::identify {
namespace {

// The first run at each pose; of many poses some.
std::vector<std::size_t> one_of_each(const std::vector<measure::Run>& runs, std::size_t most) {
  const std::vector<int> poses = poses_of(runs);
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (poses[i] == static_cast<int>(all.size())) all.push_back(i);
  }
  if (all.size() <= most) return all;
  std::vector<std::size_t> some;
  for (std::size_t k = 0; k < most; ++k) some.push_back(all[k * all.size() / most]);
  return some;
}

// As many about each pose.
std::vector<std::vector<physics::Motion<double>>> motions_over(const machine::RotationOrder& order,
                                                               const std::vector<measure::Run>& runs,
                                                               const TipFieldOptions& options) {
  const std::vector<std::size_t> first = one_of_each(runs, options.most_circles);
  const std::size_t tilts = std::min(options.tilts, first.size());
  Vector3<double> middle = Vector3<double>::Zero();
  Vector3<double> middle_tilt = Vector3<double>::Zero();
  for (const std::size_t i : first) {
    middle += runs[i].centre_W / static_cast<double>(first.size());
    middle_tilt += runs[i].tilt / static_cast<double>(first.size());
  }
  std::vector<std::vector<physics::Motion<double>>> motions(first.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    measure::Run run = runs[first[i]];
    run.centre_W = middle + options.middle * (run.centre_W - middle);
    run.radius *= options.middle;
    run.angle.clear();
    run.signs.clear();
    for (std::size_t a = 0; a < options.angles; ++a)
      run.angle.push_back(2 * std::numbers::pi * static_cast<double>(a) / static_cast<double>(options.angles));
    run.time.assign(options.angles, 0);
    run.start = 0;
    for (std::size_t t = 0; t < tilts; ++t) {
      run.tilt = middle_tilt +
                 options.middle * (runs[first[(i + t * first.size() / tilts) % first.size()]].tilt - middle_tilt);
      run.direction = t % 2 == 0 ? measure::Direction::ccw : measure::Direction::cw;
      for (std::size_t a = 0; a < options.angles; ++a) motions[i].push_back(measure::circular_motion(order, run, a));
    }
  }
  return motions;
}

}  // namespace

TipField tip_field(const machine::RotationOrder& order, const std::vector<measure::Run>& runs,
                   const physics::ForceModel& given, const Unknowns& unknowns, const Eigen::VectorXd& values,
                   const TipFieldOptions& options) {
  const physics::ForceModel after = unknowns.at(values);
  const Sensitivity sensitivity(after, unknowns);
  physics::Environment environment = after.environment();
  environment.dynamic = false;
  std::vector<physics::Motion<double>> motions;
  std::vector<std::size_t> pose;
  const auto about = motions_over(order, runs, options);
  for (std::size_t i = 0; i < about.size(); ++i) {
    motions.insert(motions.end(), about[i].begin(), about[i].end());
    pose.resize(motions.size(), i);
  }
  std::vector<Slopes> slopes(motions.size());
  std::vector<Vector3<double>> moved(motions.size());
  for_each_index(motions.size(), [&](std::size_t i) {
    const physics::TipError<double> from = physics::tip_error(given, environment, motions[i]);
    const physics::TipError<double> to = physics::tip_error(after, environment, motions[i]);
    if (!from.converged() || !to.converged()) return;
    moved[i] = to.pose.p_WT - from.pose.p_WT;
    slopes[i].resize(kOutcomes, sensitivity.unknowns());
    sensitivity.at(environment, motions[i], to, slopes[i]);
  });
  const auto size = static_cast<Eigen::Index>(motions.size());
  TipField field{Eigen::VectorXd(3 * size), Eigen::MatrixXd(3 * size, sensitivity.unknowns()),
                 std::vector<Eigen::Index>(about.size(), 0)};
  Eigen::Index n = 0;
  for (std::size_t i = 0; i < motions.size(); ++i) {
    if (slopes[i].size() == 0) continue;
    field.moved.segment<3>(3 * n) = moved[i];
    field.slopes.middleRows<3>(3 * n) = slopes[i].middleRows<3>(kTipRow);
    ++field.at_pose[pose[i]];
    ++n;
  }
  const double root = std::sqrt(static_cast<double>(std::max<Eigen::Index>(n, 1)));
  return {field.moved.head(3 * n) / root, field.slopes.topRows(3 * n) / root, std::move(field.at_pose)};
}

TipField touched_off(TipField field) {
  const Eigen::Index n = field.places();
  const auto centre = [n](Eigen::Ref<Eigen::MatrixXd> columns) {
    Eigen::MatrixXd mean = Eigen::MatrixXd::Zero(3, columns.cols());
    for (Eigen::Index i = 0; i < n; ++i) mean += columns.middleRows<3>(3 * i) / static_cast<double>(n);
    for (Eigen::Index i = 0; i < n; ++i) columns.middleRows<3>(3 * i) -= mean;
  };
  centre(field.moved);
  centre(field.slopes);
  return field;
}

std::vector<TipField> parts_of(const TipField& field) {
  std::vector<TipField> parts;
  Eigen::Index first = 0;
  for (const Eigen::Index count : field.at_pose) {
    if (count == 0) continue;
    const double scale = std::sqrt(static_cast<double>(field.places()) / static_cast<double>(count));
    parts.push_back({scale * field.moved.segment(3 * first, 3 * count),
                     scale * field.slopes.middleRows(3 * first, 3 * count),
                     {count}});
    first += count;
  }
  return parts;
}

}  // namespace plumbline::identify
