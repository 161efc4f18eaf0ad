#include "diagnose/description/products.hpp"

#include <catch2/catch.hpp>

#include "diagnose/search/picks.hpp"
#include "diagnose/usual_noise.hpp"
#include "identify/plans.hpp"

namespace plumbline::diagnose {
namespace {

// What a term alone takes of the misfit, nuisances fitted beside it: its column made, whitened and projected.
double gain_of(const Term& term, const std::vector<ReadyRun>& runs, const physics::MachineConstants& machine,
               const LinearProblem& problem, const Marginalised& marginalised, const identify::NoiseModel& noise) {
  const auto nuisances = static_cast<Eigen::Index>(marginalised.columns.size());
  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(nuisances + 1, nuisances + 1);
  Eigen::VectorXd pull = Eigen::VectorXd::Zero(nuisances + 1);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    Eigen::MatrixXd all(runs[i].raw->residual.size(), nuisances + 1);
    all << problem.rows_of(i, marginalised.columns),
        without_setup(*runs[i].raw, change_by(runs[i], machine, term, false), noise);
    gram += all.transpose() * all;
    pull += all.transpose() * problem.blocks[i].rows.rightCols<1>();
  }
  gram.diagonal().head(nuisances) += marginalised.precision;
  pull.head(nuisances) -= marginalised.precision.cwiseProduct(marginalised.departure);
  const Eigen::MatrixXd own = gram.topLeftCorner(nuisances, nuisances);
  return pull.dot(gram.ldlt().solve(pull)) - pull.head(nuisances).dot(own.ldlt().solve(pull.head(nuisances)));
}

TEST_CASE("the gain of a product is that of its column beside the nuisances") {
  testing::Random random(21);
  const machine::MachineModel machine = testing::pm600_like();
  const physics::ForceModel forces(machine);
  std::vector<measure::Run> runs = testing::measured(testing::wider_plan(40), forces, 0.5e-6, 0.05, random);
  runs.resize(5);
  runs[2].radial.clear();
  for (auto& torque : runs[3].torque) torque.clear();
  const CandidateSet candidates = make_candidate_set(machine, forces);
  const Workbench bench{machine, forces, runs, candidates};
  const identify::NoiseModel noise = testing::usual_noise(0.6, 0.2);
  Eigen::VectorXd values = candidates.unknowns.start();
  values[0] += 0.7 * candidates.unknowns[0].sigma;
  const LinearProblem problem =
      linearise(machine.rotation, runs, candidates, values, noise, may_be_marginalised(candidates, {}));
  const Marginalised marginalised = marginalised_by(candidates, {}, values);
  const std::vector<ReadyRun> ready = ready_runs(bench, candidates.unknowns.at(values), problem);
  double tried = 0;
  DescriptionOptions options;
  options.most_looked_at = 100000;
  const std::vector<Term> all =
      best_products(ready, forces.machine, problem, {problem, marginalised}, noise, options, tried);
  CHECK(static_cast<double>(all.size()) == tried);
  CHECK(tried > 2000);
  std::array<int, 5> channels{};
  std::array<int, 8> parts{};
  for (std::size_t t = 0; t < all.size(); t += 37) {
    const Term& term = all[t];
    const double gain = gain_of(term, ready, forces.machine, problem, marginalised, noise);
    CHECK(term.gain == Approx(gain).epsilon(1e-3).margin(1e-3));
    ++channels.at(static_cast<std::size_t>(term.channel));
    ++parts.at(static_cast<std::size_t>(term.part + 1));
  }
  for (const int count : channels) CHECK(count > 0);
  for (std::size_t part = 0; part < 7; ++part) CHECK(parts.at(part) > 0);
}

}  // namespace
}  // namespace plumbline::diagnose
