// How strongly an effect shows in the readings of a plan, after the set-up and all that the model's owner does not know
// took what they can of it.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <Eigen/Cholesky>

#include "truth/catalogue.hpp"
#include "truth/plan.hpp"

namespace truth {

/// What counts for one, of a sample of bar and motor.
struct Floor {
  double radial = 1.01e-6;  // m
  double torque = 0.101;    // N m
};

/// All readings of a plan as one column, each divided by its floor, ball and bar of every run projected out.
using Column = Eigen::VectorXd;

class Strength {
 public:
  /// Linearises the readings about the model on that plan.
  Strength(const Model& model, const Plan& plan, const Floor& floor = {});

  /// What a machine reads with an effect less what it reads without.
  Column trace(const Machine& machine, const Flaws& flaws) const;
  /// sqrt(min over the nuisances of |trace - J n|^2 + |n / sigma|^2)
  double snr(const Column& trace) const;
  /// The same, with effects of the catalogue free besides, linear in their parameters.
  double beyond(const Column& trace, const std::vector<std::string>& effects) const;

 private:
  struct Run {
    PlannedRun planned;
    Samples samples;         // of the model
    Eigen::MatrixX4d setup;  // what ball and bar change in the radial readings, orthonormal
  };

  struct Reach {
    Eigen::MatrixXd slopes;  // of the readings, by what the effect can do
    Eigen::MatrixXd left;    // by the nuisances, of them
  };

  Column slope(const Truth& changed) const;
  Column finished(const Column& raw) const;
  const Reach& reach_of(const std::string& effect) const;
  Eigen::MatrixXd left_by_nuisances(const Eigen::MatrixXd& columns) const;

  Truth model_;
  Floor floor_;
  std::vector<Run> runs_;
  Eigen::Index rows_ = 0;
  Eigen::MatrixXd nuisances_;  // each times its sigma
  Eigen::LLT<Eigen::MatrixXd> normal_;
  mutable std::map<std::string, Reach> reaches_;
};

}  // namespace truth
