#include "diagnose/gaps.hpp"

#include <cmath>

#include "base/parallel.hpp"

namespace plumbline::diagnose {
namespace {

using identify::RunEquations;
using measure::Run;

std::optional<double> rms_if_any(const MeanSquare& of) {
  return of.count > 0 ? std::optional(of.root()) : std::nullopt;
}

const std::vector<RunEquations>& second_of(const StageResiduals& residuals) {
  return residuals.second.empty() ? residuals.base : residuals.second;
}

std::optional<Circularity> circularity_of(const machine::MachineModel& machine, const Run& run,
                                          const physics::ForceModel& found, const CompensatedOptions& options) {
  const std::optional<double> measured = measured_circularity(run);
  if (!measured) return std::nullopt;
  return Circularity{*measured, *compensated_circularity(machine.rotation, run, physics::ForceModel(machine), options),
                     *compensated_circularity(machine.rotation, run, found, options)};
}

}  // namespace

Rms rms_of(const std::vector<RunEquations>& runs, const std::vector<bool>& out, bool held_out) {
  const ResidualSums all = residual_sums(runs, out, held_out);
  return {rms_if_any(all.radial), rms_if_any(all.torque)};
}

Gap gap_of(const StageResiduals& residuals, const std::vector<bool>& out, bool held_out) {
  return {rms_of(residuals.base, out, held_out), rms_of(second_of(residuals), out, held_out),
          rms_of(residuals.after, out, held_out)};
}

std::vector<RunGap> run_gaps(const machine::MachineModel& machine, const std::vector<Run>& runs,
                             const std::vector<bool>& out, const StageResiduals& residuals,
                             const physics::ForceModel& found, const CompensatedOptions& options) {
  std::vector<RunGap> gaps(runs.size());
  for_each_index(runs.size(), [&](std::size_t i) {
    const RunEquations& base = residuals.base[i];
    const RunEquations& second = second_of(residuals)[i];
    const RunEquations& after = residuals.after[i];
    RunGap gap{runs[i].id, out[i]};
    for (std::size_t c = 0; c < base.channels.size(); ++c) {
      const Eigen::Index n = base.samples;
      const auto first = static_cast<Eigen::Index>(c) * n;
      const auto rms = [&](const RunEquations& of) { return of.residual.segment(first, n).norm() / std::sqrt(n); };
      gap.channels.push_back({base.channels[c], rms(base), rms(second), rms(after)});
      if (base.channels[c] != identify::kRadial) continue;
      gap.angle = Eigen::Map<const Eigen::VectorXd>(runs[i].angle.data(), n);
      gap.radial_before = base.residual.head(n);
      gap.radial_after = after.residual.head(n);
    }
    gap.circularity = circularity_of(machine, runs[i], found, options);
    gaps[i] = std::move(gap);
  });
  return gaps;
}

}  // namespace plumbline::diagnose
