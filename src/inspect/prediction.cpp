#include "inspect/prediction.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace plumbline::inspect {

void fit_spreads(Prior& prior, const std::vector<const RunRows*>& runs, int rounds) {
  const auto count = static_cast<Eigen::Index>(prior.size());
  Eigen::MatrixXd data = Eigen::MatrixXd::Zero(count, count);
  Eigen::VectorXd pull = Eigen::VectorXd::Zero(count);
  for (const RunRows* run : runs) {
    data += run->gram;
    pull += run->pull;
  }
  for (int round = 0; round < rounds; ++round) {
    Eigen::MatrixXd information = data;
    information.diagonal() += prior.precision;
    const Eigen::LLT<Eigen::MatrixXd> llt(information);
    const Eigen::VectorXd mean = llt.solve(pull);
    const Eigen::VectorXd variance = llt.solve(Eigen::MatrixXd::Identity(count, count)).diagonal();
    // of each effect, its numbers in units of the widest spread that they may have
    std::map<int, std::pair<double, double>> sums;
    for (Eigen::Index i = 0; i < count; ++i) {
      auto& [squares, numbers] = sums[prior.effect[static_cast<std::size_t>(i)]];
      squares += (mean[i] * mean[i] + variance[i]) / (prior.most[i] * prior.most[i]);
      numbers += 1;
    }
    for (Eigen::Index i = 0; i < count; ++i) {
      const auto& [squares, numbers] = sums.at(prior.effect[static_cast<std::size_t>(i)]);
      if (prior.effect[static_cast<std::size_t>(i)] < 0) continue;
      const double spread = std::clamp(prior.most[i] * std::sqrt(squares / numbers), prior.least[i], prior.most[i]);
      prior.precision[i] = 1 / (spread * spread);
    }
  }
}

}  // namespace plumbline::inspect
