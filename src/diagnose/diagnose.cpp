#include "diagnose/diagnose.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "base/diagnostic.hpp"
#include "base/units.hpp"
#include "diagnose/doubt.hpp"
#include "diagnose/held_values.hpp"
#include "diagnose/readings/noise_spectrum.hpp"
#include "diagnose/unexplained.hpp"
#include "diagnose/verdict.hpp"
#include "physics/generic_formula.hpp"

namespace plumbline::diagnose {
namespace {

using identify::RunEquations;
using measure::Run;

std::optional<double> rms_if_any(const MeanSquare& of) {
  return of.count > 0 ? std::optional(of.root()) : std::nullopt;
}

Rms rms_of(const std::vector<RunEquations>& runs, const std::vector<bool>& out, bool held_out) {
  const ResidualSums all = left_of(runs, out, held_out);
  return {rms_if_any(all.radial), rms_if_any(all.torque)};
}

std::optional<Circularity> circularity_of(const machine::MachineModel& machine, const Run& run,
                                          const physics::ForceModel& found, const CompensatedOptions& options) {
  const std::optional<double> measured = measured_circularity(run);
  if (!measured) return std::nullopt;
  return Circularity{*measured, *compensated_circularity(machine.rotation, run, physics::ForceModel(machine), options),
                     *compensated_circularity(machine.rotation, run, found, options)};
}

// What is left of all runs: with the base model, with the runner-up in place of the strongest effect, with what was
// found.
struct StageResiduals {
  std::vector<RunEquations> base, second, after;
};

Gap gap_of(const StageResiduals& leaves, const std::vector<bool>& out, bool held_out) {
  const std::vector<RunEquations>& second = leaves.second.empty() ? leaves.base : leaves.second;
  return {rms_of(leaves.base, out, held_out), rms_of(second, out, held_out), rms_of(leaves.after, out, held_out)};
}

void fill_gaps(const machine::MachineModel& machine, const std::vector<Run>& runs, const std::vector<bool>& out,
               const StageResiduals& leaves, const CompensatedOptions& options, Diagnosis& diagnosis) {
  const auto& [base, second, after] = leaves;
  diagnosis.fit = gap_of(leaves, out, false);
  diagnosis.held_out = gap_of(leaves, out, true);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    RunGap run{runs[i].id, out[i]};
    for (std::size_t c = 0; c < base[i].channels.size(); ++c) {
      const Eigen::Index n = base[i].samples;
      const auto first = static_cast<Eigen::Index>(c) * n;
      const auto rms = [&](const RunEquations& of) { return of.residual.segment(first, n).norm() / std::sqrt(n); };
      run.channels.push_back({base[i].channels[c], rms(base[i]), rms(second[i]), rms(after[i])});
      if (base[i].channels[c] != identify::kRadial) continue;
      run.angle = Eigen::Map<const Eigen::VectorXd>(runs[i].angle.data(), n);
      run.radial_before = base[i].residual.head(n);
      run.radial_after = after[i].residual.head(n);
    }
    run.circularity = circularity_of(machine, runs[i], diagnosis.forces, options);
    diagnosis.runs.push_back(std::move(run));
  }
}

std::string formula_of(const std::vector<Term>& terms) {
  std::string text;
  for (const Term& term : terms) {
    if (!text.empty()) text += '\n';
    text += physics::generic_formula(generic_parameters(term));
  }
  return text;
}

std::vector<Pick> picks_of(const Model& model) {
  std::vector<Pick> picks;
  for (const Found& found : model.found) picks.push_back(found.pick);
  return picks;
}

Verdict verdict_of(const Model& model, const Diagnosis& so_far, const Description& left,
                   const VerdictOptions& options) {
  if (!model.found.empty()) return so_far.doubt.empty() ? Verdict::named : Verdict::unknown;
  return is_gap(left, options) || so_far.remainder ? Verdict::unknown : Verdict::nothing_missing;
}

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

// What would separate the strongest effect from the others of the confidence set: rivals, refitted in its place.
std::vector<Separation> separations_of(const Workbench& bench, const Model& model, const Diagnosis& diagnosis,
                                       const NextTestOptions& options) {
  std::vector<Separation> all;
  const auto like = std::max_element(bench.runs.begin(), bench.runs.end(), [](const Run& a, const Run& b) {
    const auto kinds = [](const Run& run) { return (run.has_radial() ? 1 : 0) + (run.has_torque() ? 1 : 0); };
    return kinds(a) < kinds(b);
  });
  for (const std::string& name : diagnosis.confidence_set) {
    for (const Rival& rival : model.found.front().rivals) {
      if (rival.pick.candidate->name != name || !rival.refitted) continue;
      const physics::ForceModel other = bench.candidates.unknowns.at(rival.fit.values);
      all.push_back({name, next_test(bench.machine, diagnosis.forces, other, *like, diagnosis.noise, options)});
    }
  }
  return all;
}

// Why what was learnt is not to be believed, be it named or not; empty: nothing speaks against it.
std::string withheld(const Diagnosis& diagnosis, const CandidateSet& candidates, const Marginalised& taken,
                     const Recurs& recurs, const std::vector<RunEquations>& given, const StageResiduals& leaves,
                     const std::vector<bool>& out, const VerdictOptions& options) {
  if (const std::optional<Remainder> off = strained(candidates, taken, options)) return off->text;
  const double together = strain_of_all(candidates, taken);
  if (together > options.nuisances_together) {
    return fmt::format(
        "all that [uncertainty] lists would be further off together than it says, the sum of squares by {:.0f} of its "
        "standard deviations",
        together);
  }
  const Rms before = rms_of(given, out, true);
  const Rms after = rms_of(leaves.after, out, true);
  if (before.radial && *after.radial > *before.radial)
    return "the model as given is nearer to the bar's readings held out";
  if (before.torque && *after.torque > *before.torque * options.held_out_rise) {
    return "the model as given is nearer to the torques held out";
  }
  if (diagnosis.verdict == Verdict::named) return {};
  const Gap whole{rms_of(given, out, false), {}, rms_of(leaves.after, out, false)};
  return open_gap(recurs, whole, options.open_share, options).value_or("");
}

// Nothing is learnt from readings that no machine makes so.
Diagnosis undiagnosed(const machine::MachineModel& machine, const std::vector<Run>& runs, std::string flaw,
                      const std::vector<RunEquations>& given, const DiagnoseOptions& options) {
  Diagnosis diagnosis{physics::ForceModel(machine)};
  diagnosis.verdict = Verdict::unknown;
  diagnosis.withheld = flaw;
  diagnosis.doubt = std::move(flaw);
  diagnosis.noise = noise_of(given);
  diagnosis.errors.assign(diagnosis.forces.parameters.size(), 0);
  diagnosis.where = where_of(machine.rotation, runs, diagnosis.forces, given, diagnosis.noise, options.where);
  fill_gaps(machine, runs, std::vector<bool>(runs.size(), false), {given, given, given}, options.compensated,
            diagnosis);
  return diagnosis;
}

void check_measured(const std::vector<Run>& runs) {
  const bool any = std::any_of(runs.begin(), runs.end(), [](const Run& r) { return r.has_radial() || r.has_torque(); });
  if (!any) {
    refuse("diagnose-nothing-measured", "no run of the dataset has a reading of the bar or of the motors",
           "the tables need a column radial_um, or torque1_Nm to torque6_Nm");
  }
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
  const physics::ForceModel forces(machine);
  const CandidateSet candidates = make_candidate_set(machine, forces, options.candidates);
  const std::vector<RunEquations> given = residuals(machine, runs, forces, {});
  if (std::string flaw = channel_flaw(runs, given, options.channels); !flaw.empty()) {
    return undiagnosed(machine, runs, std::move(flaw), given, options);
  }
  std::vector<std::string> steps;
  const Say tell = [&](const std::string& text) {
    steps.push_back(text);
    if (say) say(text);
  };

  const std::vector<bool> out = held_out(machine.rotation, runs, candidates, options.held_out);
  std::vector<Run> fitted;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (!out[i]) fitted.push_back(runs[i]);
  }
  const Workbench bench{machine, forces, fitted, candidates};
  const Model model = search(bench, options.search, tell);
  const physics::ForceModel with = candidates.unknowns.at(model.fit.values);
  Description left = describe(bench, with, model.problem, taken_by(candidates, picks_of(model), model.problem.values),
                              model.noise, options.description);
  tell(fmt::format("remainder: gain {:.1f}, {:.1f} nats", left.gain, left.log_odds));

