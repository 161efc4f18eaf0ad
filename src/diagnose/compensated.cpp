#include "diagnose/compensated.hpp"

#include <algorithm>

#include "measure/simulation.hpp"

namespace plumbline::diagnose {
namespace {

double circularity_of(const measure::Profile& profile) {
  const Eigen::VectorXd rest = measure::without_setup(profile, measure::least_squares_circle(profile));
  return rest.maxCoeff() - rest.minCoeff();
}

}  // namespace

measure::Profile compensated_profile(const machine::RotationOrder& order, const measure::Run& run,
                                     const physics::ForceModel& forces, const CompensatedOptions& options) {
  physics::Environment environment = measure::environment_of(forces, run);
  environment.dynamic = false;
  environment.sign_speed = std::max(environment.sign_speed, options.sign_width_of_feed * run.feed);
  const Vector3<double> ball = measure::ideal_ball(run);
  measure::Profile profile = measure::profile_of(run);
  for (std::size_t i = 0; i < run.samples(); ++i) {
    physics::Motion<double> motion = measure::circular_motion(order, run, i);
    motion.signs = nullptr;  // friction turns around as slowly as in a compensated program
    const Vector3<double> stands = physics::tip_error(forces, environment, motion).pose.p_WT;
    profile.reading[static_cast<Eigen::Index>(i)] -= (stands - ball).norm() - (motion.pose.p_WT - ball).norm();
  }
  return profile;
}

std::optional<double> compensated_circularity(const machine::RotationOrder& order, const measure::Run& run,
                                              const physics::ForceModel& forces, const CompensatedOptions& options) {
  if (!run.has_radial()) return std::nullopt;
  return circularity_of(compensated_profile(order, run, forces, options));
}

std::optional<double> measured_circularity(const measure::Run& run) {
  if (!run.has_radial()) return std::nullopt;
  return circularity_of(measure::profile_of(run));
}

}  // namespace plumbline::diagnose
