#include "diagnose/description/description.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Cholesky>

#include "base/parallel.hpp"
#include "diagnose/description/products.hpp"
#include "diagnose/description/waves.hpp"
#include "physics/effects/generic.hpp"

namespace plumbline::diagnose {
namespace {

using machine::kStruts;
using physics::Generic;
using Channel = Term::Channel;

constexpr double kRidge = 1e-6;  // of a squared length: terms that are nearly alike stay solvable

class Describer {
 public:
  Describer(const Workbench& bench, const physics::ForceModel& forces, const LinearProblem& problem,
            const Marginalised& marginalised, const identify::NoiseModel& noise, const DescriptionOptions& options)
      : runs_(ready_runs(bench, forces, problem)),
        forces_(forces),
        problem_(problem),
        nuisances_(problem, marginalised),
        noise_(noise),
        options_(options) {}

  Description run() {
    Description found;
    std::vector<Term> best = best_products(runs_, forces_.machine, problem_, nuisances_, noise_, options_, found.tried);
    const std::vector<Term> waves = best_waves(runs_, problem_, noise_, options_, found.tried);
    best.insert(best.end(), waves.begin(), waves.end());
    pick(best, found);
    return found;
  }

 private:
  using Groups = std::vector<std::vector<Eigen::Index>>;

  // Gram matrix of terms with the nuisances and the residual, these taken out.
  struct Projected {
    Eigen::MatrixXd gram;
    Eigen::VectorXd with_residual;
  };
  Projected projected(const std::vector<Term>& terms, const std::vector<bool>& sines) const {
    const auto count = static_cast<Eigen::Index>(terms.size());
    struct Sums {
      Eigen::MatrixXd cross, own;
      Eigen::VectorXd residual;
    };
    std::vector<Sums> sums(runs_.size());
    for_each_index(runs_.size(), [&](std::size_t i) {
      identify::SlopeRows columns(runs_[i].raw->residual.size(), count);
      for (std::size_t t = 0; t < terms.size(); ++t) {
        columns.col(static_cast<Eigen::Index>(t)) = change_by(runs_[i], forces_.machine, terms[t], sines[t]);
      }
      columns = without_setup(*runs_[i].raw, std::move(columns), noise_);
      sums[i].cross = problem_.rows_of(i, nuisances_.columns).transpose() * columns;
      sums[i].residual = columns.transpose() * problem_.blocks[i].rows.rightCols<1>();
      sums[i].own = columns.transpose() * columns;
    });
    Eigen::MatrixXd cross = sums[0].cross;
    Projected all{sums[0].own, sums[0].residual};
    for (std::size_t i = 1; i < sums.size(); ++i) {
      cross += sums[i].cross;
      all.gram += sums[i].own;
      all.with_residual += sums[i].residual;
    }
    all.gram -= cross.transpose() * nuisances_.gram.solve(cross);
    all.with_residual -= cross.transpose() * nuisances_.sizes;
    return all;
  }

  // Forward selection among the foremost, exactly.
  void pick(const std::vector<Term>& best, Description& found) const {
    std::vector<Term> terms;
    std::vector<bool> sines;
    Groups groups;
    for (const Term& term : best) {
      groups.emplace_back();
      for (int part = 0; part < (term.pitch > 0 ? 2 : 1); ++part) {
        groups.back().push_back(static_cast<Eigen::Index>(terms.size()));
        terms.push_back(term);
        sines.push_back(part == 1);
      }
    }
    const Projected p = projected(terms, sines);
    std::vector<Eigen::Index> in;
    std::vector<std::size_t> chosen;
    double before = 0;
    for (int round = 0; round < options_.most_terms; ++round) {
      const auto [which, most] = next_of(p, groups, chosen, in, before);
      if (which == groups.size()) break;
      // one or two numbers more, and the best of so many
      const auto size = static_cast<double>(groups[which].size());
      const double odds =
          0.5 * (most - size - size * std::log(std::max(most / size, 1.0))) - std::log(std::max(found.tried, 1.0));
      if (round == 0) found.log_odds = odds;
      if (odds < options_.least_log_odds) break;
      chosen.push_back(which);
      in.insert(in.end(), groups[which].begin(), groups[which].end());
      before += most;
      found.terms.push_back(best[which]);
      found.terms.back().gain = most;
    }
    found.gain = before;
    if (in.empty()) return;
    const Eigen::VectorXd sizes = solve(p, in);
    Eigen::Index at = 0;
    for (Term& term : found.terms) {
      term.cosine = sizes[at++];
      if (term.pitch > 0) term.sine = sizes[at++];
    }
  }

