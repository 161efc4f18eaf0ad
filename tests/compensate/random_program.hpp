// Programs drawn from a seed: every feed mode, distance mode, plane and unit, offsets set on the way.
#pragma once

#include <random>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/axes.hpp"

namespace plumbline {

class RandomProgram {
 public:
  /// `flows`: with loops, branches, subprograms, cycles.
  explicit RandomProgram(unsigned seed, bool flows = false) : random_(seed), flows_(flows) {}

  std::string text(int blocks) {
    inches_ = chance(0.3);
    std::string out = fmt::format("({})\nG17 G90 G94 G64 {}\n", "a drawn program", inches_ ? "G20" : "G21");
    out += "G0" + all_axes() + "\n";
    for (int i = 0; i < blocks; ++i) out += block() + "\n";
    return out + "M2\n";
  }

 private:
  // As a loop, a subprogram, a branch, drilling or polar words would have it; positions as they are before it.
  std::string flow() {
    const int label = ++label_;
    const double kind = uniform(0, 1);
    if (inverse_time_ || !feed_stated_) return "(no flow here)";
    if (kind < 0.25) {
      const std::string there = increments(3);
      const std::string back = negated();
      return fmt::format("o{0} repeat [{1}]\nG91 G1{2}\nG1{3} (back)\n{4}\no{0} endrepeat", label,
                         static_cast<int>(uniform(0, 3.99)), there, back, incremental_ ? "G91" : "G90");
    }
    if (kind < 0.45) {
      const std::string there = increments(1);
      return fmt::format(
          "#<i{0}> = 0\no{0} while [#<i{0}> lt 3] (counts)\nG91 G1{1}\n#<i{0}> = [#<i{0}> + 1]\nG1{2} F[{3:.2f} + "
          "#<i{0}> / 3]\n{4}\no{0} endwhile",
          label, there, negated(), uniform(300, 900) / unit(), incremental_ ? "G91" : "G90");
    }
    if (kind < 0.6) {
      return fmt::format(
          "o{0} sub\nM73\nG91 {1}\nG1 X[#1/3] Y[-#2/7] F[#3]\nG1 X[-#1/3] Y[#2/7]\no{0} endsub\n"
          "o{0} call [{2:.3f}] [{3:.3f}] [{4:.1f}]\no{0} call [2] [1] [700]",
          label, inches_ ? "G21" : "G20", uniform(1, 9) / 25.4, uniform(1, 9) / 25.4, uniform(300, 900) / 25.4);
    }
    if (kind < 0.7) {
      const std::string there = increments(2);
      return fmt::format(
          "#{0} = {1:.3f}\no{0} if [#{0} gt 0.5]\nG91 G1{2}\nG1{3}\no{0} else\nG4 P[#{0}]\no{0} endif\n{4}",
          100 + label, uniform(0, 1), there, negated(), incremental_ ? "G91" : "G90");
    }
    return drilling();
  }

  // A row of holes, and back to where it began.
  std::string drilling() {
    static constexpr std::string_view kCodes[] = {"G81", "G82 P0.1", "G83 Q1.3", "G73 Q0.9", "G85", "G89 P.2"};
    const double step = uniform(1, 4) / unit();
    const std::string_view code = kCodes[static_cast<std::size_t>(uniform(0, 5.999))];
    const std::string scaled = inches_ && code.find('Q') != std::string_view::npos
                                   ? std::string(code.substr(0, code.find('Q'))) + "Q.05"
                                   : std::string(code);
    return fmt::format("G17 G91 {} {} X{:.3f} Y{:.3f} Z{:.3f} R{:.3f} L2\nX{:.3f}\nG80 G1 X{:.3f} Y{:.3f} Z{:.3f}\n{}",
                       chance(0.5) ? "G98" : "G99", scaled, step, step / 2, -step, -step / 4, step, -3 * step, -step,
                       0.0, incremental_ ? "G91" : "G90");
  }

  // Some words of a move by increments, which negated() takes back.
  std::string increments(int count) {
    away_.clear();
    std::string words;
    for (const Axis axis : kAllAxes) {
      if (away_.size() >= static_cast<std::size_t>(count) || !chance(0.5)) continue;
      const double by = uniform(-3, 3) / (is_rotary(axis) ? 1 : unit());
      away_.emplace_back(axis, by);
      words += fmt::format(" {}{:.3f}", letter(axis), by);
    }
    if (away_.empty()) {
      away_.emplace_back(Axis::X, 2 / unit());
      words = fmt::format(" X{:.3f}", 2 / unit());
    }
    return words;
  }
  std::string negated() const {
    std::string words;
    for (const auto& [axis, by] : away_) words += fmt::format(" {}[0-{:.3f}]", letter(axis), by);
    return words;
  }

