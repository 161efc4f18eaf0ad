#include "diagnose/evidence/left_out.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

namespace plumbline::diagnose {
namespace {

// Unknowns, what is known of them beforehand, and the runs' Gram matrices of them and the residual.
struct Normal {
  std::vector<int> columns;  // of the problem; the residual last
  Eigen::VectorXd precision, departure;

  // log of the probability of all readings in `gram`, up to what does not depend on the model:
  // -[r.r + z.D z - b.A^-1 b + log det A - log det D] / 2
  double log_evidence(const Eigen::MatrixXd& gram) const {
    const Eigen::Index n = precision.size();
    Eigen::MatrixXd A = gram.topLeftCorner(n, n);
    A.diagonal() += precision;
    const Eigen::VectorXd b = gram.col(n).head(n) - precision.cwiseProduct(departure);
    const Eigen::LLT<Eigen::MatrixXd> llt(A);
    const double determinant = 2 * llt.matrixLLT().diagonal().array().log().sum() - precision.array().log().sum();
    return -0.5 * (gram(n, n) + departure.dot(precision.cwiseProduct(departure)) -
                   llt.matrixL().solve(b).squaredNorm() + determinant);
  }
};

// Sum over groups of log p(group | all others).
double predicted(const LinearProblem& problem, const Normal& normal, const std::vector<int>& groups) {
  const int count = *std::max_element(groups.begin(), groups.end()) + 1;
  const Eigen::MatrixXd all = problem.gram(normal.columns, normal.columns);
  const double together = normal.log_evidence(all);
  double sum = 0;
  for (int group = 0; group < count; ++group) {
    Eigen::MatrixXd others = all;
    for (std::size_t run = 0; run < groups.size(); ++run) {
      if (groups[run] == group) others -= problem.blocks[run].gram(normal.columns, normal.columns);
    }
    sum += together - normal.log_evidence(others);
  }
  return sum;
}

}  // namespace

double left_out_nats(const LinearProblem& problem, const Marginalised& marginalised, const std::vector<int>& columns,
                     const Eigen::VectorXd& sizes, const std::vector<int>& groups) {
  Normal normal{marginalised.columns, marginalised.precision, marginalised.departure};
  normal.columns.push_back(static_cast<int>(problem.residual()));
  const double without = predicted(problem, normal, groups);

  normal.columns.pop_back();
  const double spread2 = std::max(sizes.squaredNorm() / static_cast<double>(sizes.size()), 1e-12);
  for (const int column : columns) {
    // a nuisance that the effect is, too, has the effect's prior in place of its own
    const auto place = std::find(normal.columns.begin(), normal.columns.end(), column) - normal.columns.begin();
    if (place == static_cast<std::ptrdiff_t>(normal.columns.size())) {
      normal.columns.push_back(column);
      normal.precision.conservativeResize(place + 1);
      normal.departure.conservativeResize(place + 1);
      normal.departure[place] = 0;
    }
    normal.precision[place] = 1 / spread2;
  }
  normal.columns.push_back(static_cast<int>(problem.residual()));
  return predicted(problem, normal, groups) - without;
}

}  // namespace plumbline::diagnose
