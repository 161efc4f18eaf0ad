#include "diagnose/candidates/run_columns.hpp"

#include "diagnose/candidates/kind.hpp"

namespace plumbline::diagnose {

Eigen::MatrixXd RunColumns::all() const {
  const auto count = static_cast<Eigen::Index>(candidates.columns.size());
  Eigen::MatrixXd all(equations.residual.size(), count + 1);
  for (Eigen::Index c = 0; c < equations.slopes.cols(); ++c) {
    all.col(c) = scale(static_cast<int>(c)) * equations.slopes.col(c);
  }
  for (const Candidate& candidate : candidates.all) candidate.kind->fill(*this, candidate, all);
  all.col(count) = equations.residual;
  return all;
}

}  // namespace plumbline::diagnose
