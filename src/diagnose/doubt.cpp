#include "diagnose/doubt.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "base/units.hpp"
#include "identify/prior_strain.hpp"

namespace plumbline::diagnose {

std::optional<double> not_predicted(const std::vector<identify::RunEquations>& residuals, const std::vector<bool>& out,
                                    MeanSquare ResidualSums::*kind, const VerdictOptions& options) {
  std::vector<double> fitted;  // mean squares of single runs
  std::vector<double> held_out;
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    const MeanSquare sum = residual_sums(residuals[i]).*kind;
    if (sum.count > 0) (out[i] ? held_out : fitted).push_back(sum.mean());
  }
  if (fitted.size() < 3 || held_out.empty()) return std::nullopt;
  const auto each = [](std::vector<double>& values) {
    return Eigen::Map<Eigen::ArrayXd>(values.data(), static_cast<Eigen::Index>(values.size()));
  };
  const double usual = each(fitted).mean();
  const double there = each(held_out).mean();
  const double variance = (each(fitted) - usual).square().sum() / static_cast<double>(fitted.size() - 1);
  const double deviation = std::sqrt(variance / static_cast<double>(held_out.size()));
  const double times = std::sqrt(there / usual);
  const bool may_be = times < options.held_out_times || there - usual < options.held_out_sigmas * deviation;
  return may_be ? std::nullopt : std::optional(times);
}

namespace {

std::optional<Recurring> recurring(const std::vector<Contrast>& contrasts, Recurrence Contrast::*kind,
                                   double BarAndTorque::*rms, double least_rms, const VerdictOptions& options) {
  Recurring found;
  double chi2 = 0;
  int count = 0;
  double most = 0;
  for (const Contrast& contrast : contrasts) {
    const Recurrence& one = contrast.*kind;
    if (std::hypot(contrast.common.*rms, contrast.differs.*rms) < std::numbers::sqrt2 * least_rms) continue;
    chi2 += one.chi2;
    count += one.count;
    if (one.count == 0 || one.chi2 / one.count <= most) continue;
    most = one.chi2 / one.count;
    found.correlation = one.correlation;
    found.by = contrast.by;
  }
  if (count == 0) return std::nullopt;
  found.sigmas = (chi2 - count) / std::sqrt(2.0 * count);
  return found.sigmas > options.recurrence_sigmas ? std::optional(found) : std::nullopt;
}

}  // namespace

Recurs recurring(const std::vector<Contrast>& contrasts, const VerdictOptions& options) {
  return {recurring(contrasts, &Contrast::radial, &BarAndTorque::radial, options.least_recurring_um * kUm, options),
          recurring(contrasts, &Contrast::torque, &BarAndTorque::torque, options.least_recurring_Nm, options)};
}

std::optional<Remainder> remainder_of(const Recurs& recurs) {
  double snr = 0;
  for (const std::optional<Recurring>* const of : {&recurs.radial, &recurs.torque}) {
    if (*of) snr = std::hypot(snr, (*of)->sigmas);
  }
  return recurs.radial || recurs.torque ? std::optional(Remainder{snr, recurs}) : std::nullopt;
}

std::vector<StrainedUnknown> strained(const CandidateSet& candidates, const Marginalised& marginalised,
                                      const VerdictOptions& options) {
  std::vector<StrainedUnknown> all;
  for (std::size_t i = 0; i < candidates.nuisances; ++i) {
    const double sigmas = marginalised.departure[static_cast<Eigen::Index>(i)];
    if (std::abs(sigmas) >= options.nuisance_sigmas) all.push_back({candidates.unknowns[i], sigmas});
  }
  return all;
}

std::optional<Remainder> remainder_of(std::vector<StrainedUnknown> strained) {
  if (strained.empty()) return std::nullopt;
  double snr = 0;
  for (const StrainedUnknown& one : strained) snr = std::hypot(snr, one.sigmas);
  return Remainder{snr, std::move(strained)};
}

std::optional<OpenGap> open_gap(const Recurs& recurs, const Gap& gap, double share, const VerdictOptions& options) {
  const auto open = [&](ReadingKind kind, const std::optional<Recurring>& of, const std::optional<double>& before,
                        const std::optional<double>& after) -> std::optional<OpenGap> {
    const bool is_open =
        of && before && after && std::abs(of->correlation) > options.open_correlation && *after > share * *before;
    return is_open ? std::optional(OpenGap{{kind, *before, *after}}) : std::nullopt;
  };
  const auto radial = open(ReadingKind::radial, recurs.radial, gap.before.radial, gap.after.radial);
  return radial ? radial : open(ReadingKind::torque, recurs.torque, gap.before.torque, gap.after.torque);
}

double strain_of_all(const CandidateSet& candidates, const Marginalised& marginalised) {
  const Eigen::VectorXd nuisances = marginalised.departure.head(static_cast<Eigen::Index>(candidates.nuisances));
  return identify::prior_strain(nuisances).excess();
}

