#include "truth/motion.hpp"

#include <cmath>

namespace truth {
namespace {

constexpr double kSignSpeed = 2e-5;      // m/s
constexpr double kBristle = 4e-6;        // m of travel over which friction turns
constexpr double kStribeckShare = 0.15;  // more at rest
constexpr double kStribeckSpeed = 2e-3;  // m/s

}  // namespace

Rotation turned(const Vec& abc) {
  return (Eigen::AngleAxisd(abc.z(), Vec::UnitZ()) * Eigen::AngleAxisd(abc.y(), Vec::UnitY()) *
          Eigen::AngleAxisd(abc.x(), Vec::UnitX()))
      .toRotationMatrix();
}

Stand commanded(const Circle& circle, double angle) {
  return {circle.centre + circle.radius * Vec(std::cos(angle), std::sin(angle), 0), turned(circle.abc)};
}

Path path_of(const Circle& circle) {
  return [circle](double seconds) { return commanded(circle, circle.turn * circle.feed / circle.radius * seconds); };
}

Follower::Follower(const Machine& machine, Path path, double piece, FrictionLaw law)
    : machine_(machine), path_(std::move(path)), piece_(piece), law_(law) {}

Vec6 Follower::told(double seconds) const { return believed_lengths(machine_, path_(seconds)); }

// Dahl's bristle: dz = (sign(dL) - z) |dL| / length, which integrates to an exponential of the travel
void Follower::follow(double seconds) {
  const double step = 10 * piece_;
  while (now_ < seconds) {
    now_ = std::min(now_ + step, seconds);
    const Vec6 told_now = told(now_);
    const Vec6 travel = told_now - last_told_;
    for (int j = 0; j < 6; ++j) {
      const double way = travel[j] < 0 ? -1 : 1;
      bristle_[j] = way + (bristle_[j] - way) * std::exp(-std::abs(travel[j]) / kBristle);
    }
    last_told_ = told_now;
  }
}

Moment Follower::at(double seconds, double start, double payload) {
  const double h = piece_;
  const Stand before = path_(seconds - h);
  const Stand here = path_(seconds);
  const Stand after = path_(seconds + h);
  Moment m;
  m.commanded = here;
  m.told = believed_lengths(machine_, here);
  const Vec6 told_before = believed_lengths(machine_, before);
  const Vec6 told_after = believed_lengths(machine_, after);
  m.speed = (told_after - told_before) / (2 * h);
  m.acceleration = (told_after - 2 * m.told + told_before) / (h * h);
  m.tip_acceleration = (after.x - 2 * here.x + before.x) / (h * h);
  for (std::size_t j = 0; j < 6; ++j) {
    const Vec arm = machine_.believed_platform[j] - machine_.tip;
    const Vec v = (after.x + after.R * arm - before.x - before.R * arm) / (2 * h);
    const Vec u = (here.x + here.R * arm - machine_.believed_base[j]).normalized();
    m.across.col(static_cast<int>(j)) = v - u.dot(v) * u;
  }
  m.time = start + seconds;
  m.payload = payload;
  if (law_ == FrictionLaw::tanh) {
    m.sign = (m.speed.array() / kSignSpeed).tanh();
  } else if (law_ == FrictionLaw::root) {
    m.sign = m.speed.array() / (m.speed.array().square() + kSignSpeed * kSignSpeed).sqrt();
  } else {
    if (!started_) {  // the machine came to its start along the way on which it goes on
      started_ = true;
      now_ = seconds;
      last_told_ = m.told;
      bristle_ = (m.told - told_before).cwiseSign();
    }
    follow(seconds);
    m.sign = bristle_;
    if (law_ == FrictionLaw::stribeck) {
      m.sign.array() *= 1 + kStribeckShare * (-(m.speed.array() / kStribeckSpeed).square()).exp();
    }
  }
  return m;
}

Reading reading_at(const Truth& truth, const Stand& at, const Moment& moment, const Vec& ball, double bar) {
  Reading reading;
  reading.radial = (tip_ball(truth, at, moment) - ball).norm() - bar;
  const Loads there = loads(truth, at, moment);
  for (std::size_t j = 0; j < 6; ++j) reading.torque[j] = there.torque[static_cast<int>(j)];
  return reading;
}

}  // namespace truth
