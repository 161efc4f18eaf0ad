// One stage of the search: a model with some effects, its fit, its noise, and the linear problem about it.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "diagnose/search/search_options.hpp"

namespace plumbline::diagnose {

/// What is told meanwhile; either may be empty.
struct Say {
  std::function<void(const std::string&)> step = {};   // each step with its figures, as it is done
  std::function<void(const std::string&)> doing = {};  // what is begun, in the words of those who wait for it

  void operator()(const std::string& done) const {
    if (step) step(done);
  }
  void begin(const std::string& what) const {
    if (doing) doing(what);
  }
};

struct FittedStage {
  std::vector<Pick> picks;
  Refit fit;
  identify::NoiseModel noise;
  std::shared_ptr<LinearProblem> problem;  // about the fit; rows of what the picks may marginalise
};

/// Fits these picks from `start`, estimates the noise anew from what they leave, and takes all slopes there. `noise` is
/// what it was before; where no channel has any, it begins with what the model as stated leaves.
FittedStage fitted_stage(const Workbench& bench, std::vector<Pick> picks, const Eigen::VectorXd& start,
                         const identify::NoiseModel& noise, const SearchOptions& options, const Say& say);

}  // namespace plumbline::diagnose
