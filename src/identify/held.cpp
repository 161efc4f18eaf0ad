#include "identify/held.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/QR>

#include "identify/fit.hpp"
#include "identify/unknowns/geometry.hpp"

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
  return {change.norm(), spread.norm(), deviation > 0 ? mean / deviation : 0, 0};
}

// The mean over all places, of a field that is divided by the root of how many they are.
Eigen::MatrixXd mean_of(const Eigen::MatrixXd& field) {
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(3, field.cols());
  const Eigen::Index places = field.rows() / 3;
  for (Eigen::Index i = 0; i < places; ++i) sum += field.middleRows<3>(3 * i);
  return sum / std::sqrt(static_cast<double>(places));
}

// Parts that are set up about the poses, each as likely as any other. `root`: of the unknowns.
class Parts {
 public:
  Parts(const TipField& field, const Eigen::MatrixXd& root, bool zeros_touched_off = false) : parts_(parts_of(field)) {
    for (TipField& part : parts_) {
      if (zeros_touched_off) part = touched_off(std::move(part));
      spread_.emplace_back(part.slopes * root);
    }
  }

  double chance_of_worse(const Eigen::VectorXd& back, double d) const {
    double sum = 0;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      const TipField& part = parts_[i];
      sum += identify::chance_of_worse(part.moved, spread_[i], part.moved - part.slopes * back, d);
    }
    return sum / static_cast<double>(parts_.size());
  }

 private:
  std::vector<TipField> parts_;
  std::vector<Eigen::MatrixXd> spread_;
};

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

// The change of unknowns (SI) that takes the shift of a field back.
Eigen::VectorXd way_back(const TipField& field, const Unknowns& unknowns, const Eigen::MatrixXd& V,
                         const HoldOptions& options) {
  const Eigen::VectorXd scales = unknowns.scales();
  std::vector<Eigen::Index> taking;
  std::vector<Eigen::Index> rest;
  for (std::size_t i = 0; i < unknowns.size(); ++i) {
    (is_geometry(unknowns[i]) && !unknowns[i].free() ? taking : rest).push_back(static_cast<Eigen::Index>(i));
  }
  Eigen::VectorXd back = Eigen::VectorXd::Zero(scales.size());
  if (taking.empty()) return back;
  const Eigen::MatrixXd slopes = field.slopes * scales.asDiagonal();
  const Eigen::MatrixXd apart = touched_off(field).slopes * scales.asDiagonal();
  back(taking) = taken_back(mean_of(field.moved), mean_of(slopes)(Eigen::all, taking), apart(Eigen::all, taking),
                            given_the_rest(V, taking, rest), options);
  return back.cwiseProduct(scales);
}

}  // namespace

double chance_of_worse(const Eigen::VectorXd& m, const Eigen::MatrixXd& R, const Eigen::VectorXd& f, double d) {
  const double mean = 2 * f.dot(m) - f.squaredNorm();
  const double spared = 2 * d * std::sqrt(m.squaredNorm() + R.squaredNorm()) + d * d;
  const double deviation = 2 * (R.transpose() * f).norm();
  if (deviation == 0) return mean + spared < 0 ? 1 : 0;
  return 0.5 * std::erfc((mean + spared) / deviation / std::numbers::sqrt2);
}

Held hold_unsure(const machine::RotationOrder& order, const std::vector<measure::Run>& runs,
                 const physics::ForceModel& given, const Unknowns& unknowns, const Eigen::VectorXd& values,
                 const Eigen::MatrixXd& covariance, const HoldOptions& options) {
  Held held{values};
  held.found = values;
  const TipField field = tip_field(order, runs, given, unknowns, values, options.places);
  if (field.places() == 0) return held;
  const Eigen::VectorXd scales = unknowns.scales();
  const Eigen::MatrixXd V = scales.cwiseInverse().asDiagonal() * covariance * scales.cwiseInverse().asDiagonal();
  const Eigen::MatrixXd root = scales.asDiagonal() * root_of(V);
  const Parts parts(field, root);
  const Eigen::VectorXd all_back = way_back(field, unknowns, V, options);
  double chance = parts.chance_of_worse(0 * all_back, options.matters);
  for (int step = 1; step <= options.steps && chance > options.may_be_worse; ++step) {
    const double share = static_cast<double>(step) / options.steps;
    const double other = parts.chance_of_worse(share * all_back, options.matters);
    if (other >= chance) continue;
    chance = other;
    held.share = share;
  }
  const Eigen::VectorXd back = held.share * all_back;
  for (std::size_t k = 0; k < unknowns.size(); ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    if (back[i] != 0) held.values[i] = std::clamp(values[i] - back[i], unknowns[k].lower, unknowns[k].upper);
  }
  const Eigen::MatrixXd shift = mean_of(field.slopes);
  held.shift = mean_of(field.moved).norm();
  held.shift_doubt = (shift * root).norm();
  held.back = (shift * back).norm();
  const TipField part = touched_off(field);
  held.whole = gain(field.moved, field.slopes * root, field.moved - field.slopes * back);
  held.off_the_part = gain(part.moved, part.slopes * root, part.moved - part.slopes * back);
  held.whole.chance = chance;
  held.off_the_part.chance = Parts(field, root, true).chance_of_worse(back, options.matters);
  return held;
}

}  // namespace plumbline::identify
