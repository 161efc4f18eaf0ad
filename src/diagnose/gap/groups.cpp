#include "diagnose/gap/groups.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/units.hpp"
#include "machine/limits.hpp"

namespace plumbline::diagnose {

namespace {

using identify::RunEquations;
using measure::Run;

double tilt_of(const machine::RotationOrder& order, const Run& run) {
  return machine::tilt(machine::rotation<double>(order, run.tilt)) / kDeg;
}

class Groups {
 public:
  Groups(const std::vector<Run>& runs, const std::vector<RunEquations>& residuals)
      : runs_(runs), residuals_(residuals) {}

  // Runs whose figure lies from one edge to the next, the last edge included.
  void between(Grouping by, const std::vector<double>& edges, const std::function<double(const Run&)>& of) {
    for (std::size_t g = 0; g + 1 < edges.size(); ++g) {
      const bool last = g + 2 == edges.size();
      add(by, edges[g], edges[g + 1],
          [&](const Run& r) { return of(r) >= edges[g] && (of(r) < edges[g + 1] || (last && of(r) <= edges[g + 1])); });
    }
  }
  void each(Grouping by, const std::function<double(const Run&)>& of) {
    std::vector<double> values;
    for (const Run& run : runs_) values.push_back(of(run));
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
    for (const double value : values) {
      add(by, value, value, [&](const Run& r) { return of(r) == value; });
    }
  }
  std::vector<RunGroup> found;

 private:
  void add(Grouping by, double from, double to, const std::function<bool(const Run&)>& belongs) {
    RunGroup group{by, from, to};
    BarAndTorqueSquares squares;
    for (std::size_t r = 0; r < runs_.size(); ++r) {
      if (!belongs(runs_[r])) continue;
      ++group.runs;
      for (std::size_t c = 0; c < residuals_[r].channels.size(); ++c) {
        const Eigen::Index n = residuals_[r].samples;
        for (const double e : residuals_[r].residual.segment(static_cast<Eigen::Index>(c) * n, n)) {
          squares.add(residuals_[r].channels[c], e);
        }
      }
    }
    if (group.runs == 0) return;
    group.rms = squares.root();
    found.push_back(group);
  }

  const std::vector<Run>& runs_;
  const std::vector<RunEquations>& residuals_;
};

}  // namespace

std::string_view to_text(Grouping grouping) {
  switch (grouping) {
    case Grouping::tilt:
      return "tilt_deg";
    case Grouping::feed:
      return "feed_mm_min";
    case Grouping::payload:
      return "payload_kg";
    case Grouping::start:
      break;
  }
  return "start_h";
}

std::vector<RunGroup> groups_of(const machine::RotationOrder& order, const std::vector<Run>& runs,
                                const std::vector<RunEquations>& residuals, const GroupOptions& options) {
  Groups groups(runs, residuals);
  groups.between(Grouping::tilt, options.tilts_deg, [&](const Run& r) { return tilt_of(order, r); });
  // feeds of files differ by rounding
  groups.each(Grouping::feed, [](const Run& r) { return std::round(r.feed / kMmPerMin * 10) / 10; });
  groups.each(Grouping::payload, [](const Run& r) { return r.payload_mass; });
  const auto [first, last] =
      std::minmax_element(runs.begin(), runs.end(), [](const Run& a, const Run& b) { return a.start < b.start; });
  constexpr double kHour = 3600;
  std::vector<double> edges;
  for (int g = 0; g <= options.start_groups; ++g) {
    edges.push_back((first->start + (last->start - first->start) * g / options.start_groups) / kHour);
  }
  if (last->start > first->start) groups.between(Grouping::start, edges, [](const Run& r) { return r.start / kHour; });
  return groups.found;
}

}  // namespace plumbline::diagnose
