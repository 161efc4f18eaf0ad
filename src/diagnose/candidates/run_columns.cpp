#include "diagnose/candidates/run_columns.hpp"

#include "diagnose/candidates/kind.hpp"

namespace plumbline::diagnose {

identify::SlopeRows RunColumns::all() const {
  const auto count = static_cast<Eigen::Index>(candidates.columns.size());
  const Eigen::Index unknowns = equations.slopes.cols();
  Eigen::RowVectorXd scales(unknowns);
  for (Eigen::Index c = 0; c < unknowns; ++c) scales[c] = scale(static_cast<int>(c));
  identify::SlopeRows all(equations.residual.size(), count + 1);
  all.leftCols(unknowns) = equations.slopes * scales.asDiagonal();
  for (const Candidate& candidate : candidates.all) candidate.kind->fill(*this, candidate, all);
  all.col(count) = equations.residual;
  return all;
}

}  // namespace plumbline::diagnose
