#include "jobs/circularity.hpp"

namespace plumbline::jobs {
namespace {

constexpr int kHarmonics = 8;

bool differ_in_direction_alone(const measure::Run& a, const measure::Run& b) {
  return a.direction != b.direction && a.centre_W == b.centre_W && a.radius == b.radius && a.bar == b.bar &&
         a.tilt == b.tilt && a.feed == b.feed && a.payload_mass == b.payload_mass;
}

std::vector<PairCircularity> pairs_of(const std::vector<measure::Run>& runs) {
  std::vector<PairCircularity> pairs;
  std::vector<bool> taken(runs.size(), false);
  for (std::size_t a = 0; a < runs.size(); ++a) {
    for (std::size_t b = a + 1; b < runs.size() && !taken[a]; ++b) {
      if (taken[b] || !runs[a].has_radial() || !runs[b].has_radial()) continue;
      if (!differ_in_direction_alone(runs[a], runs[b])) continue;
      taken[a] = taken[b] = true;
      const bool is_ccw = runs[a].direction == measure::Direction::ccw;
      const measure::Run& ccw = is_ccw ? runs[a] : runs[b];
      const measure::Run& cw = is_ccw ? runs[b] : runs[a];
      pairs.push_back(
          {ccw.id, cw.id, measure::bidirectional_figures(measure::profile_of(ccw), measure::profile_of(cw))});
    }
  }
  return pairs;
}

}  // namespace

CircularityTable circularity_table(const measure::Dataset& dataset) {
  CircularityTable table;
  for (const measure::Run& run : dataset.runs) {
    if (!run.has_radial()) continue;
    const measure::Profile profile = measure::profile_of(run);
    table.runs.push_back({run.id, measure::circularity_figures(profile), measure::harmonics(profile, kHarmonics)});
  }
  table.pairs = pairs_of(dataset.runs);
  return table;
}

}  // namespace plumbline::jobs
