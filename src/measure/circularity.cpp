#include "measure/circularity.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/QR>

#include "base/angle.hpp"
#include "base/check.hpp"
#include "measure/minimum_zone.hpp"

namespace plumbline::measure {
namespace {

constexpr int kFewestBeside = 4;  // samples in a half window, for a step between two parabolas

// 1, cos phi, sin phi, cos 2 phi, ... up to that order
Eigen::MatrixXd waves(const Eigen::VectorXd& angle, int highest) {
  Eigen::MatrixXd columns(angle.size(), 2 * highest + 1);
  columns.col(0).setOnes();
  for (int k = 1; k <= highest; ++k) {
    columns.col(2 * k - 1) = (k * angle.array()).cos();
    columns.col(2 * k) = (k * angle.array()).sin();
  }
  return columns;
}

Eigen::VectorXd without_centre(const Profile& profile, const CircleFit& circle) {
  return profile.reading.array() - circle.x * profile.angle.array().cos() - circle.y * profile.angle.array().sin();
}

double width(const Eigen::VectorXd& readings) { return readings.maxCoeff() - readings.minCoeff(); }

}  // namespace

Profile profile_of(const Run& run) {
  PLUMBLINE_CHECK(run.has_radial());
  const auto vector = [](const std::vector<double>& v) {
    return Eigen::Map<const Eigen::VectorXd>(v.data(), static_cast<Eigen::Index>(v.size()));
  };
  return {vector(run.angle), vector(run.radial)};
}

Profile joined(const Profile& a, const Profile& b) {
  Profile both{Eigen::VectorXd(a.angle.size() + b.angle.size()), Eigen::VectorXd(a.angle.size() + b.angle.size())};
  both.angle << a.angle, b.angle;
  both.reading << a.reading, b.reading;
  return both;
}

CircleFit least_squares_circle(const Profile& profile) {
  const Eigen::Vector3d fit = waves(profile.angle, 1).colPivHouseholderQr().solve(profile.reading);
  return {fit[0], fit[1], fit[2]};
}

Eigen::VectorXd without_setup(const Profile& profile, const CircleFit& circle) {
  return without_centre(profile, circle).array() - circle.mean;
}

CircularityFigures circularity_figures(const Profile& profile) {
  CircularityFigures figures;
  figures.circle = least_squares_circle(profile);
  const Eigen::VectorXd about_centre = without_centre(profile, figures.circle);
  figures.least_squares = width(about_centre);
  figures.minimum_zone = minimum_zone(profile.angle, profile.reading).width();
  figures.radial_max = about_centre.maxCoeff();
  figures.radial_min = about_centre.minCoeff();
  return figures;
}

BidirectionalFigures bidirectional_figures(const Profile& ccw, const Profile& cw) {
  const Profile both = joined(ccw, cw);
  const CircleFit circle = least_squares_circle(both);
  return {.minimum_zone = minimum_zone(both.angle, both.reading).width(),
          .least_squares = width(without_centre(both, circle)),
          .mean_radial = circle.mean};
}

std::vector<Harmonic> harmonics(const Profile& profile, int highest) {
  highest = std::min(highest, static_cast<int>((profile.angle.size() - 1) / 2));
  const Eigen::VectorXd fit = waves(profile.angle, highest).colPivHouseholderQr().solve(profile.reading);
  std::vector<Harmonic> found;
  for (int k = 1; k <= highest; ++k) {
    const double cos_part = fit[2 * k - 1];
    const double sin_part = fit[2 * k];
    found.push_back({k, std::hypot(cos_part, sin_part), std::atan2(sin_part, cos_part)});
  }
  return found;
}

std::optional<double> reversal_step(const Profile& profile, double angle, double half_window) {
  // r = a + b d + c d^2 + step/2 sign(d), d = phi - angle
  std::vector<Eigen::Vector4d> rows;
  std::vector<double> readings;
  int before = 0;
  for (Eigen::Index i = 0; i < profile.angle.size(); ++i) {
    const double d = std::remainder(profile.angle[i] - angle, kTurn);
    if (std::abs(d) > half_window || d == 0) continue;
    rows.emplace_back(1, d, d * d, d > 0 ? 0.5 : -0.5);
    readings.push_back(profile.reading[i]);
    before += d < 0 ? 1 : 0;
  }
  if (before < kFewestBeside || static_cast<int>(rows.size()) - before < kFewestBeside) return std::nullopt;
  const auto count = static_cast<Eigen::Index>(rows.size());
  const Eigen::Map<const Eigen::Matrix<double, 4, Eigen::Dynamic>> columns(rows.front().data(), 4, count);
  const Eigen::Map<const Eigen::VectorXd> values(readings.data(), count);
  return Eigen::MatrixXd(columns.transpose()).colPivHouseholderQr().solve(values)[3];
}

}  // namespace plumbline::measure