  // The group that adds most to the gain before, and how much.
  static std::pair<std::size_t, double> next_of(const Projected& p, const Groups& groups,
                                                const std::vector<std::size_t>& chosen,
                                                const std::vector<Eigen::Index>& in, double before) {
    std::pair<std::size_t, double> best{groups.size(), 0};
    for (std::size_t g = 0; g < groups.size(); ++g) {
      if (std::find(chosen.begin(), chosen.end(), g) != chosen.end()) continue;
      std::vector<Eigen::Index> trial = in;
      trial.insert(trial.end(), groups[g].begin(), groups[g].end());
      const double gain = gain_of(p, trial) - before;
      if (gain > best.second) best = {g, gain};
    }
    return best;
  }

  static Eigen::VectorXd solve(const Projected& p, const std::vector<Eigen::Index>& in) {
    Eigen::MatrixXd A = p.gram(in, in);
    const Eigen::VectorXd length = A.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
    A = length.asDiagonal() * A * length.asDiagonal();
    A.diagonal().array() += kRidge;
    return length.cwiseProduct(A.ldlt().solve(length.cwiseProduct(p.with_residual(in))));
  }
  static double gain_of(const Projected& p, const std::vector<Eigen::Index>& in) {
    const Eigen::VectorXd x = solve(p, in);
    return 2 * x.dot(p.with_residual(in)) - x.dot(p.gram(in, in) * x);
  }

  std::vector<ReadyRun> runs_;
  const physics::ForceModel& forces_;
  const LinearProblem& problem_;
  Nuisances nuisances_;
  const identify::NoiseModel& noise_;
  const DescriptionOptions& options_;
};

}  // namespace

Description describe(const Workbench& bench, const physics::ForceModel& forces, const LinearProblem& problem,
                     const Marginalised& marginalised, const identify::NoiseModel& noise,
                     const DescriptionOptions& options) {
  return Describer(bench, forces, problem, marginalised, noise, options).run();
}

std::vector<double> generic_parameters(const Term& term) {
  std::vector<double> p(static_cast<std::size_t>(physics::effect_infos()[physics::effect_index(Generic::name)].size()),
                        0);
  constexpr std::array kFirst{Generic::kLength, Generic::kDrive, Generic::kTorque, Generic::kForce, Generic::kTip};
  const auto first = static_cast<std::size_t>(kFirst.at(static_cast<std::size_t>(term.channel)));
  const double size = term.pitch > 0 ? std::hypot(term.cosine, term.sine) : term.cosine;
  if (term.part >= 0) {
    p[first + static_cast<std::size_t>(term.part)] = size;
  } else {
    for (std::size_t j = 0; j < kStruts; ++j) p[first + j] = size;
  }
  for (std::size_t k = 0; k < term.strut_powers.size(); ++k) p[Generic::kStrutPowers + k] = term.strut_powers[k];
  for (std::size_t k = 0; k < term.shared_powers.size(); ++k) p[Generic::kSharedPowers + k] = term.shared_powers[k];
  if (term.pitch > 0) {
    p[Generic::kPitch] = term.pitch;
    p[Generic::kPhase] = std::atan2(term.sine, term.cosine);
  }
  return p;
}

}  // namespace plumbline::diagnose