bool is_gap(const Description& description, const VerdictOptions& options) {
  return description.gain >= options.remainder_gain && !description.terms.empty();
}

namespace {

std::optional<AtBound> at_bound(const CandidateSet& candidates, const Model& model, const VerdictOptions& options) {
  for (const Found& found : model.found) {
    int fitted = 0;
    int at = 0;
    bool sure = false;
    const identify::Unknown* one = nullptr;
    for (const int place : found.pick.unknowns) {
      const identify::Unknown& u = candidates.unknowns[static_cast<std::size_t>(place)];
      const double value = model.fit.values[place];
      if (u.shape) continue;
      ++fitted;
      const bool above = u.upper > 0 && value >= options.at_bound * u.upper;
      const bool below = u.lower < 0 && value <= options.at_bound * u.lower;
      if (!above && !below) continue;
      ++at;
      one = &u;
      sure = sure || std::abs(value) > options.bound_sigmas * model.fit.errors[static_cast<std::size_t>(place)];
    }
    if (one != nullptr && (sure || at == fitted)) return AtBound{found.pick.candidate->name, *one};
  }
  return std::nullopt;
}

// What runs held out lose is noise where it is little beside what the others gain: none of the numbers is exact.
std::optional<FurtherOff> further_off(const Gap& fit, const Gap& held_out, const VerdictOptions& options) {
  const auto rises = [&](ReadingKind kind, std::optional<double> Rms::*rms) -> std::optional<FurtherOff> {
    const std::optional<double>& before = held_out.before.*rms;
    const std::optional<double>& after = held_out.after.*rms;
    if (!before || !after || *after <= options.held_out_rise * *before) return std::nullopt;
    const auto squares = [](const std::optional<double>& a, const std::optional<double>& b) {
      return std::pow(a.value_or(0), 2) - std::pow(b.value_or(0), 2);
    };
    if (squares(after, before) < options.rise_share * squares(fit.before.*rms, fit.after.*rms)) return std::nullopt;
    return FurtherOff{{kind, *before, *after}};
  };
  const auto radial = rises(ReadingKind::radial, &Rms::radial);
  return radial ? radial : rises(ReadingKind::torque, &Rms::torque);
}

std::optional<LargeRemainder> large_remainder(const Model& model, const Description& description,
                                              const VerdictOptions& options) {
  double explained = 0;
  bool outdoes = false;  // it is surer than one of several effects is, which may have taken a part of it
  for (const Found& found : model.found) {
    explained += 2 * found.log_odds;
    outdoes = outdoes || (model.found.size() > 1 && description.log_odds > found.log_odds);
  }
  const bool is_large = is_gap(description, options) && description.gain > options.remainder_share * explained &&
                        (outdoes || description.gain > options.remainder_most);
  return is_large ? std::optional(LargeRemainder{std::sqrt(description.gain)}) : std::nullopt;
}

std::optional<NotPredicted> not_predicted(const std::vector<identify::RunEquations>& after,
                                          const std::vector<bool>& out, const VerdictOptions& options) {
  if (const auto times = not_predicted(after, out, &ResidualSums::radial, options))
    return NotPredicted{ReadingKind::radial, *times};
  if (const auto times = not_predicted(after, out, &ResidualSums::torque, options))
    return NotPredicted{ReadingKind::torque, *times};
  return std::nullopt;
}

std::optional<Suspected> suspected(const Model& model) {
  for (const Found& found : model.found) {
    const std::string& name = found.pick.candidate->name;
    if (physics::effect_infos()[physics::effect_index(name)].suspect) return Suspected{name};
  }
  return std::nullopt;
}

}  // namespace

std::optional<Doubt> doubt_of(const CandidateSet& candidates, const Doubted& of, const VerdictOptions& options) {
  if (of.model.found.empty()) return std::nullopt;
  Doubt doubt;
  for (const Found& found : of.model.found) doubt.effects.push_back(found.pick.candidate->name);
  const auto says = [&](auto why) {
    if (why) doubt.why = std::move(*why);
    return why.has_value();
  };
  const std::optional<OneMore> more = of.model.one_more ? std::optional<OneMore>(OneMore{}) : std::nullopt;
  const bool stays_open = of.recurs.radial || of.recurs.torque || is_gap(of.description, options);
  const bool doubted = (stays_open && says(at_bound(candidates, of.model, options))) ||
                       says(further_off(of.fit, of.held_out, options)) ||
                       says(open_gap(of.recurs, of.fit, options.open_share, options)) || says(more) ||
                       says(large_remainder(of.model, of.description, options)) ||
                       says(not_predicted(of.after, of.out, options)) || says(suspected(of.model));
  return doubted ? std::optional(std::move(doubt)) : std::nullopt;
}

}  // namespace plumbline::diagnose