  bool chance(double p) { return std::bernoulli_distribution(p)(random_); }
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  std::string number(double value) { return fmt::format("{:.{}f}", value, static_cast<int>(uniform(0.5, 4.9))); }
  double unit() const { return inches_ ? 25.4 : 1; }

  // Programmed positions stay in a box, whatever the mode: increments are differences of two of them.
  std::string axis_word(Axis axis) {
    const double reach = is_rotary(axis) ? 6 : 40 / unit();
    const double target = uniform(-reach, reach);
    double& at = position_[axis];
    const std::string text = number(incremental_ ? target - at : target);
    at = incremental_ ? at + std::stod(text) : std::stod(text);
    return fmt::format(" {}{}", letter(axis), text);
  }

  std::string all_axes() {
    std::string words;
    for (const Axis axis : kAllAxes) words += axis_word(axis);
    return words;
  }

  std::string some_axes(double linear, double rotary) {
    std::string words;
    while (words.empty()) {
      for (const Axis axis : kAllAxes) {
        if (chance(is_rotary(axis) ? rotary : linear)) words += axis_word(axis);
      }
    }
    return words;
  }

  std::string feed() {
    if (inverse_time_) return fmt::format(" F{:.3f}", uniform(2, 400));
    if (feed_stated_ && chance(0.6)) return "";
    feed_stated_ = true;
    return fmt::format(" F{:.1f}", uniform(100, 3000) / unit());
  }

  std::string arc() {
    static constexpr std::string_view kPlanes[] = {"G17", "G18", "G19"};
    static constexpr std::string_view kCentres[] = {"I{:.4f} J{:.4f}", "I{:.4f} K{:.4f}", "J{:.4f} K{:.4f}"};
    const auto plane = static_cast<std::size_t>(uniform(0, 2.999));
    const double r = uniform(0.5, 8) / unit();
    const double angle = uniform(0, 6.28);
    const std::string centre = fmt::format(fmt::runtime(kCentres[plane]), r * std::cos(angle), r * std::sin(angle));
    // A full turn needs no end; under G91 neither.
    std::string words = fmt::format("{} {} {}", kPlanes[plane], chance(0.5) ? "G2" : "G3", centre);
    if (chance(0.4)) words += axis_word(static_cast<Axis>(static_cast<int>(uniform(3, 5.999))));
    if (chance(0.3)) words += " P2";
    return words + feed();
  }

  std::string block() {
    if (flows_ && chance(0.2)) return flow();
    const double kind = uniform(0, 1);
    if (kind < 0.03) return "G4 P0.1 G1" + some_axes(0.4, 0.2) + feed();
    if (kind < 0.45) return "G1" + some_axes(0.4, 0.2) + feed();
    if (kind < 0.55) return "G1" + some_axes(0.0, 0.4) + feed();
    if (kind < 0.63) return "G0" + some_axes(0.3, 0.1);
    if (kind < 0.75) return arc();
    if (kind < 0.82) return switch_distance();
    if (kind < 0.90) return switch_feed_mode();
    if (kind < 0.93) return set_offset();
    if (kind < 0.96) return chance(0.5) ? "G4 P0.1" : "(a note)";
    return chance(0.5) ? "G61.1" : "G64";
  }

  std::string switch_distance() {
    incremental_ = !incremental_;
    return incremental_ ? "G91" : "G90";
  }

  std::string switch_feed_mode() {
    inverse_time_ = !inverse_time_;
    feed_stated_ = false;
    return inverse_time_ ? "G93" : "G94";
  }

  // The axis reads what it read before, so that the box stays where it is.
  std::string set_offset() {
    const Axis axis = static_cast<Axis>(static_cast<int>(uniform(0, 5.999)));
    return fmt::format("{} {}{:.9f}", chance(0.5) ? "G92" : "G10 L20 P1", letter(axis), position_[axis]);
  }

  std::mt19937_64 random_;
  bool flows_;
  int label_ = 0;
  std::vector<std::pair<Axis, double>> away_;
  AxisWords position_;  // in the program's unit
  bool inches_ = false;
  bool incremental_ = false;
  bool inverse_time_ = false;
  bool feed_stated_ = false;
};

}  // namespace plumbline
