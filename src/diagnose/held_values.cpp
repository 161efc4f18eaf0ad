#include "diagnose/held_values.hpp"

#include <fmt/format.h>

#include "base/units.hpp"

namespace plumbline::diagnose {

identify::Held held_values(const Workbench& bench, const physics::ForceModel& given, const std::vector<Pick>& picks,
                           const Refit& fit, const identify::HoldOptions& options) {
  identify::Unknowns unknowns = bench.candidates.unknowns;
  for (const Pick& pick : picks) {
    for (const int place : pick.unknowns) unknowns.set_free(static_cast<std::size_t>(place));
  }
  const auto size = static_cast<Eigen::Index>(unknowns.size());
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(size, size);
  covariance(fit.places, fit.places) = fit.covariance;
  return identify::hold_unsure(bench.machine.rotation, bench.runs, given, unknowns, fit.values, covariance, options);
}

std::string shift_text(const identify::Held& held) {
  return fmt::format("the tip as a whole would move by {:.1f} um, +- {:.1f}: {:.1f} um of it held back",
                     held.shift / kUm, held.shift_doubt / kUm, held.back / kUm);
}

}  // namespace plumbline::diagnose
