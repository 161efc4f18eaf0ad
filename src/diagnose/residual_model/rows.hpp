// Components as rows of a model: of the effect `residual`, or `generic` for what is a formula.
#pragma once

#include "diagnose/residual_model/learner.hpp"
#include "physics/force_model.hpp"

namespace plumbline::diagnose {

/// A number of a row, and how it moves with the weights of its component.
struct RowNumber {
  std::string_view effect, key;
  int index = 0;
  int row = 0;  // of the rows of that effect
  Eigen::RowVectorXd by_weights;
  double sigma = 0;  // beforehand, SI
};

/// Adds the rows of a component; says which numbers its weights are.
std::vector<RowNumber> add_rows(const Component& component, physics::ForceModel& forces);

/// What was learnt beside the base model as a sum of functions.
struct LearntResidual {
  std::vector<Component> components;
  std::vector<RowNumber> numbers;  // of the rows that stand for them in the model
  Eigen::MatrixXd covariance;      // of the nuisances and these numbers, SI
  Eigen::MatrixXd of_weights;      // of all weights, component after component, SI
};

}  // namespace plumbline::diagnose
