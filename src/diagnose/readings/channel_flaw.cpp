#include "diagnose/readings/channel_flaw.hpp"

#include <algorithm>
#include <array>

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

}  // namespace

std::optional<ChannelFlaw> channel_flaw(const std::vector<measure::Run>& runs,
                                        const std::vector<identify::RunEquations>& residuals,
                                        const ChannelOptions& options) {
  const std::array<Factor, kStruts> factors = factors_of(runs, residuals);
  ChannelFlaw sign{ChannelFlaw::Kind::sign, {}, {}};
  ChannelFlaw unit{ChannelFlaw::Kind::unit, {}, {}};
  for (std::size_t j = 0; j < kStruts; ++j) {
    if (!factors[j].follows(options.follows)) continue;
    const double size = factors[j].size();
    const bool opposite = size < options.opposite;
    if (!opposite && size >= options.least && size <= options.most) continue;
    ChannelFlaw& flaw = opposite ? sign : unit;
    flaw.motors.push_back(j);
    flaw.factors.push_back(size);
  }
  if (!sign.motors.empty()) return sign;
  if (!unit.motors.empty()) return unit;
  return std::nullopt;
}

}  // namespace plumbline::diagnose
