#include "identify/held.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include "identify/geometry.hpp"

namespace plumbline::identify {
namespace {

// Of what may take a change back when the rest keeps its values: V_aa - V_ab V_bb^-1 V_ba.
Eigen::MatrixXd given_the_rest(const Eigen::MatrixXd& V, const std::vector<Eigen::Index>& taking,
                               const std::vector<Eigen::Index>& rest) {
  Eigen::MatrixXd own = V(taking, taking);
  if (rest.empty()) return own;
  const Eigen::MatrixXd cross = V(rest, taking);
  return own - cross.transpose() * Eigen::MatrixXd(V(rest, rest)).completeOrthogonalDecomposition().solve(cross);
}

// Of a change of the tip, when the machine is `found` from the model as given, with this root of a covariance.
TipGain gain(const Eigen::VectorXd& found, const Eigen::MatrixXd& spread, const Eigen::VectorXd& change) {
  const double deviation = 2 * (spread.transpose() * change).norm();
  const double mean = 2 * change.dot(found) - change.squaredNorm();
  return {change.norm(), spread.norm(), deviation > 0 ? mean / deviation : 0};
}

// The mean over all places, of a field that is divided by the root of how many they are.
Eigen::MatrixXd mean_of(const Eigen::MatrixXd& field) {
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(3, field.cols());
  const Eigen::Index places = field.rows() / 3;
  for (Eigen::Index i = 0; i < places; ++i) sum += field.middleRows<3>(3 * i);
  return sum / std::sqrt(static_cast<double>(places));
}

// The axes along which a shift of that covariance is not surely on the side that it seems to be on, as columns.
Eigen::MatrixXd unsure_axes(const Eigen::Vector3d& shifted, const Eigen::Matrix3d& S, const HoldOptions& options) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> parts(S);
  Eigen::MatrixXd axes(3, 0);
  for (Eigen::Index i = 0; i < 3; ++i) {
    const double deviation = std::sqrt(std::max(parts.eigenvalues()[i], 0.0));
    if (std::abs(parts.eigenvectors().col(i).dot(shifted)) >= 2 * options.sure_sigmas * deviation) continue;
    axes.conservativeResize(Eigen::NoChange, axes.cols() + 1);
    axes.rightCols(1) = parts.eigenvectors().col(i);
  }
  return axes;
}

// The change b of unknowns with covariance C that makes |G b - s|^2 / t^2 + |F b|^2 / t^2 + b^T C^-1 b least: it undoes
// a shift s and leaves differences between places, F b, within t:
//   b = Q G^T (G Q G^T + t^2)^-1 s,  Q = (C^-1 + F^T F / t^2)^-1
Eigen::VectorXd taken_back(const Eigen::VectorXd& s, const Eigen::MatrixXd& G, const Eigen::MatrixXd& F,
                           const Eigen::MatrixXd& C, const HoldOptions& options) {
  if (s.size() == 0 || C.size() == 0) return Eigen::VectorXd::Zero(C.rows());
  const Eigen::MatrixXd root = root_of(C);
  const Eigen::MatrixXd apart = F * root / options.same_place;
  const Eigen::MatrixXd precision = Eigen::MatrixXd::Identity(C.rows(), C.rows()) + apart.transpose() * apart;
  const Eigen::MatrixXd Q = root * precision.ldlt().solve(root.transpose());
  Eigen::MatrixXd reached = G * Q * G.transpose();
  reached.diagonal().array() += options.same_place * options.same_place;
  return Q * G.transpose() * reached.ldlt().solve(s);
}

}  // namespace

Held hold_unsure(const machine::RotationOrder& order, const std::vector<measure::Run>& runs,
                 const physics::ForceModel& given, const Unknowns& unknowns, const Eigen::VectorXd& values,
                 const Eigen::MatrixXd& covariance, const HoldOptions& options) {
  Held held{values};
  const TipField field = tip_field(order, runs, given, unknowns, values);
  if (field.places() == 0) return held;
  const Eigen::VectorXd scales = unknowns.scales();
  const Eigen::MatrixXd V = scales.cwiseInverse().asDiagonal() * covariance * scales.cwiseInverse().asDiagonal();
  const Eigen::MatrixXd slopes = field.slopes * scales.asDiagonal();
  const TipField part = touched_off(field);
  const Eigen::MatrixXd part_slopes = part.slopes * scales.asDiagonal();
  const Eigen::MatrixXd shift = mean_of(slopes);
  const Eigen::Vector3d shifted = mean_of(field.moved);
  const Eigen::MatrixXd axes = unsure_axes(shifted, shift * V * shift.transpose(), options);

  std::vector<Eigen::Index> taking;
  std::vector<Eigen::Index> rest;
  for (std::size_t i = 0; i < unknowns.size(); ++i) {
    (of_geometry(unknowns[i]) && !unknowns[i].free() ? taking : rest).push_back(static_cast<Eigen::Index>(i));
  }
  const Eigen::VectorXd back = taken_back(axes.transpose() * shifted, axes.transpose() * shift(Eigen::all, taking),
                                          part_slopes(Eigen::all, taking), given_the_rest(V, taking, rest), options);
  for (std::size_t k = 0; k < taking.size(); ++k) {
    const Eigen::Index i = taking[k];
    const Unknown& u = unknowns[static_cast<std::size_t>(i)];
    held.values[i] = std::clamp(values[i] - back[static_cast<Eigen::Index>(k)] * scales[i], u.lower, u.upper);
  }
  held.axes = static_cast<int>(axes.cols());
  held.shift = shifted.norm();
  held.shift_doubt = std::sqrt((shift * V * shift.transpose()).trace());
  held.back = (shift(Eigen::all, taking) * back).norm();
  const Eigen::MatrixXd spread = root_of(V);
  held.whole = gain(field.moved, slopes * spread, field.moved - slopes(Eigen::all, taking) * back);
  held.off_the_part = gain(part.moved, part_slopes * spread, part.moved - part_slopes(Eigen::all, taking) * back);
  return held;
}

}  // namespace plumbline::identify
