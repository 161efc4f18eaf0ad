#include "jobs/expected/expected_error.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/parallel.hpp"
#include "identify/posterior/posterior_file.hpp"

namespace plumbline::jobs {
namespace {

constexpr std::size_t kPosesATime = 8;  // that one thread takes at once

// How long the machine is nearer to a sample than to any other; one where nothing has a time.
std::vector<double> weights_of(const std::vector<compensate::PathSample>& samples) {
  std::vector<double> weights(samples.size(), 1);
  const double whole = samples.back().time_s - samples.front().time_s;
  if (!(whole > 0)) return weights;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double from = samples[i == 0 ? 0 : i - 1].time_s;
    const double to = samples[std::min(i + 1, samples.size() - 1)].time_s;
    weights[i] = std::max(to - from, 1e-9 * whole) / 2;
  }
  return weights;
}

}  // namespace

Knowledge knowledge_of(const machine::MachineModel& model) {
  try {
    identify::Posterior posterior = identify::known_of(model);
    if (posterior.unknowns.size() == 0) return {};
    return {std::move(posterior), {}};
  } catch (const Refusal& refusal) {
    Diagnostic warning = refusal.diagnostic();
    warning.severity = Severity::warning;
    warning.message = "what is expected to be left at the tip is not known: " + warning.message;
    return {{}, std::move(warning)};
  }
}

void ExpectedTally::Sums::add(const TipDoubt& doubt, const compensate::SourceLine& at, double weight) {
  figures.mean += weight * doubt.mean;
  figures.within += weight * doubt.within;
  if (doubt.within > figures.largest_within) {
    figures.largest_within = doubt.within;
    figures.line = at.line;
    figures.file = at.file;
  }
  for (std::size_t c = 0; c < kCauses; ++c) figures.rms[c] += weight * doubt.rms[c] * doubt.rms[c];
}

void ExpectedTally::Sums::end(double weights) {
  figures.mean /= weights;
  figures.within /= weights;
  for (double& rms : figures.rms) rms = std::sqrt(rms / weights);
}

void ExpectedTally::add(const PoseDoubt& doubt, const compensate::SourceLine& at, double weight) {
  stands_.add(doubt.stands, at, weight);
  if (doubt.touched_off) touched_off_.add(*doubt.touched_off, at, weight);
  has_zero_ = doubt.touched_off.has_value();
  weights_ += weight;
  ++poses_;
}

ExpectedError ExpectedTally::take(const identify::Posterior& posterior, const AxisWords& zero) {
  stands_.end(weights_);
  touched_off_.end(weights_);
  ExpectedError expected{posterior.made_by, posterior.from_data, poses_, stands_.figures, {}, zero};
  if (has_zero_) expected.touched_off = touched_off_.figures;
  return expected;
}

std::vector<std::optional<PoseDoubt>> doubts_at(const machine::MachineModel& model,
                                                const identify::Posterior& posterior,
                                                const compensate::Settings& settings, const AxisWords& zero,
                                                const std::vector<compensate::PathSample>& samples) {
  TipDoubts doubts(model, posterior, settings);
  doubts.leave_out_axes();
  std::vector<std::optional<PoseDoubt>> all(samples.size());
  for (std::size_t begin = 0; begin < samples.size();) {  // tool by tool
    std::size_t end = begin;
    while (end < samples.size() && samples[end].in_spindle == samples[begin].in_spindle) ++end;
    if (samples[begin].in_spindle) doubts.set_tool(*samples[begin].in_spindle);
    doubts.touch_off(zero);
    for_each_index((end - begin + kPosesATime - 1) / kPosesATime, [&](std::size_t group) {
      const std::size_t first = begin + group * kPosesATime;
      for (std::size_t i = first; i < std::min(end, first + kPosesATime); ++i) all[i] = doubts.at(samples[i].target);
    });
    begin = end;
  }
  return all;
}

std::vector<std::optional<PoseDoubt>> doubts_at(const machine::MachineModel& model,
                                                const identify::Posterior& posterior,
                                                const compensate::Settings& settings, const AxisWords& zero,
                                                const compensate::DrawnPath& path) {
  std::vector<compensate::PathSample> samples;
  for (const compensate::DrawnPoint& point : path.points) {
    const compensate::RecordedPoint& recorded = point.recorded;
    samples.push_back({recorded.line, {}, recorded.time_s, recorded.asked, recorded.in_spindle});
  }
  return doubts_at(model, posterior, settings, zero, samples);
}

std::optional<ExpectedError> expected_along(const machine::MachineModel& model, const identify::Posterior& posterior,
                                            const compensate::Settings& settings,
                                            const std::vector<compensate::PathSample>& samples) {
  if (samples.empty()) return std::nullopt;
  const AxisWords zero = settings.touch_off.value_or(samples.front().target.pose);
  const std::vector<double> weights = weights_of(samples);
  const std::vector<std::optional<PoseDoubt>> doubts = doubts_at(model, posterior, settings, zero, samples);
  ExpectedTally tally;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (doubts[i]) tally.add(*doubts[i], {samples[i].line, samples[i].file}, weights[i]);
  }
  return tally.any() ? std::optional(tally.take(posterior, zero)) : std::nullopt;
}

ExpectedAlong::ExpectedAlong(const machine::MachineModel& model, const compensate::Settings& settings, bool wanted)
    : model_(model), settings_(settings) {
  if (wanted) knowledge_ = knowledge_of(model);
}

Expectation ExpectedAlong::take(const compensate::DrawnPath* path) {
  Expectation expectation{{}, std::move(knowledge_.warning), std::move(knowledge_.posterior), {}};
  if (!expectation.posterior) return expectation;
  expectation.error = expected_along(model_, *expectation.posterior, settings_, samples_.take());
  if (path != nullptr && expectation.error)
    expectation.drawn = doubts_at(model_, *expectation.posterior, settings_, expectation.error->zero, *path);
  return expectation;
}

}  // namespace plumbline::jobs
