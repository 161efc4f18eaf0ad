// From an assessment to what is handed back: names, or a description beside the base model, and the model with its
// numbers.
#pragma once

#include "diagnose/assessment.hpp"
#include "diagnose/residual_model/rows.hpp"

namespace plumbline::diagnose {

struct Conclusion {
  // named
  std::vector<NamedEffect> effects;
  std::vector<std::string> confidence_set;
  std::string runner_up;
  std::vector<Separation> next;
  // in any case
  physics::ForceModel forces;
  std::vector<double> errors;              // of its parameters, SI
  Marginalised marginalised;               // nuisances, and how far they departed
  std::vector<Pick> picks;                 // what stands in the model beside them,
  Refit fit;                               // and its fit, before a shift was held back
  Description description;                 // of what nothing explains; no terms: nothing is left to tell
  std::optional<LearntResidual> residual;  // that the model has in its place
  StageResiduals residuals;                // with that model
};

Conclusion conclude(const Case& of, const Model& model, Assessment assessment, const DiagnoseOptions& options,
                    const Say& say);

/// Why what was learnt is not to be believed, be it named or not; nothing: nothing speaks against it.
std::optional<Objection> objection_to(const Conclusion& conclusion, const Case& of, Verdict verdict,
                                      const VerdictOptions& options);

}  // namespace plumbline::diagnose
