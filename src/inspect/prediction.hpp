// What some runs say of the machine, and how well that predicts others.
#pragma once

#include <vector>

#include <Eigen/Cholesky>

#include "inspect/linear_runs.hpp"

namespace plumbline::inspect {

/// What is known of a machine: its prior and what runs added, as information about the columns of the prior.
struct Knowledge {
  Eigen::MatrixXd information;
  Eigen::VectorXd pull;  // information times the mean

  explicit Knowledge(const Prior& prior) : information(prior.precision.asDiagonal()), pull(prior.precision.size()) {
    pull.setZero();
  }
  void add(const RunRows& run) {
    information += run.gram;
    pull += run.pull;
  }
  Eigen::VectorXd mean() const { return information.llt().solve(pull); }
};

/// Rows of readings as a knowledge of the machine predicts them: normal with covariance 1 + N C N^T.
class Prediction {
 public:
  /// `slopes` is kept by reference.
  Prediction(const Knowledge& known, const identify::SlopeRows& slopes)
      : Prediction(known, slopes, slopes.transpose() * slopes) {}
  /// The same where slopes^T slopes is known.
  Prediction(const Knowledge& known, const identify::SlopeRows& slopes, const Eigen::MatrixXd& gram)
      : slopes_(slopes), mean_(known.mean()), both_(known.information + gram) {}

  /// `left` less what the mean predicts of it.
  Eigen::VectorXd off(const Eigen::VectorXd& left) const { return left - slopes_ * mean_; }
  /// a . (1 + N C N^T)^-1 b  [Woodbury]
  double product(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const {
    const Eigen::VectorXd Nb = slopes_.transpose() * b;
    const Eigen::VectorXd Na = slopes_.transpose() * a;
    return a.dot(b) - Na.dot(both_.solve(Nb));
  }
  /// product(a, a), in half its time.
  double square(const Eigen::VectorXd& a) const {
    const Eigen::VectorXd Na = slopes_.transpose() * a;
    return a.dot(a) - Na.dot(both_.solve(Na));
  }
  /// The same of each of many columns at once.
  Eigen::VectorXd squares(const Eigen::MatrixXd& A) const {
    const Eigen::MatrixXd NA = slopes_.transpose() * A;
    return (A.colwise().squaredNorm() - both_.matrixL().solve(NA).colwise().squaredNorm()).transpose();
  }
  double chi2(const Eigen::VectorXd& left) const { return square(off(left)); }
  const Eigen::VectorXd& mean() const { return mean_; }
  /// The same of many columns at once: A^T (1 + N C N^T)^-1 B
  Eigen::MatrixXd products(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) const {
    const Eigen::MatrixXd NA = slopes_.transpose() * A;
    if (&A == &B) return A.transpose() * A - NA.transpose() * both_.solve(NA);
    return A.transpose() * B - NA.transpose() * both_.solve(slopes_.transpose() * B);
  }

 private:
  const identify::SlopeRows& slopes_;
  Eigen::VectorXd mean_;
  Eigen::LLT<Eigen::MatrixXd> both_;
};

/// The spread of each effect's numbers that makes the runs most likely, within what the prior allows: an effect that
/// they do not need shrinks to nothing, so that one run alone cannot hide behind it  [MacKay 1992, evidence framework].
void fit_spreads(Prior& prior, const std::vector<const RunRows*>& runs, int rounds);

}  // namespace plumbline::inspect
