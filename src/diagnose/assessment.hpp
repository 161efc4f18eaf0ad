// What a search leaves, and what speaks against it.
#pragma once

#include "diagnose/gaps.hpp"

namespace plumbline::diagnose {

/// A dataset under diagnosis. Kept by reference.
struct Case {
  const std::vector<measure::Run>& runs;
  const std::vector<bool>& out;                      // which of them are held out
  const std::vector<identify::RunEquations>& given;  // what the model as given leaves of them
  const Workbench& bench;                            // with the runs that are fitted
};

struct Assessment {
  StageResiduals residuals;            // with the base model and with what was found
  GapMap gap_map;                      // with the base model
  Description description;             // of what nothing explains beside what was found
  std::optional<Remainder> remainder;  // nuisances that are too far off, or what comes again
  std::optional<Doubt> doubt;          // why effects that were found are not believed; nothing: none was, or they are
  Verdict verdict = Verdict::nothing_missing;
};

Assessment assess(const Case& of, const Model& model, const DiagnoseOptions& options, const Say& say);

}  // namespace plumbline::diagnose
