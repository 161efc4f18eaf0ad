#include "report/measured/circularity_text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/text/number_text.hpp"
#include "base/units.hpp"

namespace plumbline::report {
namespace {

using Json = nlohmann::ordered_json;

std::string um_text(double metres) { return to_decimal(metres / kUm, 2, 2); }  // no "-0.00"

}  // namespace

std::string circularity_text(const jobs::CircularityTable& table) {
  std::string text = fmt::format("{:<24}{:>13}{:>10}{:>10}{:>10}   um\n", "run", "circularity", "G", "F max", "F min");
  for (const jobs::RunCircularity& run : table.runs) {
    const measure::CircularityFigures& f = run.figures;
    text += fmt::format("{:<24}{:>13}{:>10}{:>10}{:>10}\n", run.id, um_text(f.least_squares), um_text(f.minimum_zone),
                        um_text(f.radial_max), um_text(f.radial_min));
  }
  if (table.pairs.empty()) return text;
  text += fmt::format("\n{:<37}{:>10}{:>10}   um\n", "both directions", "G(b)", "D");
  for (const jobs::PairCircularity& pair : table.pairs) {
    text += fmt::format("{:<37}{:>10}{:>10}\n", pair.ccw + ", " + pair.cw, um_text(pair.figures.minimum_zone),
                        um_text(pair.figures.mean_radial));
  }
  return text;
}

std::string circularity_json(const jobs::CircularityTable& table) {
  Json json{{"plumbline", "circularity 1"}, {"runs", Json::array()}, {"pairs", Json::array()}};
  for (const jobs::RunCircularity& run : table.runs) {
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
  for (const jobs::PairCircularity& pair : table.pairs) {
    json["pairs"].push_back({{"ccw", pair.ccw},
                             {"cw", pair.cw},
                             {"G_b_um", pair.figures.minimum_zone / kUm},
                             {"G_b_least_squares_um", pair.figures.least_squares / kUm},
                             {"D_um", pair.figures.mean_radial / kUm}});
  }
  return json.dump(1) + "\n";
}

}  // namespace plumbline::report
