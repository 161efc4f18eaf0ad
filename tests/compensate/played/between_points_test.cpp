// What the summary says is left at the tip, against a dense play of the output.
#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "compensate/dense_play.hpp"
#include "compensate/random_program.hpp"

using namespace plumbline;

namespace {

// The figure of the summary is within a tenth of what 20 points of every piece find.
void check_honest(const std::string& text, const Job& job) {
  INFO(text);
  const Result result = run(text, job);
  const DensePlay played = dense_play(text, result.text, job, 20);
  const double said_um = result.summary.residual_mm.value * 1e3;
  INFO(played.tip_um << " um at line " << played.line << ", said " << said_um);
  CHECK(said_um >= 0.9 * played.tip_um);
  CHECK(said_um <= 1.1 * played.tip_um);
}

}  // namespace

TEST_CASE("what is left between the points is found on arcs, lines, turns and splines, at coarse steps too") {
  const std::string head = "G21 G90 G94 G17\nG0 X0 Y0 Z20 A0 B0 C0\nG1 Z0 F1000\n";
  for (const char* const move : {"G2 X20 Y0 I10 J0\n", "G3 X12 Y0 Z4 I6 J0 A5\n", "G1 X30 Y17 Z-5\nX34 Y2\n",
                                 "G1 A9 B-4\nC6\n", "G5.1 X16 Y0 I8 J12\n"}) {
    for (const double step : {2.0, 10.0}) {
      for (const bool friction : {true, false}) {
        Job job;
        job.settings.step.length_mm = step;
        job.settings.step.angle_deg = step;
        job.settings.friction = friction;
        check_honest(head + move + "M2\n", job);
      }
    }
  }
}

namespace {

enum class Kind { arc, rotary, line, spline };
constexpr std::array kAllKinds{Kind::arc, Kind::rotary, Kind::line, Kind::spline};

// One or two moves: arcs and helices, turns, lines that turn as well, splines; the first of the kind that is asked for.
class DrawnMoves {
 public:
  DrawnMoves(unsigned seed, Kind first) : random_(seed), first_(first) {}

  std::string text() {
    std::string out =
        fmt::format("G21 G90 G94 G17\nG0 X{:.1f} Y{:.1f} Z{:.1f} A{:.1f} B{:.1f} C{:.1f}\nG91.1 G1 F{:.0f}\n",
                    x_ = uniform(-90, 90), y_ = uniform(-90, 90), uniform(-40, 40), uniform(-8, 8), uniform(-8, 8),
                    uniform(-10, 10), std::pow(10, uniform(2, 3.6)));
    out += move(first_) + "\n";
    if (uniform(0, 1) < 0.5) out += move(static_cast<Kind>(std::min(3.0, uniform(0, 4)))) + "\n";
    return out + "M2\n";
  }

  Job job() {
    Job job;
    job.settings.friction = uniform(0, 1) < 0.7;
    job.settings.step.angle_deg = std::pow(10, uniform(-0.3, 1.3));
    job.settings.step.length_mm = std::pow(10, uniform(0.3, 1.5));
    return job;
  }

 private:
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  std::string rotary() {
    return fmt::format("A{:.2f} B{:.2f} C{:.2f}", uniform(-9, 9), uniform(-9, 9), uniform(-12, 12));
  }

  std::string move(Kind kind) {
    const double r = std::pow(10, uniform(0, 1.6));
    const double at = uniform(0, 6.28);
    if (kind == Kind::arc) {
      std::string words =
          fmt::format("{} I{:.4f} J{:.4f}", uniform(0, 1) < 0.5 ? "G2" : "G3", r * std::cos(at), r * std::sin(at));
      if (uniform(0, 1) < 0.4) words += fmt::format(" Z{:.2f}", uniform(-40, 40));
      if (uniform(0, 1) < 0.4) words += fmt::format(" A{:.2f}", uniform(-9, 9));
      return words;
    }
    if (kind == Kind::rotary) return "G1 " + rotary();
    const double x = x_ + r * std::cos(at);
    const double y = y_ + r * std::sin(at);
    const std::string end = fmt::format("X{:.3f} Y{:.3f}", x, y);
    std::string words;
    if (kind == Kind::line) {
      words = "G1 " + end + " " + rotary();
    } else {
      words = fmt::format("G5 {} I{:.3f} J{:.3f} P{:.3f} Q{:.3f}", end, uniform(-1, 1) * r, uniform(-1, 1) * r,
                          uniform(-1, 1) * r, uniform(-1, 1) * r);
    }
    x_ = x;
    y_ = y;
    return words;
  }

