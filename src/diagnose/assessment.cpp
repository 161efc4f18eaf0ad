#include "diagnose/assessment.hpp"

#include <fmt/format.h>

#include "diagnose/doubt.hpp"
#include "diagnose/verdict.hpp"

namespace plumbline::diagnose {
namespace {

std::string doubt_of(const Case& of, const Model& model, const Assessment& so_far, const Recurs& recurs,
                     const VerdictOptions& options) {
  std::string doubt = bound_doubt(of.bench.candidates, model, options);
  if (doubt.empty()) {
    doubt = gap_doubt(model, gap_of(so_far.residuals, of.out, false), gap_of(so_far.residuals, of.out, true), recurs,
                      options);
  }
  if (doubt.empty()) doubt = doubt_about(model, so_far.description, so_far.residuals.after, of.out, options);
  return doubt;
}

Verdict verdict_of(const Model& model, const Assessment& so_far, const VerdictOptions& options) {
  if (!model.found.empty()) return so_far.doubt.empty() ? Verdict::named : Verdict::unknown;
  return is_gap(so_far.description, options) || so_far.remainder ? Verdict::unknown : Verdict::nothing_missing;
}

}  // namespace

Assessment assess(const Case& of, const Model& model, const DiagnoseOptions& options, const Say& say) {
  const auto& [machine, forces, fitted, candidates] = of.bench;
  const std::vector<Pick> picks = picks_of(model);
  const physics::ForceModel complete = candidates.unknowns.at(model.fit.values);
  const physics::ForceModel base = candidates.unknowns.at(model.base.fit.values);
  Assessment found;
  found.description =
      describe(of.bench, complete, model.problem, marginalised_by(candidates, picks, model.problem.values), model.noise,
               options.description);
  say(fmt::format("remainder: gain {:.1f}, {:.1f} nats", found.description.gain, found.description.log_odds));
  if (model.found.size() > 1) say(fmt::format("resemblance of the two: {:.3f}", resemblance(of.bench, model, 0, 1)));

  found.residuals = {
      residuals(machine, of.runs, base, model.noise), {}, residuals(machine, of.runs, complete, model.noise)};
  found.gap_map = gap_map_of(machine.rotation, of.runs, base, found.residuals.base, model.noise, options.gap_map);
  found.remainder = strained(candidates, marginalised_by(candidates, picks, model.fit.values), options.verdict);
  const Recurs recurs = recurring(contrasts_of(of.runs, found.residuals.after), options.verdict);
  if (!found.remainder) found.remainder = remainder_of(recurs);
  found.doubt = doubt_of(of, model, found, recurs, options.verdict);
  if (!found.doubt.empty()) say("doubt: " + found.doubt);
  found.verdict = verdict_of(model, found, options.verdict);
  return found;
}

}  // namespace plumbline::diagnose
