// Terms of a description that are products of what is known of each sample.
#pragma once

#include <Eigen/Cholesky>

#include "diagnose/description/term_columns.hpp"

namespace plumbline::diagnose {

/// What the nuisances take of the linear problem.
struct Nuisances {
  Nuisances(const LinearProblem& problem, const Marginalised& marginalised);

  std::vector<int> columns;
  Eigen::LDLT<Eigen::MatrixXd> gram;  // data and priors
  Eigen::VectorXd sizes;              // of the residual
};

/// The products of which each alone takes most of the misfit when the nuisances are fitted beside it, strongest first;
/// adds how many were tried. A column D f of a channel, D how readings move with it and f the product, whitened by W,
/// has W D f . n = f . D^T (W^T n) in common with a column n: so all products go by f, which is as long as a run has
/// samples, and not by what readings it has.
std::vector<Term> best_products(const std::vector<ReadyRun>& runs, const physics::MachineConstants& machine,
                                const LinearProblem& problem, const Nuisances& nuisances,
                                const identify::NoiseModel& noise, const DescriptionOptions& options, double& tried);

}  // namespace plumbline::diagnose