  std::mt19937_64 random_;
  Kind first_;
  double x_ = 0, y_ = 0;
};

// Of what is written: no figure means more.
constexpr double kHalfIncrementUm = 0.05;
constexpr double kHalfIncrementDeg = 5e-6;

struct Honesty {
  int moves = 0, off_tip = 0, off_turn = 0;
  std::uint64_t plays = 0;  // that the summary took
  double least = 1;         // said over found
};

// What is said is within a tenth of what `per_piece` points of each piece find, places and turns.
Honesty honesty(Kind kind, unsigned first, unsigned last, int per_piece) {
  Honesty all;
  for (unsigned seed = first; seed <= last; ++seed) {
    DrawnMoves drawn(seed, kind);
    const std::string text = drawn.text();
    const Job job = drawn.job();
    const Result result = run(text, job);
    const DensePlay played = dense_play(text, result.text, job, per_piece);
    const double tip_um = result.summary.residual_mm.value * 1e3;
    const double turned_deg = result.summary.residual_deg.value;
    ++all.moves;
    all.plays += result.summary.replayed;
    const bool off_tip = std::abs(tip_um - played.tip_um) > 0.1 * played.tip_um + kHalfIncrementUm;
    const bool off_turn = std::abs(turned_deg - played.turned_deg) > 0.1 * played.turned_deg + kHalfIncrementDeg;
    if (off_tip) all.least = std::min(all.least, tip_um / played.tip_um);
    if (off_turn) all.least = std::min(all.least, turned_deg / played.turned_deg);
    if (off_tip) ++all.off_tip;
    if (off_turn) ++all.off_turn;
    if (off_tip || off_turn) {
      WARN("seed " << seed << (job.settings.friction ? " with friction, step " : ", step ")
                   << job.settings.step.angle_deg << " deg or " << job.settings.step.length_mm << " mm: found "
                   << played.tip_um << " um, said " << tip_um << "; found " << played.turned_deg << " deg, said "
                   << turned_deg << "\n"
                   << text);
    }
  }
  return all;
}

}  // namespace

TEST_CASE("what is left between the points of drawn arcs, turns and splines is said to a tenth, turns too") {
  for (const Kind kind : kAllKinds) {
    const Honesty found = honesty(kind, 1, 5, 16);
    CHECK(found.off_tip == 0);
    CHECK(found.off_turn == 0);
  }
}

TEST_CASE("a strut that turns where a spline of many blocks was played little is found") {
  CHECK(honesty(Kind::spline, 137, 137, 16).off_tip == 0);
}

TEST_CASE("what is left between the points of 480 drawn moves is said to a tenth, turns too, but for one of a hundred",
          "[.long]") {
  for (const Kind kind : kAllKinds) {
    const Honesty found = honesty(kind, 101, 220, 40);
    WARN(found.plays << " plays for " << found.moves << " programs");
    CHECK(found.off_tip <= found.moves / 100);
    CHECK(found.off_turn <= found.moves / 100);
    CHECK(found.least > 0.75);
  }
}

TEST_CASE("the dense play has converged: ten times as many points find no more", "[.long]") {
  for (const Kind kind : kAllKinds) {
    for (unsigned seed = 1; seed <= 10; ++seed) {
      DrawnMoves drawn(seed, kind);
      const std::string text = drawn.text();
      const Job job = drawn.job();
      INFO(text);
      const Result result = run(text, job);
      const DensePlay some = dense_play(text, result.text, job, 16);
      const DensePlay many = dense_play(text, result.text, job, 160);
      CHECK(some.tip_um >= 0.97 * many.tip_um);
      CHECK(some.turned_deg >= 0.97 * many.turned_deg);
    }
  }
}

TEST_CASE("what is left between the points of drawn programs is found", "[.long]") {
  int off = 0;
  double worst = 1;
  for (unsigned seed = 1; seed <= 60; ++seed) {
    Job job;
    job.settings.friction = seed % 3 != 0;
    job.settings.step.angle_deg = seed % 4 == 0 ? 5 : 0.5;
    job.settings.step.length_mm = seed % 5 == 0 ? 20 : 2;
    const std::string text = RandomProgram(seed).text(8);
    const Result result = run(text, job);
    const DensePlay played = dense_play(text, result.text, job, 20);
    const double said = result.summary.residual_mm.value * 1e3;
    worst = std::min(worst, said / played.tip_um);
    if (std::abs(said / played.tip_um - 1) <= 0.1) continue;
    ++off;
    WARN("seed " << seed << ": " << played.tip_um << " um at line " << played.line << ", said " << said << " at line "
                 << result.summary.residual_mm.line);
  }
  WARN(off << " of 60 off by more than a tenth; at worst " << worst << " of what is left was said");
  CHECK(worst >= 0.9);
}
