#include "diagnose/readings/channel_flaw.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace plumbline::diagnose {
namespace {

using machine::kStruts;

struct Factor {
  double cross = 0, model = 0, measured = 0;

  double size() const { return model > 0 ? cross / model : 1; }
  bool follows(double share) const { return model > 0 && cross * cross > share * model * measured; }
};

std::array<Factor, kStruts> factors_of(const std::vector<measure::Run>& runs,
                                       const std::vector<identify::RunEquations>& residuals) {
  std::array<Factor, kStruts> factors;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    for (std::size_t j = 0; j < kStruts; ++j) {
      const auto first = residuals[r].first_row(1 + static_cast<int>(j));
      if (!first) continue;
      for (Eigen::Index i = 0; i < residuals[r].samples; ++i) {
        const double measured = runs[r].torque[j][static_cast<std::size_t>(i)];
        const double model = measured - residuals[r].residual[*first + i];
        factors[j].cross += measured * model;
        factors[j].model += model * model;
        factors[j].measured += measured * measured;
      }
    }
  }
  return factors;
}

std::string motors_text(const std::vector<std::size_t>& motors) {
  std::vector<std::string> names;
  for (const std::size_t j : motors) names.push_back(fmt::format("torque{}_Nm", j + 1));
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

std::string channel_flaw(const std::vector<measure::Run>& runs, const std::vector<identify::RunEquations>& residuals,
                         const ChannelOptions& options) {
  const std::array<Factor, kStruts> factors = factors_of(runs, residuals);
  std::vector<std::size_t> opposite;
  std::vector<std::size_t> scaled;
  std::vector<std::string> sizes;
  for (std::size_t j = 0; j < kStruts; ++j) {
    if (!factors[j].follows(options.follows)) continue;
    const double size = factors[j].size();
    if (size < options.opposite) {
      opposite.push_back(j);
    } else if (size < options.least || size > options.most) {
      scaled.push_back(j);
      sizes.push_back(fmt::format("{:.3g}", size));
    }
  }
  if (!opposite.empty()) {
    return fmt::format(
        "{} of 6 torques ({}) run against the model's in all runs: no effect does that; check the sign of each channel "
        "(positive where the strut is pulled)",
        opposite.size(), motors_text(opposite));
  }
  if (!scaled.empty()) {
    return fmt::format(
        "{} of 6 torques ({}) are {} times the model's: no effect does that; check the unit of each channel (N m at "
        "the "
        "screw, not per cent of the rated torque, not a current)",
        scaled.size(), motors_text(scaled), fmt::join(sizes, ", "));
  }
  return {};
}

}  // namespace plumbline::diagnose
