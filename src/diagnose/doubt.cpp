#include "diagnose/doubt.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>

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
  return found.sigmas > options.recurrence_sigmas ? std::optional(std::move(found)) : std::nullopt;
}

}  // namespace

Recurs recurring(const std::vector<Contrast>& contrasts, const VerdictOptions& options) {
  return {recurring(contrasts, &Contrast::radial, &BarAndTorque::radial, options.least_recurring_um * kUm, options),
          recurring(contrasts, &Contrast::torque, &BarAndTorque::torque, options.least_recurring_Nm, options)};
}

namespace {

void add_line(Remainder& remainder, double sigmas, const std::string& line) {
  remainder.snr = std::hypot(remainder.snr, sigmas);
  if (!remainder.text.empty()) remainder.text += '\n';
  remainder.text += line;
}

std::optional<Remainder> if_any(Remainder remainder) {
  return remainder.text.empty() ? std::nullopt : std::optional(std::move(remainder));
}

}  // namespace

std::optional<Remainder> remainder_of(const Recurs& recurs) {
  Remainder remainder;
  const auto add = [&](std::string_view what, const std::optional<Recurring>& of) {
    if (!of) return;
    add_line(remainder, of->sigmas,
             fmt::format("what is left of {} is no noise: in runs at one pose that differ by {} alone it is {}, with a "
                         "correlation of {:.2f}",
                         what, to_text(of->by), of->correlation > 0 ? "alike" : "opposite", of->correlation));
  };
  add("the readings of the bar", recurs.radial);
  add("the torques", recurs.torque);
  return if_any(std::move(remainder));
}

std::optional<Remainder> strained(const CandidateSet& candidates, const Marginalised& marginalised,
                                  const VerdictOptions& options) {
  Remainder remainder;
  for (std::size_t i = 0; i < candidates.nuisances; ++i) {
    const identify::Unknown& u = candidates.unknowns[i];
    const double sigmas = marginalised.departure[static_cast<Eigen::Index>(i)];
    if (std::abs(sigmas) < options.nuisance_sigmas) continue;
    add_line(remainder, sigmas, identify::strain_text(u, sigmas, 0));
  }
  return if_any(std::move(remainder));
}

std::optional<std::string> open_gap(const Recurs& recurs, const Gap& gap, double share, const VerdictOptions& options) {
  const auto open = [&](const std::optional<Recurring>& of, const std::optional<double>& before,
                        const std::optional<double>& after) {
    return of && before && after && std::abs(of->correlation) > options.open_correlation && *after > share * *before;
  };
  if (open(recurs.radial, gap.before.radial, gap.after.radial)) {
    return fmt::format("the gap of the bar's readings stays open, {:.3g} um of {:.3g}, and is no noise",
                       *gap.after.radial / kUm, *gap.before.radial / kUm);
  }
  if (open(recurs.torque, gap.before.torque, gap.after.torque)) {
    return fmt::format(
        "the gap of the torques stays open, {:.3g} N m of {:.3g}, and is no noise: check unit and sign of each torque",
        *gap.after.torque, *gap.before.torque);
  }
  return std::nullopt;
}

double strain_of_all(const CandidateSet& candidates, const Marginalised& marginalised) {
  const Eigen::VectorXd nuisances = marginalised.departure.head(static_cast<Eigen::Index>(candidates.nuisances));
  return identify::prior_strain(nuisances).excess();
}

bool is_gap(const Description& description, const VerdictOptions& options) {
  return description.gain >= options.remainder_gain && !description.terms.empty();
}

namespace {

std::string names_of(const Model& model) {
  std::string text;
  for (const Found& found : model.found) text += (text.empty() ? "" : " and ") + found.pick.candidate->name;
  return text;
}

}  // namespace

namespace {

// What of a measurement to look at when an effect would have to be larger than it can be.
std::string_view suspect_of(std::string_view effect) {
  return physics::effect_infos()[physics::effect_index(effect)].reading_alone
             ? "check unit and sign of each torque"
             : "check units and signs of the channels, and what the dataset says of its runs";
}

}  // namespace

std::string bound_doubt(const CandidateSet& candidates, const Model& model, const VerdictOptions& options) {
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
    if (one == nullptr || !(sure || at == fitted)) continue;
    return fmt::format("{} would stand at its bound of {:.4g} {}, as far as it can be at all: {}",
                       found.pick.candidate->name, one->upper / one->unit.si, one->unit.name,
                       suspect_of(found.pick.candidate->name));
  }
  return {};
}

std::string gap_doubt(const Model& model, const Gap& fit, const Gap& held_out, const Recurs& recurs,
                      const VerdictOptions& options) {
  if (model.found.empty()) return {};
  const auto rises = [&](const std::optional<double>& before, const std::optional<double>& after) {
    return before && after && *after > options.held_out_rise * *before;
  };
  const std::string names = names_of(model);
  if (rises(held_out.before.radial, held_out.after.radial)) {
    return fmt::format("with {} the bar's readings of the runs held out would be further off, {:.3g} um for {:.3g}",
                       names, *held_out.after.radial / kUm, *held_out.before.radial / kUm);
  }
  if (rises(held_out.before.torque, held_out.after.torque)) {
    return fmt::format("with {} the torques of the runs held out would be further off, {:.3g} N m for {:.3g}", names,
                       *held_out.after.torque, *held_out.before.torque);
  }
  const std::optional<std::string> open = open_gap(recurs, fit, options.open_share, options);
  return open ? fmt::format("with {} {}", names, *open) : std::string();
}

std::string doubt_about(const Model& model, const Description& description,
                        const std::vector<identify::RunEquations>& after, const std::vector<bool>& out,
                        const VerdictOptions& options) {
  if (model.found.empty()) return {};
  const std::string names = names_of(model);
  if (model.one_more) return fmt::format("{} are not enough: one more effect would pass the threshold", names);
  double explained = 0;
  for (const Found& found : model.found) explained += 2 * found.log_odds;
  if (is_gap(description, options) &&
      description.gain > std::max(options.remainder_most, options.remainder_share * explained)) {
    return fmt::format("{} would leave too much: {:.0f} times the noise in all", names, std::sqrt(description.gain));
  }
  struct Kind {
    std::string_view what;
    MeanSquare ResidualSums::*of;
  };
  for (const Kind& kind :
       {Kind{"the readings of the bar", &ResidualSums::radial}, Kind{"the torques", &ResidualSums::torque}}) {
    if (const std::optional<double> times = not_predicted(after, out, kind.of, options)) {
      return fmt::format("{} would explain the runs fitted, but {} of the runs held out are {:.1f} times as far off",
                         names, kind.what, *times);
    }
  }
  return {};
}

}  // namespace plumbline::diagnose
