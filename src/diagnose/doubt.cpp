#include "diagnose/doubt.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "base/units.hpp"

namespace plumbline::diagnose {

std::optional<double> not_foretold(const std::vector<identify::RunEquations>& residuals, const std::vector<bool>& out,
                                   MeanSquare Left::*kind, const VerdictOptions& options) {
  std::vector<double> fitted;  // mean squares of single runs
  std::vector<double> held_out;
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    const MeanSquare left = left_of(residuals[i]).*kind;
    if (left.count > 0) (out[i] ? held_out : fitted).push_back(left.mean());
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

std::optional<Recurring> recurring(const std::vector<Contrast>& contrasts, Recurrence Contrast::*kind, double Two::*rms,
                                   double least_rms, const VerdictOptions& options) {
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
  return {recurring(contrasts, &Contrast::radial, &Two::radial, options.least_recurring_um * kUm, options),
          recurring(contrasts, &Contrast::torque, &Two::torque, options.least_recurring_Nm, options)};
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
                         what, of->by, of->correlation > 0 ? "alike" : "opposite", of->correlation));
  };
  add("the readings of the bar", recurs.radial);
  add("the torques", recurs.torque);
  return if_any(std::move(remainder));
}

std::optional<Remainder> strained(const Shelf& shelf, const Taken& taken, const VerdictOptions& options) {
  Remainder remainder;
  for (std::size_t i = 0; i < shelf.nuisances; ++i) {
    const identify::Unknown& u = shelf.unknowns[i];
    const double sigmas = taken.departure[static_cast<Eigen::Index>(i)];
    if (std::abs(sigmas) < options.nuisance_sigmas) continue;
    add_line(remainder, sigmas,
             fmt::format("{} is {:.4g} {} off, {:.0f} times what [uncertainty] says of it", u.label,
                         sigmas * u.sigma / u.unit.si, u.unit.name, std::abs(sigmas)));
  }
  return if_any(std::move(remainder));
}

bool is_gap(const Description& left, const VerdictOptions& options) {
  return left.gain >= options.remainder_gain && !left.terms.empty();
}

namespace {

std::string names_of(const Model& model) {
  std::string text;
  for (const Found& found : model.found) text += (text.empty() ? "" : " and ") + found.pick.candidate->name;
  return text;
}

}  // namespace

std::string doubt_about(const Model& model, const Description& left, const std::vector<identify::RunEquations>& after,
                        const std::vector<bool>& out, const VerdictOptions& options) {
  if (model.found.empty()) return {};
  const std::string names = names_of(model);
  if (model.one_more) return fmt::format("{} are not enough: one more effect would pass the threshold", names);
  double explained = 0;
  for (const Found& found : model.found) explained += 2 * found.log_odds;
  if (is_gap(left, options) && left.gain > std::max(options.remainder_most, options.remainder_share * explained)) {
    return fmt::format("{} would leave too much: {:.0f} times the noise in all", names, std::sqrt(left.gain));
  }
  struct Kind {
    std::string_view what;
    MeanSquare Left::*of;
  };
  for (const Kind& kind : {Kind{"the readings of the bar", &Left::radial}, Kind{"the torques", &Left::torque}}) {
    if (const std::optional<double> times = not_foretold(after, out, kind.of, options)) {
      return fmt::format("{} would explain the runs fitted, but {} of the runs held out are {:.1f} times as far off",
                         names, kind.what, *times);
    }
  }
  return {};
}

}  // namespace plumbline::diagnose
