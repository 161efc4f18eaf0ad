#include "diagnose/posterior.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "diagnose/gap/contrasts.hpp"
#include "identify/plausible.hpp"

namespace plumbline::diagnose {
namespace {

using identify::Posterior;
using identify::PosteriorState;

// Places of the candidates' unknowns that some fit moved.
std::vector<int> places_of(const std::vector<const Refit*>& fits) {
  std::set<int> places;
  for (const Refit* const fit : fits) places.insert(fit->places.begin(), fit->places.end());
  return {places.begin(), places.end()};
}

// In the order of `places`; what this fit did not move is exact.
PosteriorState state_of(const Refit& fit, const std::vector<int>& places, std::string name, double weight) {
  PosteriorState state{std::move(name), weight, fit.values(places), {}, 1, {}};
  const auto size = static_cast<Eigen::Index>(places.size());
  state.covariance = Eigen::MatrixXd::Zero(size, size);
  std::vector<Eigen::Index> at;
  for (const int place : fit.places)
    at.push_back(std::lower_bound(places.begin(), places.end(), place) - places.begin());
  state.covariance(at, at) = fit.covariance;
  return state;
}

// Rivals of the strongest effect that are not ruled out, and were fitted.
std::vector<const Rival*> others_of(const Model& model, const Conclusion& conclusion, const VerdictOptions& options) {
  std::vector<const Rival*> others;
  if (conclusion.picks.empty()) return others;
  const Found& strongest = model.found.front();
  for (const Rival& rival : strongest.rivals) {
    if (rival.refitted && rival.log_odds > strongest.log_odds - options.within_nats) others.push_back(&rival);
  }
  return others;
}

bool is_picked(const std::vector<Pick>& picks, int place) {
  return std::any_of(picks.begin(), picks.end(), [&](const Pick& pick) {
    return std::find(pick.unknowns.begin(), pick.unknowns.end(), place) != pick.unknowns.end();
  });
}

// Of the state's unknowns, which stand at these places of the candidates'. What was picked is fitted without a prior,
// and strains none, though it be a nuisance elsewhere.
double widening_of(const CandidateSet& candidates, const std::vector<int>& places, const PosteriorState& state,
                   const std::vector<Pick>& picks) {
  std::vector<Eigen::Index> at;
  std::vector<const identify::Unknown*> known;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    const identify::Unknown& unknown = candidates.unknowns[static_cast<std::size_t>(places[k])];
    if (unknown.free() || is_picked(picks, places[k]) || !(state.covariance(i, i) > 0)) continue;
    at.push_back(i);
    known.push_back(&unknown);
  }
  return identify::prior_strain(known, state.mean(at), state.covariance(at, at),
                                identify::PlausibleOptions{}.least_share)
      .widening();
}

// What leaving out poses changes: what the model lacks moves each of them otherwise.
Eigen::MatrixXd moved_by_poses(const Workbench& bench, const Posterior& posterior, const PosteriorState& state,
                               const identify::NoiseModel& noise) {
  identify::Fit fit(posterior.unknowns);
  fit.values = state.mean;
  fit.noise = noise;
  return identify::jackknife(identify::moved_by_poses(bench.machine.rotation, bench.runs, fit, {.huber = 0},
                                                      identify::PlausibleOptions{}.least_poses));
}

// The numbers of the functions that were learnt beside the base model, known together with its nuisances. Poses left
// out move none of them: they would move each with its neighbours, by more than its prior lets it, and poses that were
// not seen have confirmed the functions already.
void add_numbers(const LearntResidual& residual, const Refit& fit, Posterior& posterior) {
  PosteriorState& state = posterior.states.front();
  const Eigen::Index before = state.mean.size();
  const auto more = static_cast<Eigen::Index>(residual.numbers.size());
  state.mean.conservativeResize(before + more);
  std::vector<Eigen::Index> at;
  for (const int place : fit.places) at.push_back(place);  // nuisances alone, in their order
  for (Eigen::Index k = 0; k < more; ++k) {
    const RowNumber& number = residual.numbers[static_cast<std::size_t>(k)];
    const std::size_t added = posterior.unknowns.add(number.effect, number.key, std::max(number.index, 0), number.row);
    posterior.unknowns.set_prior(added, number.sigma);
    state.mean[before + k] = posterior.unknowns[added].start;
    at.push_back(before + k);
  }
  state.covariance = residual.covariance(at, at);
  state.moved.conservativeResize(before + more, Eigen::NoChange);
  state.moved.bottomRows(more).setZero();
}

}  // namespace

Posterior posterior_of(const Case& of, const Model& model, const Conclusion& conclusion,
                       const VerdictOptions& options) {
  const CandidateSet& candidates = of.bench.candidates;
  const std::vector<const Rival*> others = others_of(model, conclusion, options);
  std::vector<const Refit*> fits{&conclusion.fit};
  for (const Rival* const rival : others) fits.push_back(&rival->fit);
  const std::vector<int> places = places_of(fits);

  Posterior posterior{identify::Unknowns(conclusion.forces)};
  for (const int place : places) {
    const std::size_t added =
        identify::add_like(posterior.unknowns, candidates.unknowns[static_cast<std::size_t>(place)]);
    if (is_picked(conclusion.picks, place)) posterior.unknowns.set_free(added);
  }
  posterior.states.push_back(state_of(conclusion.fit, places, "", 1));
  double weights = 1;
  for (const Rival* const rival : others) {
    const double weight = std::exp(rival->log_odds - model.found.front().log_odds);
    posterior.states.push_back(state_of(rival->fit, places, rival->pick.candidate->name, weight));
    weights += weight;
  }
  for (PosteriorState& state : posterior.states) {
    state.moved = moved_by_poses(of.bench, posterior, state, model.noise);
  }
  if (conclusion.residual) add_numbers(*conclusion.residual, conclusion.fit, posterior);
  for (std::size_t i = 0; i < posterior.states.size(); ++i) {
    PosteriorState& state = posterior.states[i];
    std::vector<Pick> picks = conclusion.picks;
    if (i > 0) picks.front() = others[i - 1]->pick;  // which stands in the place of the strongest
    state.weight /= weights;
    state.widening = widening_of(candidates, places, state, picks);
  }
  posterior.noise.radial = model.noise.channels[identify::kRadial].sigma;
  for (std::size_t channel = identify::kRadial + 1; channel < identify::kChannels; ++channel)
    posterior.noise.torque = std::max(posterior.noise.torque, model.noise.channels[channel].sigma);
  posterior.unexplained = recurring_radial(contrasts_of(of.runs, conclusion.residuals.after));
  return posterior;
}

Posterior posterior_as_given(const machine::MachineModel& machine, const std::vector<measure::Run>& runs,
                             const std::vector<identify::RunEquations>& given) {
  Posterior posterior = identify::prior_of(machine);
  posterior.from_data = true;
  posterior.unexplained = recurring_radial(contrasts_of(runs, given));
  return posterior;
}

}  // namespace plumbline::diagnose
