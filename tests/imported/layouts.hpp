// One measured circle in the layouts in which instruments and controls write it.
#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "support/scratch.hpp"

namespace plumbline::testing {

constexpr double kPi = 3.14159265358979323846;

/// What is measured at an angle (deg).
inline double radial_um(double deg) { return 12 * std::cos(2 * deg * kPi / 180) + 3 * std::sin(deg * kPi / 180); }
inline double torque_of(int motor, double deg) { return motor + std::sin(deg * kPi / 180 + motor); }

/// One sample: seconds from the start of the record, angle in deg, not wrapped.
struct Moment {
  double seconds = 0, deg = 0;
};

/// A way at 1000 mm/min on 144 mm, every `step` deg, from one angle to another.
inline std::vector<Moment> way(double from, double to, double step = 3, double start_s = 0) {
  const double deg_per_s = 1000 / 60.0 / 144 * 180 / kPi;
  std::vector<Moment> moments;
  const int count = static_cast<int>(std::lround(std::abs(to - from) / step));
  for (int i = 0; i <= count; ++i) {
    moments.push_back({start_s + i * step / deg_per_s, from + (to > from ? 1 : -1) * i * step});
  }
  return moments;
}

/// A line for each moment.
inline std::string lines(const std::vector<Moment>& moments, const std::function<std::string(const Moment&)>& line) {
  std::string text;
  for (const Moment& moment : moments) text += line(moment) + "\n";
  return text;
}

inline std::string comma(std::string number) {
  for (char& c : number) c = c == '.' ? ',' : c;
  return number;
}

/// [[run]] of a map.
inline std::string map_run(const std::string& id, const std::string& file, const std::string& direction = "ccw",
                           const std::string& more = "") {
  return fmt::format(
      "[[run]]\nid = \"{}\"\nfile = \"{}\"\ncentre_mm = [0, 100, -1008]\nradius_mm = 144\nbar_mm = 150\n"
      "tilt_deg = [0, 0, 0]\ndirection = \"{}\"\nfeed_mm_min = 1000\n{}\n",
      id, file, direction, more);
}

inline const std::string kMapHead = "plumbline = \"map 1\"\nmachine = \"m\"\n";

}  // namespace plumbline::testing
