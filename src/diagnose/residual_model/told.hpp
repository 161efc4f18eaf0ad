// What was learnt, function by function, for those who tell or draw it.
#pragma once

#include "diagnose/residual_model/law.hpp"
#include "diagnose/residual_model/rows.hpp"

namespace plumbline::diagnose {

/// A function somewhere in the region that was measured.
struct FunctionValue {
  std::vector<double> at;  // the coordinates, in their units
  double value = 0;        // SI of the channel
  double sigma = 0;        // standard error
};

/// One function of one strut or axis; or a formula.
struct LearntFunction {
  Shape shape;
  int part = -1;                     // -1: all struts alike
  bool mean_aside = false;           // its values are those beside its mean over the region
  FunctionValue least, most;         // where it is smallest and largest
  std::vector<FunctionValue> along;  // of one coordinate: from the lower end of the region to the upper one
  std::vector<Term> formula;         // where it is one: no values then
  std::optional<PowerLaw> law;       // where it is a power of its coordinate
  double log_odds = 0;               // nats, of its component
  double left_out = 0;               // nats, on poses that were left out
};

std::vector<LearntFunction> functions_of(const LearntResidual& learnt, const physics::MachineConstants& machine);

}  // namespace plumbline::diagnose
