#include "identify/equations/fitted_directions.hpp"

#include <cmath>

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include "base/parallel.hpp"
#include "identify/equations/whitening.hpp"

namespace plumbline::identify {
namespace {

constexpr double kLeastPrecision = 1e-14;   // of the largest: less counts as unknown
constexpr double kLeastSetupSlope = 1e-12;  // of the largest: a frame's shift turns no platform

// The information of one channel of one run, its set-up out, in scales of the unknowns.
Eigen::MatrixXd channel_information(const RunEquations& run, int channel, const FittedUnknowns& fitted) {
  const std::optional<Eigen::Index> first = run.first_row(channel);
  const Eigen::Index unknowns = fitted.scales.size();
  if (!first) return Eigen::MatrixXd::Zero(unknowns, unknowns);
  const ChannelNoise& noise = fitted.noise.channels[static_cast<std::size_t>(channel)];
  SlopeRows slopes = run.slopes.middleRows(*first, run.samples) * fitted.scales.asDiagonal();
  whiten(noise, slopes);
  if (*first < run.setup_slopes.rows()) {
    Eigen::MatrixXd setup = run.setup_slopes.middleRows(*first, run.samples);
    whiten(noise, setup);
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(setup);
    qr.setThreshold(kLeastSetupSlope);
    const Eigen::MatrixXd Q = qr.householderQ() * Eigen::MatrixXd::Identity(run.samples, qr.rank());
    slopes -= Q * (Q.transpose() * slopes).eval();
  }
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(unknowns, unknowns);
  information.selfadjointView<Eigen::Lower>().rankUpdate(slopes.transpose());
  return information.selfadjointView<Eigen::Lower>();
}

}  // namespace

FittedDirections fitted_directions(const std::vector<RunEquations>& runs, int channel, const FittedUnknowns& fitted,
                                   double least_share) {
  std::vector<Eigen::MatrixXd> each(runs.size());
  for_each_index(runs.size(), [&](std::size_t i) { each[i] = channel_information(runs[i], channel, fitted); });
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(fitted.scales.size(), fitted.scales.size());
  for (const Eigen::MatrixXd& run : each) information += run;

  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> known(fitted.precision);
  const double least = kLeastPrecision * known.eigenvalues().maxCoeff();
  const Eigen::VectorXd deviation =
      known.eigenvalues().unaryExpr([least](double value) { return value > least ? 1 / std::sqrt(value) : 0; });
  const Eigen::MatrixXd whole = known.eigenvectors() * deviation.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> shares(whole.transpose() * information * whole);

  FittedDirections directions;
  directions.degrees = shares.eigenvalues().cwiseMax(0.0).cwiseMin(1.0).sum();
  const auto kept = (shares.eigenvalues().array() > least_share).count();  // ascending: the last ones
  directions.share = shares.eigenvalues().tail(kept).cwiseMin(1.0);
  directions.changes = fitted.scales.asDiagonal() * whole * shares.eigenvectors().rightCols(kept);
  return directions;
}

}  // namespace plumbline::identify
