#include "diagnose/conclusion.hpp"

#include <algorithm>
#include <utility>

#include "diagnose/doubt.hpp"
#include "diagnose/held_values.hpp"
#include "diagnose/unexplained.hpp"
#include "diagnose/verdict.hpp"
#include "measure/simulation.hpp"
#include "physics/error.hpp"

namespace plumbline::diagnose {
namespace {

using identify::RunEquations;
using measure::Run;

constexpr std::size_t kPlacesOfRun = 24;  // at which the tip is looked at

// What would separate the strongest effect from the others of the confidence set: rivals, refitted in its place.
std::vector<Separation> separations_of(const Workbench& bench, const Model& model, const Conclusion& conclusion,
                                       const NextTestOptions& options) {
  std::vector<Separation> all;
  const auto like = std::max_element(bench.runs.begin(), bench.runs.end(), [](const Run& a, const Run& b) {
    const auto kinds = [](const Run& run) { return (run.has_radial() ? 1 : 0) + (run.has_torque() ? 1 : 0); };
    return kinds(a) < kinds(b);
  });
  for (const std::string& name : conclusion.confidence_set) {
    for (const Rival& rival : model.found.front().rivals) {
      if (rival.pick.candidate->name != name || !rival.refitted) continue;
      const physics::ForceModel other = bench.candidates.unknowns.at(rival.fit.values);
      all.push_back({name, next_test(bench.machine, conclusion.forces, other, *like, model.noise, options)});
    }
  }
  return all;
}

void add_names(const Case& of, const Model& model, const DiagnoseOptions& options, Conclusion& conclusion) {
  const Workbench& bench = of.bench;
  for (std::size_t place = 0; place < model.found.size(); ++place) {
    const Found& found = model.found[place];
    conclusion.effects.push_back({found.pick.candidate->name, alternatives_of(bench, model, place, options.verdict),
                                  parameters_of(bench, found.pick, model.fit), found.log_odds, found.left_out});
  }
  conclusion.confidence_set = confidence_set_of(model, conclusion.effects, options.verdict);
  const std::vector<Rival>& rivals = model.found.front().rivals;
  if (!rivals.empty()) {
    conclusion.runner_up = rivals.front().pick.candidate->name;
    const physics::ForceModel second = bench.candidates.unknowns.at(rivals.front().fit.values);
    conclusion.residuals.second = residuals(bench.machine, of.runs, second, model.noise);
  }
  conclusion.next = separations_of(bench, model, conclusion, options.next_test);
}

// The model with what was found, but for a shift of the tip that circles do not show.
void hold_back(const Case& of, const Model& model, const DiagnoseOptions& options, const Say& say,
               Conclusion& conclusion) {
  const Workbench& bench = of.bench;
  const identify::Held held = held_values(bench, bench.forces, picks_of(model), model.fit, options.hold);
  say(shift_text(held));
  conclusion.forces = bench.candidates.unknowns.at(held.values);
  conclusion.residuals.after = residuals(bench.machine, of.runs, conclusion.forces, model.noise);
}

// How far the model as it was given and this one put the tip apart, on the ways that were measured, m.
double farthest_move(const Case& of, const physics::ForceModel& forces) {
  const auto tip = [&](const physics::ForceModel& model, const Run& run, std::size_t i) -> Vector3<double> {
    physics::Environment environment = measure::environment_of(model, run);
    environment.friction = false;
    return physics::tip_error(model, environment, measure::circular_motion(of.bench.machine.rotation, run, i))
        .pose.p_WT;
  };
  double farthest = 0;
  for (const Run& run : of.runs) {
    const std::size_t step = std::max<std::size_t>(1, run.samples() / kPlacesOfRun);
    for (std::size_t i = 0; i < run.samples(); i += step) {
      farthest = std::max(farthest, (tip(forces, run, i) - tip(of.bench.forces, run, i)).norm());
    }
  }
  return farthest;
}

// The base model: no effect of the catalogue is believed.
void describe_beside_base(const Case& of, const Model& model, const Assessment& assessment,
                          const DiagnoseOptions& options, const Say& say, Conclusion& conclusion) {
  const CandidateSet& candidates = of.bench.candidates;
  Unexplained beside = unexplained(
      {of.bench, model.base, conclusion.residuals.base, recurring(assessment.gap_map.contrasts, options.verdict),
       model.noise, model.found.empty() ? &assessment.description : nullptr},
      of.runs, of.out, options, say);
  conclusion.description = std::move(beside.description);
  if (!beside.borne_out && assessment.remainder) conclusion.description.terms.clear();  // it says enough
  conclusion.fit = std::move(beside.fitted.fit);
  conclusion.forces = std::move(beside.fitted.forces);
  conclusion.errors = std::move(beside.fitted.errors);
  conclusion.marginalised = marginalised_by(candidates, {}, model.base.fit.values);
  // with terms that the runs held out bear out, nuisances are others than those of the base model alone
  if (beside.borne_out && (beside.residual || !conclusion.description.terms.empty()))
    conclusion.marginalised.departure.setZero();
  conclusion.residual = std::move(beside.residual);
  conclusion.residuals.after = std::move(beside.residuals);
}

}  // namespace

Conclusion conclude(const Case& of, const Model& model, Assessment assessment, const DiagnoseOptions& options,
                    const Say& say) {
  say.begin("working out how sure that is, and the next test");
  const CandidateSet& candidates = of.bench.candidates;
  Conclusion conclusion{.forces = candidates.unknowns.at(model.fit.values)};
  conclusion.errors = parameter_errors(candidates, conclusion.forces, model.fit);
  conclusion.marginalised = marginalised_by(candidates, picks_of(model), model.fit.values);
  conclusion.residuals = std::move(assessment.residuals);
  if (assessment.verdict == Verdict::unknown) {
    describe_beside_base(of, model, assessment, options, say, conclusion);
    return conclusion;
  }
  conclusion.picks = picks_of(model);
  conclusion.fit = model.fit;
  conclusion.description = std::move(assessment.description);
  if (assessment.verdict == Verdict::named) add_names(of, model, options, conclusion);
  hold_back(of, model, options, say, conclusion);
  return conclusion;
}

std::optional<Objection> objection_to(const Conclusion& conclusion, const Case& of, Verdict verdict,
                                      const VerdictOptions& options) {
  const CandidateSet& candidates = of.bench.candidates;
  if (auto off = strained(candidates, conclusion.marginalised, options); !off.empty()) return off;
  const double together = strain_of_all(candidates, conclusion.marginalised);
  if (together > options.nuisances_together) return StrainedTogether{together};
  if (verdict == Verdict::unknown) {
    const double tip = farthest_move(of, conclusion.forces);
    if (tip > options.farthest_tip) return MovedFar{tip};
  }
  const Rms before = rms_of(of.given, of.out, true);
  const Rms after = rms_of(conclusion.residuals.after, of.out, true);
  if (before.radial && *after.radial > *before.radial) return GivenIsNearer{ReadingKind::radial};
  if (before.torque && *after.torque > *before.torque * options.held_out_rise)
    return GivenIsNearer{ReadingKind::torque};
  if (verdict == Verdict::named) return std::nullopt;
  const Recurs recurs = recurring(contrasts_of(of.runs, conclusion.residuals.after), options);
  const Gap whole{rms_of(of.given, of.out, false), {}, rms_of(conclusion.residuals.after, of.out, false)};
  return open_gap(recurs, whole, options.open_share, options);
}

}  // namespace plumbline::diagnose
