// Drawn programs and what compensating them writes: none of it is out of line with its original.
#include <cmath>
#include <random>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "compensate/random_program.hpp"
#include "jobs/compensate/compensate_file.hpp"
#include "jobs/diff/diff.hpp"
#include "report/program/diff_text.hpp"
#include "settings/options.hpp"
#include "support/scratch.hpp"

using namespace plumbline;

namespace {

// Moves from a tenth of a micrometre to some centimetres one after the other, as no sorted program has them.
class SmallMoves {
 public:
  explicit SmallMoves(unsigned seed) : random_(seed) {}

  std::string text(int blocks) {
    numbered_ = chance(0.3);
    std::string out = "G21 G90 G94 G54 G17 G40\n" + line("G0 X0 Y0 Z0.79");
    for (int i = 0; i < blocks; ++i) out += line(block());
    return out + "M2\n";
  }

 private:
  bool chance(double p) { return std::bernoulli_distribution(p)(random_); }
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  double size() { return std::pow(10, uniform(-4, 1.4)); }
  double step() { return chance(0.5) ? size() : -size(); }
  std::string line(const std::string& words) {
    return (numbered_ ? fmt::format("N{} ", ++number_) : "") + words + "\n";
  }
  std::string number(double value) { return fmt::format("{:.{}f}", value, static_cast<int>(uniform(3, 6))); }

  std::string word(Axis axis, double by) {
    double& at = position_[axis];
    if (std::abs(at + by) > (is_rotary(axis) ? 6 : 40)) by = -by;
    const std::string text = number(at + by);
    at = std::stod(text);
    return fmt::format(" {}{}", letter(axis), text);
  }

  std::string feed() {
    if (inverse_time_) return fmt::format(" F{:.2f}", uniform(1, 900));
    if (has_feed_ && chance(0.6)) return "";
    has_feed_ = true;
    return fmt::format(" F{:.1f}", std::pow(10, uniform(1, 3.7)));
  }

  std::string straight(const std::string& code, double rotary) {
    std::string words;
    const double scale = size();
    while (words.empty()) {
      for (const Axis axis : kAllAxes) {
        if (chance(is_rotary(axis) ? rotary : 0.5)) words += word(axis, scale * uniform(-1, 1));
      }
    }
    return code + words;
  }

  std::string block() {
    const double kind = uniform(0, 1);
    if (kind < 0.5) return straight("G1", 0.15) + feed();
    if (kind < 0.6) return straight("G0", 0.05);
    if (kind < 0.65) {
      inverse_time_ = !inverse_time_;
      has_feed_ = false;
      return inverse_time_ ? "G93" : "G94";
    }
    if (kind < 0.7) return "G4 P0.1";
    return arc() + feed();
  }

  std::string arc() {
    const double r = std::min(size(), 8.0);
    const std::string code = chance(0.5) ? "G2" : "G3";
    if (chance(0.5)) return fmt::format("{} I{:.5f} J{:.5f}", code, r, r * uniform(-1, 1));
    // A chord of any share of the diameter.
    const double angle = uniform(0, 6.28);
    const double chord = 2 * r * uniform(0.02, 0.98);
    const std::string x = word(Axis::X, chord * std::cos(angle));
    const std::string y = word(Axis::Y, chord * std::sin(angle));
    return fmt::format("{}{}{} R{:.5f}", code, x, y, (chance(0.8) ? 1.05 : -1.05) * std::max(r, 0.01));
  }

  std::mt19937_64 random_;
  AxisWords position_;
  bool numbered_ = false;
  bool inverse_time_ = false;
  bool has_feed_ = false;
  int number_ = 0;
};

struct Drawn {
  std::string program;
  settings::Options options;
};

Drawn drawn(unsigned seed) {
  Drawn it;
  std::mt19937_64 random(seed);
  const auto chance = [&](double p) { return std::bernoulli_distribution(p)(random); };
  it.program = seed % 3 == 0 ? RandomProgram(seed, seed % 2 == 0).text(12) : SmallMoves(seed).text(14);
  it.options.paths.model = testing::source_file("models/pm600-like.toml");
  it.options.program.work_offsets[0] = nc::WorkOffset{{{0, 0, -1008, 0, 0, 0}}, 0};
  for (auto& axis : it.options.program.start) axis = 0;
  it.options.guard = chance(0.3);
  it.options.compensation.friction = !chance(0.3);
  if (chance(0.5)) it.options.compensation.step.angle_deg = chance(0.5) ? 5 : 1;
  if (chance(0.3)) it.options.compensation.step.length_mm = 20;
  return it;
}

// What is wrong; empty: nothing.
std::string alarm(unsigned seed, int& compensated) {
  const testing::Scratch scratch;
  const Drawn it = drawn(seed);
  const std::string a = scratch.file("a.ngc", it.program);
  const std::string b = scratch.path("b.ngc");
  try {
    jobs::compensate_file(a, b, it.options);
  } catch (const Refusal& refusal) {
    return refusal.diagnostic().code == "compensate-read-back" ? refusal.what() : "";
  }
  ++compensated;
  settings::Options options;
  options.program.work_offsets = it.options.program.work_offsets;
  options.program.start = it.options.program.start;
  const jobs::DiffSummary s = jobs::diff_files(a, b, options);
  std::string wrong;
  for (const Axis axis : kAllAxes) {
    if (s.shift[index(axis)].largest > 0.3)
      wrong += fmt::format("{} is off by {} ", letter(axis), s.shift[index(axis)].largest);
  }
  if (s.time_change.value > 0.0016)
    wrong += fmt::format("time {} at line {} ", s.time_change.value, s.time_change.line);
  if (s.out_of_line_a == 0 && s.out_of_line_b == 0 && s.matched == s.moves_a && wrong.empty()) return {};
  return it.program + wrong + report::diff_text(s);
}

void check_seeds(unsigned first, unsigned last) {
  int alarms = 0;
  int compensated = 0;
  for (unsigned seed = first; seed <= last; ++seed) {
    const std::string found = alarm(seed, compensated);
    if (found.empty()) continue;
    ++alarms;
    WARN("seed " << seed << "\n" << found);
  }
  INFO(alarms << " of " << compensated);
  CHECK(alarms == 0);
  CHECK(compensated > static_cast<int>(last - first) / 2);
}

}  // namespace

TEST_CASE("drawn programs of moves of any size are in line with what is written for them") { check_seeds(1, 100); }

TEST_CASE("many drawn programs are in line with what is written for them", "[.long]") { check_seeds(1, 2000); }
