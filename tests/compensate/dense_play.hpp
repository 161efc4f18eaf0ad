// A compensated program played on the model at many points of every piece, without the code that works out the summary:
// how far the deformed tip is from the path that the original asks for.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "compensate/play.hpp"
#include "compensate/target.hpp"
#include "machine/axis_words.hpp"
#include "path/curve.hpp"
#include "physics/error.hpp"

namespace plumbline {

struct DensePlay {
  double tip_um = 0;
  double turned_deg = 0;
  std::size_t line = 0;  // of the original, where the tip is furthest
  std::size_t plays = 0;
};

namespace dense {

// Of the moves that cut, and the rapids between them.
struct Timed {
  Move move;
  path::Curve curve;
  double begin = 0, end = 0;  // s of cutting
  std::size_t rapids = 0;     // before it
};

inline std::vector<Timed> timed(const std::vector<Move>& moves, const nc::Dialect& dialect) {
  std::vector<Timed> all;
  double now = 0;
  std::size_t rapids = 0;
  for (const Move& move : moves) {
    const path::Curve curve(move.motion);
    const bool is_rapid = move.motion.kind == nc::MotionKind::rapid;
    const double seconds = is_rapid ? 0 : path::duration(move.motion, curve, dialect).value_or(0);
    all.push_back({move, curve, now, now + seconds, rapids});
    now += seconds;
    if (is_rapid) ++rapids;
  }
  return all;
}

inline AxisWords between(const AxisWords& from, const AxisWords& to, double f) {
  AxisWords words;
  for (const Axis axis : kAllAxes) words[axis] = from[axis] + f * (to[axis] - from[axis]);
  return words;
}

// The nearest point of a curve: coarse, then by thirds, about each place that may be it: a circle comes by again.
template <class Off>
double nearest(const Off& off) {
  constexpr int kSteps = 24;
  std::array<double, kSteps + 1> coarse{};
  for (int i = 0; i <= kSteps; ++i) coarse[static_cast<std::size_t>(i)] = off(1.0 * i / kSteps);
  double least = *std::min_element(coarse.begin(), coarse.end());
  const double near = 1.01 * least;
  for (int i = 0; i <= kSteps; ++i) {
    if (coarse[static_cast<std::size_t>(i)] > near) continue;
    double low = std::max(0, i - 1) / double{kSteps};
    double high = std::min(kSteps, i + 1) / double{kSteps};
    for (int k = 0; k < 30; ++k) {
      const double a = low + (high - low) / 3;
      const double b = high - (high - low) / 3;
      const bool down = off(a) < off(b);
      (down ? high : low) = down ? b : a;
    }
    least = std::min(least, off((low + high) / 2));
  }
  return least;
}

}  // namespace dense

/// `per_piece` points of every piece that cuts. The original's moves that may be under way then: those near it in time,
/// and the ones beside these.
inline DensePlay dense_play(const std::string& original, const std::string& output, const Job& job, int per_piece = 200,
                            const compensate::ToolInSpindle& tool = {}) {
  const nc::Dialect& dialect = nc::dialect(job.dialect);
  const std::vector<dense::Timed> before = dense::timed(moves_of(original, job.program, job.dialect), dialect);
  const std::vector<dense::Timed> after = dense::timed(moves_of(output, job.program, job.dialect), dialect);
  physics::ForceModel forces(job.model);
  forces.machine.geometry = machine::with_tool(job.model.geometry, tool.length);
  physics::Environment environment = forces.environment();
  environment.friction = job.settings.friction;
  environment.dynamic = false;
  environment.tool_mass = tool.mass - job.model.reference_tool_mass;
  environment.tool_centre_P = job.model.geometry.tool_tip_P - Vector3<double>(0, 0, tool.along);
  const double radius = machine::platform_radius(forces.machine.geometry);
  const auto pose_of = [&](const AxisWords& words) { return machine::pose_of(job.model.rotation, words); };
  DensePlay played;
  for (const dense::Timed& piece : after) {
    if (piece.move.motion.kind == nc::MotionKind::rapid) continue;
    if (tip_distance(piece.move.from_W, piece.move.to_W) < 1e-9 && piece.curve.linear_mm() < 1e-9 &&
        std::abs(piece.curve.delta()[Axis::A]) + std::abs(piece.curve.delta()[Axis::B]) +
                std::abs(piece.curve.delta()[Axis::C]) <
            1e-9)
      continue;
    const double slack = 2e-3 * (piece.end - piece.begin) + 1e-9;
    std::vector<const dense::Timed*> candidates;
    for (std::size_t i = 0; i < before.size(); ++i) {
      const dense::Timed& move = before[i];
      const double late = 1.5e-3 * piece.begin + slack;
      const bool overlaps = move.begin <= piece.end + late && move.end >= piece.begin - late;
      if (overlaps && std::max(move.rapids, piece.rapids) - std::min(move.rapids, piece.rapids) <= 1)
        candidates.push_back(&move);
    }
    const bool is_arc = piece.move.motion.kind == nc::MotionKind::arc;
    for (int k = 0; k <= per_piece; ++k) {
      const double f = std::clamp(1.0 * k / per_piece, 1e-6, 1 - 1e-6);
      const path::CurvePoint point = piece.curve.point(f);
      compensate::Target told;
      told.pose = is_arc ? piece.move.frame.to_pose(point.at) : dense::between(piece.move.from_W, piece.move.to_W, f);
      told.slope =
          is_arc ? nc::turned_about_z(point.slope, piece.move.frame.rotation_deg) : piece.move.to_W - piece.move.from_W;
      if (piece.end > piece.begin) told.seconds = piece.end - piece.begin;
      if (piece.move.motion.feed_mode == nc::FeedMode::per_revolution) told.seconds.reset();
      const auto motion = compensate::motion_at(job.model.rotation, radius, told, environment);
      const auto error = physics::tip_error(forces, environment, motion);
      REQUIRE(error.converged());
      ++played.plays;
      double off = std::numeric_limits<double>::max();
      double turned = off;
      std::size_t line = 0;
      for (const dense::Timed* move : candidates) {
        const auto words = [&](double g) { return move->move.frame.to_pose(move->curve.at(g)); };
        const double d =
            dense::nearest([&](double g) {
              const AxisWords at = words(g);
              return (Vector3<double>(at[Axis::X], at[Axis::Y], at[Axis::Z]) * kMm - error.pose.p_WT).norm();
            }) /
            kUm;
        if (d < off) line = move->move.motion.line;
        off = std::min(off, d);
        if (k % 4 != 0) continue;
        turned = std::min(
            turned, dense::nearest([&](double g) {
                      return machine::logarithm<double>(error.pose.R_WP * pose_of(words(g)).R_WP.transpose()).norm();
                    }) / kDeg);
      }
      if (k % 4 == 0) played.turned_deg = std::max(played.turned_deg, turned);
      if (off <= played.tip_um) continue;
      played.tip_um = off;
      played.line = line;
    }
  }
  return played;
}

}  // namespace plumbline
