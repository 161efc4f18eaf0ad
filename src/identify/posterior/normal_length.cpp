#include "identify/posterior/normal_length.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Eigenvalues>

namespace plumbline::identify {
namespace {

constexpr double kLeastShare = 1e-12;  // of the largest weight: a smaller one is none
constexpr double kNearMean = 1e-3;     // standard deviations of Q off its mean, within which its limit there is taken
constexpr int kHalvings = 60;
constexpr int kBits = 22;       // of a length that are kept
constexpr double kNear = 1e-7;  // of a length, that it is found to

// That a standard deviate lies above x.
double above(double x) { return 0.5 * std::erfc(x / std::numbers::sqrt2); }

// To the digits that are found: the last bits of exp and erfc are not the same on every system, and its steps show
// them.
double rounded(double length) {
  int exponent = 0;
  const double mantissa = std::frexp(length, &exponent);
  return std::ldexp(std::round(std::ldexp(mantissa, kBits)), exponent - kBits);
}

// Where a falling function comes down to `wanted`: inverse quadratic steps where they are safe, else halves
// (Chandrupatla, Advances in Engineering Software 28, 1997).
template <class Function>
double crossing(const Function& falling, double wanted, double low, double high) {
  double a = high;  // the last place
  double b = low;   // one on the other side of the crossing
  double at_a = falling(a) - wanted;
  double at_b = falling(b) - wanted;
  if (at_a > 0 || at_b < 0) return at_a > 0 ? high : low;
  double share = 0.5;
  for (int i = 0; i < kHalvings && at_a != 0 && std::abs(b - a) > kNear * std::max(a, b); ++i) {
    const double x = a + share * (b - a);
    const double at_x = falling(x) - wanted;
    const bool same_side = (at_x < 0) == (at_a < 0);
    const double c = same_side ? a : b;  // the last but one
    const double at_c = same_side ? at_a : at_b;
    if (!same_side) {
      b = a;
      at_b = at_a;
    }
    a = x;
    at_a = at_x;
    const double place = (a - b) / (c - b);
    const double height = (at_a - at_b) / (at_c - at_b);
    const bool is_safe = height * height < place && (1 - height) * (1 - height) < 1 - place;
    const double least = 0.5 * kNear * std::max(a, b) / std::abs(b - a);
    share = is_safe ? at_a / (at_b - at_a) * at_c / (at_b - at_c) +
                          (c - a) / (b - a) * at_a / (at_c - at_a) * at_b / (at_c - at_b)
                    : 0.5;
    share = std::clamp(share, least, 1 - least);
  }
  return rounded(std::abs(at_a) < std::abs(at_b) ? a : b);
}

}  // namespace

NormalLength::NormalLength(const Vector3<double>& mean, const Eigen::Matrix3d& covariance) {
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes;
  axes.computeDirect(covariance);
  weight_ = axes.eigenvalues().array().max(0);
  weight_ = (weight_ > kLeastShare * weight_.maxCoeff()).select(weight_, 0);
  squared_ = (axes.eigenvectors().transpose() * mean).array().square();
}

double NormalLength::rms() const { return std::sqrt((weight_ + squared_).sum()); }

double NormalLength::mean() const {
  const double mean = (weight_ + squared_).sum();
  const double variance = (2 * weight_.square() + 4 * weight_ * squared_).sum();
  if (!(variance > kLeastShare * mean * mean)) return std::sqrt(mean);
  const double degrees = 2 * mean * mean / variance;
  return std::sqrt(2 * mean / degrees) * std::exp(std::lgamma((degrees + 1) / 2) - std::lgamma(degrees / 2));
}

// K(t) = sum of l b^2 t / (1 - 2 l t) - log(1 - 2 l t) / 2
double NormalLength::slope(double t) const {
  const Eigen::Array3d d = 1 - 2 * weight_ * t;
  return (weight_ / d + squared_ / d.square()).sum();
}

// K'(t) = q
double NormalLength::saddlepoint(double q) const {
  const double end = 0.5 / weight_.maxCoeff();
  double low = 0;
  double high = end;
  if (slope(0) > q) {
    high = 0;
    for (low = -end; slope(low) > q; low *= 4) high = low;
  }
  double t = 0.5 * (low + high);
  for (int i = 0; i < kHalvings && high - low > 1e-12 * end; ++i) {
    const Eigen::Array3d d = 1 - 2 * weight_ * t;
    const double off = (weight_ / d + squared_ / d.square()).sum() - q;
    (off < 0 ? low : high) = t;
    const double step = off / (2 * weight_.square() / d.square() + 4 * weight_ * squared_ / d.cube()).sum();
    if (std::abs(step) < 1e-10 * end) break;
    t -= step;
    if (!(t > low && t < high)) t = 0.5 * (low + high);
  }
  return t;
}

double NormalLength::chance_beyond(double length) const {
  const double q = length * length;
  const double mean = (weight_ + squared_).sum();
  const double variance = (2 * weight_.square() + 4 * weight_ * squared_).sum();
  if (!(variance > kLeastShare * mean * mean)) return q < mean ? 1 : 0;
  if (!(q > (weight_ > 0).select(Eigen::Array3d::Zero(), squared_).sum())) return 1;  // along axes that are known
  if (std::abs(q - mean) < kNearMean * std::sqrt(variance)) {
    const double third = (8 * weight_.cube() + 24 * weight_.square() * squared_).sum();
    return 0.5 - third / (6 * std::sqrt(2 * std::numbers::pi * variance) * variance);
  }
  const double t = saddlepoint(q);
  const Eigen::Array3d d = 1 - 2 * weight_ * t;
  const double cumulant = (squared_ * t / d - 0.5 * d.log()).sum();
  const double curvature = (2 * weight_.square() / d.square() + 4 * weight_ * squared_ / d.cube()).sum();
  const double w = std::copysign(std::sqrt(std::max(0.0, 2 * (t * q - cumulant))), t);
  const double v = t * std::sqrt(curvature);
  return std::clamp(above(w + std::log(v / w) / w), 0.0, 1.0);
}

double length_within(std::span<const WeighedLength> parts, double probability) {
  double most = 0;
  for (const WeighedLength& part : parts) most = std::max(most, part.length.rms());
  return crossing(
      [&](double length) {
        double beyond = 0;
        for (const WeighedLength& part : parts) beyond += part.weight * part.length.chance_beyond(length);
        return beyond;
      },
      1 - probability, 0, 10 * most);
}

double number_within(std::span<const WeighedNumber> parts, double probability) {
  double most = 0;
  for (const WeighedNumber& part : parts) most = std::max(most, std::hypot(part.mean, part.sigma));
  return crossing(
      [&](double x) {
        double beyond = 0;
        for (const WeighedNumber& part : parts) {
          const double sigma = std::max(part.sigma, 1e-15);
          beyond += part.weight * (above((x - part.mean) / sigma) + above((x + part.mean) / sigma));
        }
        return beyond;
      },
      1 - probability, 0, 10 * most);
}

}  // namespace plumbline::identify
