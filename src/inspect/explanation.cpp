#include "inspect/explanation.hpp"

#include <algorithm>
#include <cmath>

namespace plumbline::inspect {
namespace {

using Eigen::Index;
using measure::Run;

double nats_of(const Tried& tried, double before, double usual) {
  return (before - tried.chi2) / (2 * usual) - tried.penalty;
}

// Whether a fault is as large as what people get wrong.
bool large_enough(const Fault& fault, const Run& run, const InspectOptions& options) {
  const LeastFaults& least = options.least;
  const auto off = [&](const Vector3<double>& from) {
    return (Vector3<double>(fault.values[0], fault.values[1], fault.values[2]) - from).norm();
  };
  const double value = fault.values.empty() ? 0 : std::abs(fault.values[0]);
  switch (fault.kind) {
    case FaultKind::clock:
      return value * static_cast<double>(run.samples() - 1) >= least.samples * (run.time.back() - run.time.front());
    case FaultKind::angle_zero:
      return value >= least.angle;
    case FaultKind::centre:
      return off(run.centre_W) >= least.place;
    case FaultKind::tilt:
      return off(run.tilt) >= least.tilt;
    case FaultKind::payload:
      return std::abs(value - run.payload_mass) >= least.payload;
    case FaultKind::radius:
      return std::abs(value - run.radius) >= least.place;
    case FaultKind::bar_length:
      return std::abs(value - run.bar_length()) >= least.place;
    case FaultKind::drift:
    case FaultKind::bar_step:
      return value >= least.noises * options.usual_radial;
    case FaultKind::motor_zero:
      return value >= least.noises * options.usual_torque;
    default:
      return true;
  }
}

}  // namespace

void leave_large_ones(std::vector<Tried>& all, const Run& run, const InspectOptions& options) {
  std::erase_if(all, [&](const Tried& one) { return !large_enough(one.fault, run, options); });
}

std::optional<Fault> explanation(std::vector<Tried> all, const Run& run, double before, Index rows, double usual,
                                 const InspectOptions& options) {
  leave_large_ones(all, run, options);
  const auto count = static_cast<double>(rows);
  const double expected = usual * count;
  std::sort(all.begin(), all.end(),
            [&](const Tried& a, const Tried& b) { return nats_of(a, before, usual) > nats_of(b, before, usual); });
  if (all.empty()) return std::nullopt;
  const Tried& best = all.front();
  const double nats = nats_of(best, before, usual);
  const bool explains = before - best.chi2 > options.explained * (before - expected);
  if (nats < options.least_nats || !explains || best.chi2 > options.near * expected) return std::nullopt;
  Fault fault = best.fault;
  fault.before = std::sqrt(before / count);
  fault.after = std::sqrt(best.chi2 / count);
  fault.nats = nats;
  for (const Tried& other : all) {
    const auto& known = fault.or_these;
    const bool close = nats - nats_of(other, before, usual) < options.as_good;
    if (!close || other.fault.kind == fault.kind ||
        std::find(known.begin(), known.end(), other.fault.kind) != known.end())
      continue;
    fault.or_these.push_back(other.fault.kind);
  }
  return fault;
}

}  // namespace plumbline::inspect
