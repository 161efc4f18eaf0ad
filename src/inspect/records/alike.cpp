#include "inspect/records/alike.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <set>

#include "base/angle.hpp"
#include "base/units.hpp"
#include "identify/equations/run_model.hpp"
#include "inspect/records/records.hpp"
#include "inspect/statistics.hpp"

namespace plumbline::inspect {
namespace {

using measure::Run;

constexpr std::size_t kLooked = 200;   // samples of a run, evenly taken
constexpr double kFine = 200;          // steps within the range of a channel whose readings tell runs apart
constexpr double kSameAngle = 3.5e-4;  // rad: what two exports round off, at most
constexpr std::ptrdiff_t kForResolution = 4000;
constexpr std::size_t kValuesThatTell = 16;  // different ones, of a channel

double fine_resolution(const std::vector<double>& values) {
  if (values.empty()) return 0;
  const auto first = std::min<std::ptrdiff_t>(kForResolution, static_cast<std::ptrdiff_t>(values.size()));
  const double step = resolution({values.begin(), values.begin() + first});
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return step > 0 && *most - *least > kFine * step ? step : 0;
}

// Share of samples in which `one` is `by` times `other`, exactly.
double share_alike(const std::vector<double>& one, const std::vector<double>& other, double by) {
  std::size_t alike = 0;
  for (std::size_t i = 0; i < one.size(); ++i) {
    if (one[i] == by * other[i]) ++alike;
  }
  return static_cast<double>(alike) / static_cast<double>(one.size());
}

}  // namespace

AlikeRuns::AlikeRuns(const std::vector<Run>& runs) : runs_(runs), turns_(runs.size()) {
  for (std::size_t r = 0; r < runs.size(); ++r) {
    Turn& turn = turns_[r];
    turn.sample.resize(runs[r].samples());
    std::iota(turn.sample.begin(), turn.sample.end(), std::size_t{0});
    const std::vector<double>& angle = runs[r].angle;
    std::sort(turn.sample.begin(), turn.sample.end(),
              [&](std::size_t a, std::size_t b) { return within_turn(angle[a]) < within_turn(angle[b]); });
    for (const std::size_t i : turn.sample) turn.angle.push_back(within_turn(angle[i]));
    for (int c = 0; c < identify::kChannels; ++c) {
      turn.resolution.push_back(fine_resolution(readings_of_channel(runs[r], c)));
    }
  }
}

bool AlikeRuns::alike(std::size_t a, std::size_t b, double share) const {
  const Run& one = runs_[a];
  const Run& other = runs_[b];
  std::size_t compared = 0;
  double alike = 0;
  for (int c = 0; c < identify::kChannels && one.samples() == other.samples(); ++c) {
    const std::vector<double>& of_one = readings_of_channel(one, c);
    const std::vector<double>& of_other = readings_of_channel(other, c);
    if (of_one.empty() || of_one.size() != of_other.size()) continue;
    compared += of_one.size();
    alike += share_alike(of_one, of_other, 1) * static_cast<double>(of_one.size());
  }
  if (compared > 0 && alike > share * static_cast<double>(compared)) return true;
  return one.samples() <= other.samples() ? alike_by_angle(a, b, share) : alike_by_angle(b, a, share);
}

bool AlikeRuns::alike_by_angle(std::size_t few, std::size_t many, double share) const {
  const Turn& turn = turns_[many];
  if (turn.angle.empty()) return false;
  const std::size_t samples = turns_[few].angle.size();
  const std::size_t step = std::max<std::size_t>(1, samples / kLooked);
  const double tolerance = std::min(kSameAngle, 0.1 * kTurn / static_cast<double>(turn.angle.size()));
  std::size_t looked = 0;
  std::size_t met = 0;
  std::size_t compared = 0;
  std::size_t same = 0;
  for (std::size_t k = 0; k < samples; k += step) {
    ++looked;
    const double angle = turns_[few].angle[k];
    const auto next = std::lower_bound(turn.angle.begin(), turn.angle.end(), angle - tolerance);
    if (next == turn.angle.end() || *next > angle + tolerance) continue;
    ++met;
    const std::size_t i = turns_[few].sample[k];
    const std::size_t j = turn.sample[static_cast<std::size_t>(next - turn.angle.begin())];
    for (int c = 0; c < identify::kChannels; ++c) {
      const std::vector<double>& one = readings_of_channel(runs_[few], c);
      const std::vector<double>& other = readings_of_channel(runs_[many], c);
      const double of_few = turns_[few].resolution[static_cast<std::size_t>(c)];
      const double of_many = turn.resolution[static_cast<std::size_t>(c)];
      if (one.empty() || other.empty() || of_few == 0 || of_many == 0) continue;
      ++compared;
      if (std::abs(one[i] - other[j]) <= 0.51 * std::max(of_few, of_many)) ++same;
    }
  }
  return 2 * met > looked && compared > 0 && static_cast<double>(same) > share * static_cast<double>(compared);
}

std::vector<Fault> motors_alike(const std::vector<Run>& runs, double share) {
  std::vector<Fault> faults;
  for (int a = 1; a < identify::kChannels; ++a) {
    for (int b = 1; b < a; ++b) {
      Fault fault{FaultKind::motors_alike, {}};
      fault.channels = {a, b};
      for (std::size_t r = 0; r < runs.size(); ++r) {
        const std::vector<double>& one = readings_of_channel(runs[r], a);
        const std::vector<double>& other = readings_of_channel(runs[r], b);
        if (one.empty() || one.size() != other.size()) continue;
        if (std::set<double>(one.begin(), one.end()).size() < kValuesThatTell) continue;
        if (std::max(share_alike(one, other, 1), share_alike(one, other, -1)) > share) fault.runs.push_back(r);
      }
      if (fault.runs.empty()) continue;
      fault.all = fault.runs.size() == runs.size();
      faults.push_back(std::move(fault));
    }
  }
  return faults;
}

}  // namespace plumbline::inspect
