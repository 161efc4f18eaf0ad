#include "diagnose/diagnose.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "base/diagnostic.hpp"
#include "diagnose/doubt.hpp"
#include "diagnose/verdict.hpp"
#include "physics/generic_formula.hpp"

namespace plumbline::diagnose {
namespace {

using identify::RunEquations;
using measure::Run;

std::optional<double> rms_if_any(const MeanSquare& of) {
  return of.count > 0 ? std::optional(of.root()) : std::nullopt;
}

// Residuals of all runs with one force model, each run's set-up fitted.
std::vector<RunEquations> residuals(const machine::MachineModel& machine, const std::vector<Run>& runs,
                                    const physics::ForceModel& forces, const identify::NoiseModel& noise) {
  identify::Objective objective(machine.rotation, runs, identify::Unknowns(forces), {.huber = 0});
  objective.set_noise(noise);
  return objective.equations(Eigen::VectorXd(0));
}

Rms rms_of(const std::vector<RunEquations>& runs, const std::vector<bool>& out, bool held_out) {
  Left all;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (out[i] != held_out) continue;
    const Left left = left_of(runs[i]);
    all.radial.add(left.radial);
    all.torque.add(left.torque);
  }
  return {rms_if_any(all.radial), rms_if_any(all.torque)};
}

std::optional<Circularity> circularity_of(const machine::MachineModel& machine, const Run& run,
                                          const physics::ForceModel& found, const CompensatedOptions& options) {
  const std::optional<double> measured = measured_circularity(run);
  if (!measured) return std::nullopt;
  return Circularity{*measured, *compensated_circularity(machine.rotation, run, physics::ForceModel(machine), options),
                     *compensated_circularity(machine.rotation, run, found, options)};
}

void fill_gaps(const machine::MachineModel& machine, const std::vector<Run>& runs, const std::vector<bool>& out,
               const physics::ForceModel& before, const std::optional<physics::ForceModel>& runner_up,
               const DiagnoseOptions& options, Diagnosis& diagnosis) {
  const auto base = residuals(machine, runs, before, diagnosis.noise);
  const auto after = residuals(machine, runs, diagnosis.forces, diagnosis.noise);
  const auto second = runner_up ? residuals(machine, runs, *runner_up, diagnosis.noise) : base;
  diagnosis.where = where_of(machine.rotation, runs, before, base, diagnosis.noise, options.where);
  for (const bool held_out : {false, true}) {
    Gap& gap = held_out ? diagnosis.held_out : diagnosis.fit;
    gap = {rms_of(base, out, held_out), rms_of(second, out, held_out), rms_of(after, out, held_out)};
  }
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
    run.circularity = circularity_of(machine, runs[i], diagnosis.forces, options.compensated);
    diagnosis.runs.push_back(std::move(run));
  }
}

