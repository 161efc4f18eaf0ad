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

/// What all products have in common with the columns of a problem, and their squared lengths: kept, as a problem may
/// get columns more. The runs, the machine and the noise must outlive it.
class ProductSums {
 public:
  ProductSums(const std::vector<ReadyRun>& runs, const physics::MachineConstants& machine,
              const identify::NoiseModel& noise)
      : runs_(runs), machine_(machine), noise_(noise) {}

  /// See best_products(). From call to call the columns of the nuisances may become more, all others stay.
  std::vector<Term> best(const LinearProblem& problem, const Nuisances& nuisances, const DescriptionOptions& options,
                         double& tried);
  /// The factors of a term on each part of its channel: with the nuisances of the last call and, last, the residual.
  Eigen::MatrixXd cross_of(const Term& term) const;

 private:
  struct Sums {  // a column for each term, part after part
    Eigen::MatrixXd cross;
    Eigen::VectorXd squares;
  };
  void add(const LinearProblem& problem, const std::vector<int>& columns);

  const std::vector<ReadyRun>& runs_;
  const physics::MachineConstants& machine_;
  const identify::NoiseModel& noise_;
  std::vector<Sums> sums_;  // of each family of products
};

/// The products of which each alone takes most of the misfit when the nuisances are fitted beside it, strongest first;
/// adds how many were tried. A column D f of a channel, D how readings move with it and f the product, whitened by W,
/// has W D f . n = f . D^T (W^T n) in common with a column n: so all products go by f, which is as long as a run has
/// samples, and not by what readings it has.
std::vector<Term> best_products(const std::vector<ReadyRun>& runs, const physics::MachineConstants& machine,
                                const LinearProblem& problem, const Nuisances& nuisances,
                                const identify::NoiseModel& noise, const DescriptionOptions& options, double& tried);

}  // namespace plumbline::diagnose
