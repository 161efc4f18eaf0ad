// Circular tests for the tests of this module.
#pragma once

#include <numbers>
#include <string>
#include <vector>

#include "base/units.hpp"
#include "measure/dataset.hpp"

namespace plumbline::testing {

/// A run of the paper's kind with readings of zero at evenly spaced angles: radius 144 mm, bar 150 mm, F1000.
inline measure::Run circle_run(const Vector3<double>& centre_mm, const Vector3<double>& tilt_deg,
                               measure::Direction direction = measure::Direction::ccw, std::size_t samples = 120) {
  measure::Run run;
  run.id = "run";
  run.centre_W = centre_mm * kMm;
  run.radius = 144 * kMm;
  run.bar = 150 * kMm;
  run.tilt = tilt_deg * kDeg;
  run.direction = direction;
  run.feed = 1000 * kMmPerMin;
  for (std::size_t i = 0; i < samples; ++i) {
    const double swept = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(samples);
    run.angle.push_back(run.turn() * swept);
    run.time.push_back(swept * run.radius / run.feed);
  }
  run.radial.assign(samples, 0);
  for (auto& torque : run.torque) torque.assign(samples, 0);
  return run;
}

/// The text of a dataset of one run whose table is run.csv; `more` are lines for its [[run]].
inline std::string dataset_text(const std::string& more = "", const std::string& direction = "ccw") {
  return "plumbline = \"dataset 1\"\nmachine = \"pm600-like\"\n\n[[run]]\nid = \"a\"\nfile = \"run.csv\"\n"
         "centre_mm = [0, 100, -1008]\nradius_mm = 144\ntilt_deg = [-22, 0, 0]\ndirection = \"" +
         direction + "\"\nfeed_mm_min = 1000\n" + more;
}

/// Rows `angle,radial` every 30 deg, the angles as a control shows them.
inline std::string table_text(double turn = 1, const std::string& header = "angle_deg,radial_um") {
  std::string text = header + "\n";
  for (int i = 0; i < 12; ++i) {
    const int angle = static_cast<int>(turn * 30 * i + 360) % 360;
    text += std::to_string(angle) + "," + std::to_string(i) + ".25\n";
  }
  return text;
}

}  // namespace plumbline::testing
