#include "measure/setup.hpp"

#include <cmath>

#include <Eigen/QR>

namespace plumbline::measure {
namespace {

// Derivatives of the readings |tip - ball| - bar by the ball's x, y, z and the bar.
Eigen::MatrixX4d slopes(const RunSimulation& simulation, const Vector3<double>& ball_W) {
  Eigen::MatrixX4d slopes(static_cast<Eigen::Index>(simulation.samples.size()), 4);
  for (Eigen::Index i = 0; i < slopes.rows(); ++i) {
    const Vector3<double> along = (simulation.samples[static_cast<std::size_t>(i)].tip_W - ball_W).normalized();
    slopes.row(i) << -along.transpose(), -1;
  }
  return slopes;
}

// How much of the column that belongs to the ball's height the other three leave.
double height_share(const Eigen::MatrixX4d& slopes) {
  Eigen::MatrixX3d others(slopes.rows(), 3);
  others << slopes.leftCols<2>(), slopes.col(3);
  const Eigen::VectorXd height = slopes.col(2);
  const Eigen::VectorXd left = height - others * others.colPivHouseholderQr().solve(height);
  return left.norm() / std::sqrt(static_cast<double>(height.size()));
}

}  // namespace

Eigen::VectorXd radial_residuals(const Run& run, const RunSimulation& simulation, const Setup& setup) {
  const Eigen::Map<const Eigen::VectorXd> measured(run.radial.data(), static_cast<Eigen::Index>(run.radial.size()));
  // readings count from the stated length of the bar: a bar that was dL longer reads dL less
  return measured - simulation.radial(setup.ball_W, setup.bar);
}

Setup fit_setup(const Run& run, const RunSimulation& simulation, const SetupOptions& options) {
  Setup setup{ideal_ball(run), run.bar_length()};
  setup.fits_height = height_share(slopes(simulation, setup.ball_W)) > options.least_observable;
  for (setup.iterations = 1; setup.iterations <= options.most_iterations; ++setup.iterations) {
    Eigen::MatrixX4d by = slopes(simulation, setup.ball_W);
    if (!setup.fits_height) by.col(2).setZero();
    const Eigen::Vector4d step = by.colPivHouseholderQr().solve(radial_residuals(run, simulation, setup));
    setup.ball_W += step.head<3>();
    setup.bar += step[3];
    setup.converged = step.cwiseAbs().maxCoeff() <= options.tolerance_m;
    if (setup.converged) break;
  }
  return setup;
}

}  // namespace plumbline::measure
