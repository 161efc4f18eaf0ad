#include "diagnose/assessment.hpp"

#include <fmt/format.h>

#include "diagnose/bar_gain.hpp"
#include "diagnose/doubt.hpp"
#include "diagnose/verdict.hpp"

namespace plumbline::diagnose {
namespace {

Verdict verdict_of(const Model& model, const Assessment& so_far, const VerdictOptions& options) {
  if (!model.found.empty()) return !so_far.doubt ? Verdict::named : Verdict::unknown;
  return is_gap(so_far.description, options) || so_far.remainder ? Verdict::unknown : Verdict::nothing_missing;
}

}  // namespace

Assessment assess(const Case& of, const Model& model, const DiagnoseOptions& options, const Say& say) {
  const auto& [machine, forces, fitted, candidates] = of.bench;
  const std::vector<Pick> picks = picks_of(model);
  const physics::ForceModel complete = candidates.unknowns.at(model.fit.values);
  const physics::ForceModel base = candidates.unknowns.at(model.base.fit.values);
  Assessment found;
  say.begin("looking at what is left");
  found.description =
      describe(of.bench, complete, *model.problem, marginalised_by(candidates, picks, model.problem->values),
               model.noise, options.description);
  say(fmt::format("remainder: gain {:.1f}, {:.1f} nats", found.description.gain, found.description.log_odds));
  if (model.found.size() > 1) say(fmt::format("resemblance of the two: {:.3f}", resemblance(of.bench, model, 0, 1)));

  found.residuals = {
      residuals(machine, of.runs, base, model.noise), {}, residuals(machine, of.runs, complete, model.noise)};
  found.gap_map = gap_map_of(machine.rotation, of.runs, base, found.residuals.base, model.noise, options.gap_map);
  found.remainder =
      remainder_of(strained(candidates, marginalised_by(candidates, picks, model.fit.values), options.verdict));
  const Recurs recurs = recurring(contrasts_of(of.runs, found.residuals.after), options.verdict);
  if (!found.remainder) found.remainder = remainder_of(recurs);
  found.doubt = doubt_of(candidates,
                         {model, found.description, found.residuals.after, of.out,
                          gap_of(found.residuals, of.out, false), gap_of(found.residuals, of.out, true), recurs},
                         options.verdict);
  if (!found.doubt) found.doubt = doubt_of_bar(of.bench, model);
  if (found.doubt) say("something speaks against the effects found");
  found.verdict = verdict_of(model, found, options.verdict);
  return found;
}

}  // namespace plumbline::diagnose