  if (model.found.size() > 1) tell(fmt::format("resemblance of the two: {:.3f}", resemblance(bench, model, 0, 1)));

  const physics::ForceModel before = candidates.unknowns.at(model.base.fit.values);
  StageResiduals leaves{residuals(machine, runs, before, model.noise), {}, residuals(machine, runs, with, model.noise)};
  Diagnosis diagnosis(with);
  diagnosis.noise = model.noise;
  diagnosis.where = where_of(machine.rotation, runs, before, leaves.base, model.noise, options.where);
  diagnosis.remainder = strained(candidates, taken_by(candidates, picks_of(model), model.fit.values), options.verdict);
  const Recurs recurs = recurring(contrasts_of(runs, leaves.after), options.verdict);
  if (!diagnosis.remainder) diagnosis.remainder = remainder_of(recurs);
  diagnosis.doubt = bound_doubt(candidates, model, options.verdict);
  if (diagnosis.doubt.empty()) {
    diagnosis.doubt = gap_doubt(model, gap_of(leaves, out, false), gap_of(leaves, out, true), recurs, options.verdict);
  }
  if (diagnosis.doubt.empty()) diagnosis.doubt = doubt_about(model, left, leaves.after, out, options.verdict);
  if (!diagnosis.doubt.empty()) tell("doubt: " + diagnosis.doubt);
  diagnosis.verdict = verdict_of(model, diagnosis, left, options.verdict);
  diagnosis.threshold = model.threshold;
  diagnosis.converged = model.fit.converged;
  diagnosis.visible = visible_effects(left_of(model.base.problem, taken_by(candidates, {}, model.base.problem.values)),
                                      candidates, model.threshold, options.search.scoring);
  Marginalised taken = taken_by(candidates, picks_of(model), model.fit.values);
  diagnosis.evidence = evidence_of(model);
  diagnosis.errors = parameter_errors(candidates, with, model.fit);
  if (diagnosis.verdict == Verdict::named) {
    for (std::size_t place = 0; place < model.found.size(); ++place) {
      const Pick& pick = model.found[place].pick;
      diagnosis.effects.push_back({pick.candidate->name, alternatives_of(bench, model, place, options.verdict),
                                   parameters_of(bench, pick, model.fit), model.found[place].log_odds,
                                   model.found[place].left_out});
    }
    diagnosis.confidence_set = confidence_set_of(model, diagnosis.effects, options.verdict);
    const std::vector<Rival>& rivals = model.found.front().rivals;
    if (!rivals.empty()) {
      diagnosis.runner_up = rivals.front().pick.candidate->name;
      leaves.second = residuals(machine, runs, candidates.unknowns.at(rivals.front().fit.values), model.noise);
    }
    diagnosis.next = separations_of(bench, model, diagnosis, options.next_test);
  } else if (diagnosis.verdict == Verdict::unknown) {
    // beside the base model: no effect of the catalogue is believed
    Unexplained beside = unexplained(
        {bench, model.base, leaves.base, recurring(diagnosis.where.contrasts, options.verdict), model.noise}, runs, out,
        options);
    left = std::move(beside.left);
    if (!beside.borne_out && diagnosis.remainder) left.terms.clear();  // it says enough
    diagnosis.forces = std::move(beside.fitted.forces);
    diagnosis.errors = std::move(beside.fitted.errors);
    taken = taken_by(candidates, {}, model.base.fit.values);
    // with terms that the runs held out bear out, nuisances are others than those of the base model alone
    if (beside.borne_out && !left.terms.empty()) taken.departure.setZero();
    leaves.after = std::move(beside.residuals);
  }
  if (diagnosis.verdict != Verdict::unknown) {
    const identify::Held held = held_values(bench, forces, picks_of(model), model.fit, options.hold);
    tell(fmt::format("the tip as a whole would move by {:.1f} um, +- {:.1f}: {:.1f} um of it held back",
                     held.shift / kUm, held.shift_doubt / kUm, held.back / kUm));
    diagnosis.forces = candidates.unknowns.at(held.values);
    leaves.after = residuals(machine, runs, diagnosis.forces, model.noise);
  }
  if (is_gap(left, options.verdict)) {
    diagnosis.remainder = {std::sqrt(left.gain), left.terms, formula_of(left.terms)};
  }
  if (leaves.second.empty()) leaves.second = leaves.base;
  fill_gaps(machine, runs, out, leaves, options.compensated, diagnosis);
  diagnosis.withheld =
      withheld(diagnosis, candidates, taken, recurring(contrasts_of(runs, leaves.after), options.verdict), given,
               leaves, out, options.verdict);
  if (!diagnosis.withheld.empty()) {
    diagnosis.forces = forces;
    diagnosis.errors.assign(forces.parameters.size(), 0);
  }
  diagnosis.steps = std::move(steps);
  return diagnosis;
}

}  // namespace plumbline::diagnose