// Adds the terms of a description as instances of the effect `generic`.
void add_terms(physics::ForceModel& forces, const std::vector<Term>& terms) {
  for (const Term& term : terms) {
    const int first = forces.add("generic");
    const std::vector<double> parameters = generic_parameters(term);
    std::copy(parameters.begin(), parameters.end(), forces.parameters.begin() + first);
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

// Nuisances that had to go further than [uncertainty] makes believable, a line each. Those that an effect stands for
// are none any more.
std::optional<Remainder> strained(const Shelf& shelf, const Model& model, const VerdictOptions& options) {
  const Taken taken = taken_by(shelf, picks_of(model), model.fit.values);
  Remainder remainder;
  for (std::size_t i = 0; i < shelf.nuisances; ++i) {
    const identify::Unknown& u = shelf.unknowns[i];
    const double sigmas = taken.departure[static_cast<Eigen::Index>(i)];
    if (std::abs(sigmas) < options.nuisance_sigmas) continue;
    remainder.snr = std::hypot(remainder.snr, sigmas);
    if (!remainder.text.empty()) remainder.text += '\n';
    remainder.text += fmt::format("{} is {:.4g} {} off, {:.0f} times what [uncertainty] says of it", u.label,
                                  sigmas * u.sigma / u.unit.si, u.unit.name, std::abs(sigmas));
  }
  return remainder.text.empty() ? std::nullopt : std::optional(std::move(remainder));
}

std::optional<Remainder> remainder_of(const Recurs& recurs) {
  Remainder remainder;
  const auto add = [&](std::string_view what, const std::optional<Recurring>& of) {
    if (!of) return;
    remainder.snr = std::hypot(remainder.snr, of->sigmas);
    if (!remainder.text.empty()) remainder.text += '\n';
    remainder.text += fmt::format(
        "what is left of {} is no noise: in runs at one pose that differ by {} alone it is {}, with a "
        "correlation of {:.2f}",
        what, of->by, of->correlation > 0 ? "alike" : "opposite", of->correlation);
  };
  add("the readings of the bar", recurs.radial);
  add("the torques", recurs.torque);
  return remainder.text.empty() ? std::nullopt : std::optional(std::move(remainder));
}

// What comes again was taken for noise.
identify::NoiseModel without_what_recurs(identify::NoiseModel noise, const Recurs& recurs) {
  for (int c = 0; c < identify::kChannels; ++c) {
    const std::optional<Recurring>& of = c == identify::kRadial ? recurs.radial : recurs.torque;
    if (of) noise.channels.at(static_cast<std::size_t>(c)).sigma *= std::sqrt(1 - std::abs(of->correlation));
  }
  return noise;
}

bool is_gap(const Description& left, const VerdictOptions& options) {
  return left.gain >= options.remainder_gain && !left.terms.empty();
}

std::string names_of(const Model& model) {
  std::string text;
  for (const Found& found : model.found) text += (text.empty() ? "" : " and ") + found.pick.candidate->name;
  return text;
}

// Why the effects found, which leave `after`, cannot be the whole story; empty if they can.
std::string doubt_about(const Model& model, const Description& left, const std::vector<RunEquations>& after,
                        const std::vector<bool>& out, const VerdictOptions& options) {
  if (model.found.empty()) return {};
  const std::string names = names_of(model);
  if (model.one_more) return fmt::format("{} are not enough: one more effect would pass the threshold", names);
  double explained = 0;
  for (const Found& found : model.found) explained += 2 * found.log_odds;
  if (is_gap(left, options) && left.gain > std::max(options.remainder_most, options.remainder_share * explained)) {
    return fmt::format("{} would leave too much: {:.0f} times the noise in all", names, std::sqrt(left.gain));
  }
  std::string doubt;
  const auto look = [&](std::string_view what, MeanSquare Left::*kind) {
    if (const std::optional<double> times = not_foretold(after, out, kind, options)) {
      doubt = fmt::format("{} would explain the runs fitted, but {} of the runs held out are {:.1f} times as far off",
                          names, what, *times);
    }
  };
  look("the torques", &Left::torque);
  look("the readings of the bar", &Left::radial);
  return doubt;
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

std::vector<double> parameter_errors(const Shelf& shelf, const physics::ForceModel& forces, const Refit& fit) {
  std::vector<double> errors(forces.parameters.size(), 0);
  for (std::size_t u = 0; u < shelf.unknowns.size(); ++u) {
    for (const identify::Unknown::Term& term : shelf.unknowns[u].terms) {
      double& error = errors[static_cast<std::size_t>(term.parameter)];
      error = std::hypot(error, term.weight * fit.errors[u]);
    }
  }
  return errors;
}

// The base model where what comes again counts as no noise.
Footing footing_for(const Workbench& bench, const Model& model, const Recurs& recurs, const DiagnoseOptions& options) {
  if (!recurs.radial && !recurs.torque) return model.base;
  Footing footing = model.base;
  footing.noise = without_what_recurs(model.base.noise, recurs);
  footing.fit = refit(bench, {}, model.base.fit.values, footing.noise, options.search.refit);
  footing.problem = linearise(bench.machine.rotation, bench.runs, bench.shelf, footing.fit.values, footing.noise);
  return footing;
}

// A model that was fitted, and the standard errors of its parameters.
struct Fitted {
  physics::ForceModel forces;
  std::vector<double> errors;
};

// The base model with the terms of a description, its nuisances refitted beside them; without them where that leaves
// more than before: the terms come from a linear problem.
Fitted described(const Workbench& bench, const Footing& footing, const std::vector<Term>& terms,
                 const DiagnoseOptions& options) {
  const physics::ForceModel before = bench.shelf.unknowns.at(footing.fit.values);
  Fitted base{before, parameter_errors(bench.shelf, before, footing.fit)};
  if (terms.empty()) return base;
  physics::ForceModel forces = bench.forces;
  add_terms(forces, terms);
  const Shelf shelf = make_shelf(bench.machine, forces, options.shelf);
  try {
    const Refit fit =
        refit({bench.machine, forces, bench.runs, shelf}, {}, footing.fit.values, footing.noise, options.search.refit);
    if (fit.misfit < footing.fit.misfit) {
      const physics::ForceModel fitted = shelf.unknowns.at(fit.values);
      return {fitted, parameter_errors(shelf, fitted, fit)};
    }
  } catch (const Refusal&) {  // with the terms as they are, the machine falls through a singularity
  }
  return base;
}

Description describe_base(const Workbench& bench, const Footing& footing, const DiagnoseOptions& options) {
  return describe(bench, bench.shelf.unknowns.at(footing.fit.values), footing.problem,
                  taken_by(bench.shelf, {}, footing.fit.values), footing.noise, options.description);
}

// How far off the runs held out are, in units of the noise, squared.
double held_out_misfit(const machine::MachineModel& machine, const std::vector<Run>& runs, const std::vector<bool>& out,
                       const physics::ForceModel& forces, const identify::NoiseModel& noise) {
  std::vector<Run> held_out;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (out[i]) held_out.push_back(runs[i]);
  }
  double misfit = 0;
  for (const RunEquations& run : residuals(machine, held_out, forces, noise)) {
    const Left left = left_of(run);
    misfit += left.radial.sum / std::pow(noise.channels[identify::kRadial].sigma, 2) +
              left.torque.sum / std::pow(noise.channels[identify::kRadial + 1].sigma, 2);
  }
  return misfit;
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
      const physics::ForceModel other = bench.shelf.unknowns.at(rival.fit.values);
      all.push_back({name, next_test(bench.machine, diagnosis.forces, other, *like, diagnosis.noise, options)});
    }
  }
  return all;
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
  const Shelf shelf = make_shelf(machine, forces, options.shelf);
  std::vector<std::string> steps;
  const Say tell = [&](const std::string& text) {
    steps.push_back(text);
    if (say) say(text);
  };

  const std::vector<bool> out = held_out(machine.rotation, runs, shelf, options.held_out);
  std::vector<Run> fitted;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (!out[i]) fitted.push_back(runs[i]);
  }
  const Workbench bench{machine, forces, fitted, shelf};
  const Model model = search(bench, options.search, tell);
  const physics::ForceModel with = shelf.unknowns.at(model.fit.values);
  Description left = describe(bench, with, model.problem, taken_by(shelf, picks_of(model), model.problem.values),
                              model.noise, options.description);
  tell(fmt::format("remainder: gain {:.1f}, {:.1f} nats", left.gain, left.log_odds));

  if (model.found.size() > 1) tell(fmt::format("resemblance of the two: {:.3f}", resemblance(bench, model, 0, 1)));

  const std::vector<RunEquations> after = residuals(machine, runs, with, model.noise);
  const Recurs recurs = recurring(contrasts_of(runs, after), options.verdict);
  Diagnosis diagnosis(with);
  diagnosis.remainder = strained(shelf, model, options.verdict);
  if (!diagnosis.remainder) diagnosis.remainder = remainder_of(recurs);
  diagnosis.doubt = doubt_about(model, left, after, out, options.verdict);
  if (!diagnosis.doubt.empty()) tell("doubt: " + diagnosis.doubt);
  diagnosis.verdict = verdict_of(model, diagnosis, left, options.verdict);
  diagnosis.noise = model.noise;
  diagnosis.threshold = model.threshold;
  diagnosis.converged = model.fit.converged;
  diagnosis.evidence = evidence_of(model);
  diagnosis.errors = parameter_errors(shelf, with, model.fit);
  const physics::ForceModel before = shelf.unknowns.at(model.base.fit.values);
  std::optional<physics::ForceModel> runner_up;
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
      runner_up = shelf.unknowns.at(rivals.front().fit.values);
    }
    diagnosis.next = separations_of(bench, model, diagnosis, options.next_test);
  } else if (diagnosis.verdict == Verdict::unknown) {
    // described as it stands beside the base model: no effect of the catalogue is believed
    Footing footing = model.base;
    left = describe_base(bench, footing, options);
    if (!is_gap(left, options.verdict)) {
      const auto of_base = residuals(machine, runs, before, model.noise);
      footing = footing_for(bench, model, recurring(contrasts_of(runs, of_base), options.verdict), options);
      left = describe_base(bench, footing, options);
    }
    if (!is_gap(left, options.verdict)) left.terms.clear();
    Fitted with_terms = described(bench, footing, left.terms, options);
    if (held_out_misfit(machine, runs, out, with_terms.forces, model.noise) >
        held_out_misfit(machine, runs, out, before, model.noise)) {
      with_terms = described(bench, model.base, {}, options);
      if (diagnosis.remainder) left.terms.clear();  // it says enough
    }
    diagnosis.forces = std::move(with_terms.forces);
    diagnosis.errors = std::move(with_terms.errors);
  }
  if (is_gap(left, options.verdict)) {
    diagnosis.remainder = {std::sqrt(left.gain), left.terms, formula_of(left.terms)};
  }
  fill_gaps(machine, runs, out, before, runner_up, options, diagnosis);
  diagnosis.steps = std::move(steps);
  return diagnosis;
}

}  // namespace plumbline::diagnose
