#include "jobs/circularity.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/number_text.hpp"
#include "base/units.hpp"

namespace plumbline::jobs {
namespace {

using Json = nlohmann::ordered_json;

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

std::string um_text(double metres) { return to_decimal(metres / kUm, 2, 2); }  // no "-0.00"

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

std::string circularity_text(const CircularityTable& table) {
  std::string text = fmt::format("{:<24}{:>13}{:>10}{:>10}{:>10}   um\n", "run", "circularity", "G", "F max", "F min");
  for (const RunCircularity& run : table.runs) {
    const measure::CircularityFigures& f = run.figures;
    text += fmt::format("{:<24}{:>13}{:>10}{:>10}{:>10}\n", run.id, um_text(f.least_squares), um_text(f.minimum_zone),
                        um_text(f.radial_max), um_text(f.radial_min));
  }
  if (table.pairs.empty()) return text;
  text += fmt::format("\n{:<37}{:>10}{:>10}   um\n", "both directions", "G(b)", "D");
  for (const PairCircularity& pair : table.pairs) {
    text += fmt::format("{:<37}{:>10}{:>10}\n", pair.ccw + ", " + pair.cw, um_text(pair.figures.minimum_zone),
                        um_text(pair.figures.mean_radial));
  }
  return text;
}

std::string circularity_json(const CircularityTable& table) {
  Json json{{"plumbline", "circularity 1"}, {"runs", Json::array()}, {"pairs", Json::array()}};
  for (const RunCircularity& run : table.runs) {
    Json waves = Json::array();
    for (const measure::Harmonic& wave : run.harmonics) {
      waves.push_back(
          {{"order", wave.order}, {"amplitude_um", wave.amplitude / kUm}, {"phase_deg", wave.phase / kDeg}});
    }
    const measure::CircularityFigures& f = run.figures;
    json["runs"].push_back({{"id", run.id},
                            {"circularity_um", f.least_squares / kUm},
                            {"G_um", f.minimum_zone / kUm},
                            {"F_max_um", f.radial_max / kUm},
                            {"F_min_um", f.radial_min / kUm},
                            {"harmonics", waves}});
  }
  for (const PairCircularity& pair : table.pairs) {
    json["pairs"].push_back({{"ccw", pair.ccw},
                             {"cw", pair.cw},
                             {"G_b_um", pair.figures.minimum_zone / kUm},
                             {"G_b_least_squares_um", pair.figures.least_squares / kUm},
                             {"D_um", pair.figures.mean_radial / kUm}});
  }
  return json.dump(1) + "\n";
}

}  // namespace plumbline::jobs
