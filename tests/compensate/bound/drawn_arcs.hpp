// Programs of arcs drawn from a seed: circles and helices in three planes, by their centre and by their radius, as
// increments, in both units and feed modes, some with a turn of the tool.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include <fmt/format.h>

#include "base/axes.hpp"
#include "nc/control/state/motion.hpp"

namespace plumbline {

class DrawnArcs {
 public:
  explicit DrawnArcs(unsigned seed) : random_(seed) {}

  /// One arc a block, after the first three blocks.
  std::string text(int arcs) {
    inches_ = chance(0.3);
    std::string out =
        fmt::format("{} G90 G94\nG0 X0 Y0 Z0 A0 B0 C0\nF{}\n", inches_ ? "G20" : "G21", inches_ ? 40 : 1000);
    for (int i = 0; i < arcs; ++i) out += arc() + "\n";
    return out + "M2\n";
  }

 private:
  bool chance(double p) { return std::bernoulli_distribution(p)(random_); }
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  double rounded(double value) const {
    const double digits = inches_ ? 1e6 : 1e4;
    return std::round(value * digits) / digits;
  }
  std::string word(char letter, double value) const {
    return fmt::format(" {}{:.{}f}", letter, value, inches_ ? 6 : 4);
  }

  std::string arc() {
    plane_ = static_cast<nc::Plane>(std::uniform_int_distribution<int>(0, 2)(random_));
    const nc::PlaneAxes axes = nc::axes_of(plane_);
    const bool counter_clockwise = chance(0.5);
    const bool whole = chance(0.15);
    double radius = 0;
    double begin = 0;
    double sweep = 0;
    double u = 0;
    double v = 0;
    do {  // until it stays near the middle
      radius = std::exp(uniform(std::log(1.0), std::log(40.0))) / (inches_ ? 25.4 : 1);
      begin = uniform(0, 2 * std::numbers::pi);
      sweep = (whole ? 2 * std::numbers::pi : uniform(0.1, 5.8)) * (counter_clockwise ? 1 : -1);
      u = at_[axes.first] + radius * (std::cos(begin + sweep) - std::cos(begin));
      v = at_[axes.second] + radius * (std::sin(begin + sweep) - std::sin(begin));
    } while (std::max({std::abs(u), std::abs(v), radius}) > 40 / (inches_ ? 25.4 : 1));
    const bool increments = chance(0.25);
    std::string text = fmt::format("{} {} {}", increments ? "G91" : "G90", kPlanes[static_cast<std::size_t>(plane_)],
                                   counter_clockwise ? "G3" : "G2");
    const AxisWords from = at_;
    const auto go = [&](Axis axis, double to) {
      const double by = rounded(to - at_[axis]);
      text += word(letter(axis), increments ? by : rounded(to));
      at_[axis] = increments ? at_[axis] + by : rounded(to);
    };
    if (!whole || chance(0.5)) {
      go(axes.first, whole ? at_[axes.first] : u);
      go(axes.second, whole ? at_[axes.second] : v);
    }
    if (chance(0.3)) go(axes.third, at_[axes.third] * 0.5 + uniform(-4, 4) / (inches_ ? 25.4 : 1));
    if (chance(0.2)) go(Axis::A, uniform(-4, 4));
    text += way(axes, from, radius, begin, std::abs(sweep), whole);
    return text + (chance(0.2) ? fmt::format(" F{:.1f}", uniform(300, 2000) / (inches_ ? 25.4 : 1)) : "");
  }

  std::string way(const nc::PlaneAxes& axes, const AxisWords& from, double radius, double begin, double sweep,
                  bool whole) {
    static constexpr char kCentre[] = {'I', 'J', 'K'};
    const bool near_half = std::abs(sweep - std::numbers::pi) < 0.3;  // a radius says little about its centre there
    if (!whole && !near_half && sweep < 5 && chance(0.3)) return word('R', sweep > std::numbers::pi ? -radius : radius);
    const double u = -radius * std::cos(begin);
    const double v = -radius * std::sin(begin);
    const bool absolute = chance(0.3);
    std::string text = absolute ? " G90.1" : " G91.1";
    text += word(kCentre[index(axes.first)], u + (absolute ? from[axes.first] : 0));
    text += word(kCentre[index(axes.second)], v + (absolute ? from[axes.second] : 0));
    return text + (chance(0.1) ? " P2" : "");
  }

  static constexpr const char* kPlanes[] = {"G17", "G18", "G19"};
  std::mt19937_64 random_;
  AxisWords at_;  // in the program's unit
  nc::Plane plane_ = nc::Plane::xy;
  bool inches_ = false;
};

}  // namespace plumbline
