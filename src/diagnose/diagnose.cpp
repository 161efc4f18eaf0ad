#include "diagnose/diagnose.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "base/diagnostic.hpp"
#include "diagnose/conclusion.hpp"
#include "diagnose/doubt.hpp"
#include "diagnose/posterior.hpp"

namespace plumbline::diagnose {
namespace {

using identify::RunEquations;
using measure::Run;

std::vector<Evidence> evidence_of(const Model& model) {
  std::vector<Evidence> all;
  if (model.found.empty()) return all;
  const Found& strongest = model.found.front();
  all.push_back({strongest.pick.candidate->name, strongest.log_odds, strongest.left_out});
  for (const Rival& rival : strongest.rivals) {
    all.push_back({rival.pick.candidate->name, rival.log_odds, rival.left_out});
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Evidence& a, const Evidence& b) { return a.log_odds > b.log_odds; });
  return all;
}

// Nothing is learnt from readings that no machine makes so, nor from data that are spoiled.
template <class Why>
Diagnosis undiagnosed(const machine::MachineModel& machine, const std::vector<Run>& runs, const Why& why,
                      const std::vector<RunEquations>& given, const DiagnoseOptions& options) {
  Diagnosis diagnosis{physics::ForceModel(machine)};
  diagnosis.posterior = posterior_as_given(machine, runs, given);
  const std::vector<bool> out(runs.size(), false);
  const StageResiduals as_given{given, {}, given};
  diagnosis.verdict = Verdict::unknown;
  diagnosis.withheld = why;
  diagnosis.doubt = Doubt{{}, why};
  diagnosis.noise = noise_of(given);
  diagnosis.errors.assign(diagnosis.forces.parameters.size(), 0);
  diagnosis.gap_map = gap_map_of(machine.rotation, runs, diagnosis.forces, given, diagnosis.noise, options.gap_map);
  diagnosis.fit = gap_of(as_given, out, false);
  diagnosis.held_out = gap_of(as_given, out, true);
  diagnosis.runs = run_gaps(machine, runs, out, as_given, diagnosis.forces, options.compensated);
  return diagnosis;
}

void check_measured(const std::vector<Run>& runs) {
  const bool any = std::any_of(runs.begin(), runs.end(), [](const Run& r) { return r.has_radial() || r.has_torque(); });
  if (!any) {
    refuse("diagnose-nothing-measured", "no run of the dataset has a reading of the bar or of the motors",
           "the tables need a column radial_um, or torque1_Nm to torque6_Nm");
  }
}

std::vector<Run> without_those(const std::vector<Run>& runs, const std::vector<bool>& out) {
  std::vector<Run> kept;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (!out[i]) kept.push_back(runs[i]);
  }
  return kept;
}

// All of it, as it is handed back; the model as given where something speaks against what was learnt.
Diagnosis diagnosis_of(const Case& of, const Model& model, Assessment assessment, Conclusion conclusion,
                       const DiagnoseOptions& options) {
  const auto& [machine, forces, fitted, candidates] = of.bench;
  Diagnosis diagnosis(forces);
  diagnosis.verdict = assessment.verdict;
  diagnosis.effects = std::move(conclusion.effects);
  diagnosis.confidence_set = std::move(conclusion.confidence_set);
  diagnosis.evidence = evidence_of(model);
  diagnosis.runner_up = std::move(conclusion.runner_up);
  diagnosis.threshold = model.threshold;
  diagnosis.doubt = std::move(assessment.doubt);
  diagnosis.remainder = std::move(assessment.remainder);
  if (const Description& description = conclusion.description; is_gap(description, options.verdict)) {
    diagnosis.remainder = {std::sqrt(description.gain), description.terms};
  }
  diagnosis.next = std::move(conclusion.next);
  diagnosis.noise = model.noise;
  diagnosis.gap_map = std::move(assessment.gap_map);
  diagnosis.runs = run_gaps(machine, of.runs, of.out, conclusion.residuals, conclusion.forces, options.compensated);
  diagnosis.fit = gap_of(conclusion.residuals, of.out, false);
  diagnosis.held_out = gap_of(conclusion.residuals, of.out, true);
  diagnosis.visible =
      visible_effects(reduced_gram(*model.base.problem, marginalised_by(candidates, {}, model.base.problem->values)),
                      candidates, model.threshold, options.search.scoring);
  diagnosis.converged = model.fit.converged;
  diagnosis.withheld = objection_to(conclusion, of, assessment.verdict, options.verdict);
  diagnosis.errors.assign(forces.parameters.size(), 0);
  diagnosis.posterior = posterior_as_given(machine, of.runs, of.given);
  if (diagnosis.withheld) return diagnosis;
  identify::Posterior learnt = posterior_of(of, model, conclusion, options.verdict);
  if (const auto less = identify::less_sure(machine.rotation, of.runs, diagnosis.posterior, learnt)) {
    diagnosis.withheld = *less;
  } else {
    if (conclusion.residual) diagnosis.functions = functions_of(*conclusion.residual, conclusion.forces.machine);
    diagnosis.posterior = std::move(learnt);
    diagnosis.forces = std::move(conclusion.forces);
    diagnosis.errors = std::move(conclusion.errors);
  }
  return diagnosis;
}

}  // namespace

std::string_view to_text(Verdict verdict) {
  switch (verdict) {
    case Verdict::named:
      return "named";
    case Verdict::nothing_missing:
      return "nothing-missing";
    case Verdict::unknown:
      break;
  }
  return "unknown";
}

Diagnosis diagnose(const machine::MachineModel& machine, const std::vector<Run>& runs, const DiagnoseOptions& options,
                   const Say& say) {
  check_measured(runs);
  say.begin(fmt::format("looking at the readings of {} runs", runs.size()));
  const physics::ForceModel forces(machine);
  const CandidateSet candidates = make_candidate_set(machine, forces, options.candidates);
  const std::vector<RunEquations> given = residuals(machine, runs, forces, {});
  if (const std::optional<ChannelFlaw> flaw = channel_flaw(runs, given, options.channels)) {
    return undiagnosed(machine, runs, *flaw, given, options);
  }
  if (options.spoiled) return undiagnosed(machine, runs, *options.spoiled, given, options);
  std::vector<std::string> steps;
  const Say tell{[&](const std::string& text) {
                   steps.push_back(text);
                   say(text);
                 },
                 say.doing};

  const std::vector<bool> out = held_out(machine.rotation, runs, candidates, options.held_out);
  const std::vector<Run> fitted = without_those(runs, out);
  const Workbench bench{machine, forces, fitted, candidates};
  const Case of{runs, out, given, bench};
  const Model model = search(bench, options.search, tell);
  Assessment assessment = assess(of, model, options, tell);
  Conclusion conclusion = conclude(of, model, assessment, options, tell);
  Diagnosis diagnosis = diagnosis_of(of, model, std::move(assessment), std::move(conclusion), options);
  diagnosis.steps = std::move(steps);
  return diagnosis;
}

}  // namespace plumbline::diagnose
