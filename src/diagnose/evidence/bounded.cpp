#include "diagnose/evidence/bounded.hpp"

#include <vector>

#include <Eigen/Cholesky>

namespace plumbline::diagnose {
namespace {

enum class At : signed char { free, lower, upper };

}  // namespace

Eigen::VectorXd solve_bounded(const Eigen::MatrixXd& A, const Eigen::VectorXd& b, const Eigen::VectorXd& lower,
                              const Eigen::VectorXd& upper) {
  const Eigen::Index n = b.size();
  Eigen::VectorXd x = Eigen::VectorXd::Zero(n).cwiseMax(lower).cwiseMin(upper);
  std::vector<At> at(static_cast<std::size_t>(n), At::free);
  for (Eigen::Index round = 0; round < 10 * n + 10; ++round) {
    std::vector<Eigen::Index> free;
    for (Eigen::Index i = 0; i < n; ++i) {
      if (at[static_cast<std::size_t>(i)] == At::free) free.push_back(i);
    }
    if (!free.empty()) {
      const Eigen::VectorXd step = Eigen::MatrixXd(A(free, free)).ldlt().solve(Eigen::VectorXd((b - A * x)(free)));
      double share = 1;
      Eigen::Index blocking = -1;
      for (std::size_t k = 0; k < free.size(); ++k) {
        const Eigen::Index i = free[k];
        const double d = step[static_cast<Eigen::Index>(k)];
        const double room = d > 0 ? upper[i] - x[i] : lower[i] - x[i];
        if (d != 0 && room / d < share) {
          share = room / d;
          blocking = i;
        }
      }
      for (std::size_t k = 0; k < free.size(); ++k) x[free[k]] += share * step[static_cast<Eigen::Index>(k)];
      if (blocking >= 0) {
        const bool down = x[blocking] - lower[blocking] < upper[blocking] - x[blocking];
        x[blocking] = down ? lower[blocking] : upper[blocking];
        at[static_cast<std::size_t>(blocking)] = down ? At::lower : At::upper;
        continue;
      }
    }
    // every free one at its best: the bound that holds back most is let go
    const Eigen::VectorXd pull = b - A * x;
    double most = 1e-9 * (b.cwiseAbs().maxCoeff() + 1e-300);
    Eigen::Index release = -1;
    for (Eigen::Index i = 0; i < n; ++i) {
      const At here = at[static_cast<std::size_t>(i)];
      const double inward = here == At::lower ? pull[i] : here == At::upper ? -pull[i] : 0;
      if (inward > most && lower[i] < upper[i]) {
        most = inward;
        release = i;
      }
    }
    if (release < 0) break;
    at[static_cast<std::size_t>(release)] = At::free;
  }
  return x;
}

}  // namespace plumbline::diagnose
