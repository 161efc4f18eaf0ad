#include "diagnose/doubt.hpp"

#include <cmath>
#include <numbers>

#include "base/units.hpp"

namespace plumbline::diagnose {

Left left_of(const identify::RunEquations& run) {
  Left left;
  for (std::size_t c = 0; c < run.channels.size(); ++c) {
    const auto first = static_cast<Eigen::Index>(c) * run.samples;
    (run.channels[c] == identify::kRadial ? left.radial : left.torque).add(run.residual.segment(first, run.samples));
  }
  return left;
}

std::optional<double> not_foretold(const std::vector<identify::RunEquations>& residuals, const std::vector<bool>& out,
                                   MeanSquare Left::*kind, const VerdictOptions& options) {
  std::vector<double> fitted;  // mean squares of single runs
  std::vector<double> held_out;
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    const MeanSquare left = left_of(residuals[i]).*kind;
    if (left.count > 0) (out[i] ? held_out : fitted).push_back(left.root() * left.root());
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

}  // namespace plumbline::diagnose
