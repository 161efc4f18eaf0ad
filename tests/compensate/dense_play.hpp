// A compensated program played on the model at many points of every piece, without the code that works out the summary:
// how far the deformed tip is from the path that the original asks for. Rapids are no such path: the control goes there
// as it likes.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "compensate/play.hpp"
#include "compensate/target.hpp"
#include "machine/axis_words.hpp"
#include "path/curve.hpp"
#include "physics/error.hpp"

namespace plumbline {

/// What one piece of the output leaves.
struct PlayedPiece {
  double tip_um = 0, turned_deg = 0;
  double seconds = 0;
};

struct DensePlay {
  double tip_um = 0;
  double turned_deg = 0;
  std::size_t line = 0;  // of the original, where the tip is furthest
  std::size_t plays = 0;
  std::vector<PlayedPiece> pieces;  // that cut
};

namespace dense {

inline bool goes(const path::Curve& curve) {
  const AxisWords& way = curve.delta();
  return curve.linear_mm() > 1e-9 || std::abs(way[Axis::A]) + std::abs(way[Axis::B]) + std::abs(way[Axis::C]) > 1e-9;
}

// A move that cuts.
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
    if (move.motion.kind == nc::MotionKind::rapid) {
      ++rapids;
      continue;
    }
    const double seconds = path::duration(move.motion, curve, dialect).value_or(0);
    if (goes(curve)) all.push_back({move, curve, now, now + seconds, rapids});
    now += seconds;  // F may give a move time that goes nowhere, and what it became may go some micrometres
  }
  return all;
}

// The curve of a move as a table, from which the nearest of its points is sought: the best of the table's hollows, each
// followed down by Newton's rule. A circle comes by again, so there may be several.
class Original {
 public:
  Original(const Timed& move, const machine::RotationOrder& order) : move_(&move), order_(order) {
    constexpr int kSteps = 48;
    for (int i = 0; i <= kSteps; ++i) {
      const AxisWords words = words_at(1.0 * i / kSteps);
      tips_.push_back(tip(words));
      turns_.push_back(machine::pose_of(order_, words).R_WP);
    }
  }

  const Timed& move() const { return *move_; }

  double distance_mm(const Vector3<double>& tip_mm) const {
    return nearest(
        tips_, [&](const Vector3<double>& p) { return (tip_mm - p).norm(); },
        [&](double at) -> Vector3<double> { return tip_mm - tip(words_at(at)); });
  }
  double turn_deg(const Matrix3<double>& R) const {
    const auto from = [&](const Matrix3<double>& R_WP) -> Vector3<double> {
      return machine::logarithm<double>(R * R_WP.transpose()) / kDeg;
    };
    return nearest(
        turns_, [&](const Matrix3<double>& R_WP) { return (R - R_WP).norm(); },
        [&](double at) { return from(machine::pose_of(order_, words_at(at)).R_WP); });
  }

 private:
  static Vector3<double> tip(const AxisWords& words) { return {words[Axis::X], words[Axis::Y], words[Axis::Z]}; }
  AxisWords words_at(double at) const { return move_->move.frame.to_pose(move_->curve.at(at)); }

  template <class Table, class Coarse, class Off>
  static double nearest(const Table& table, const Coarse& coarse, const Off& off_at) {
    std::vector<double> values;
    for (const auto& entry : table) values.push_back(coarse(entry));
    double least = std::numeric_limits<double>::max();
    const std::size_t last = values.size() - 1;
    for (std::size_t i = 0; i <= last; ++i) {
      if (i > 0 && values[i - 1] <= values[i]) continue;
      if (i < last && values[i + 1] < values[i]) continue;
      least = std::min(least, descend(off_at, static_cast<double>(i) / static_cast<double>(last)));
    }
    return least;
  }

  template <class Off>
  static double descend(const Off& off_at, double at) {
    constexpr double kProbe = 1e-5;
    double least = std::numeric_limits<double>::max();
    for (int k = 0; k < 8; ++k) {
      const Vector3<double> off = off_at(at);
      least = std::min(least, off.norm());
      const double probe = at > 0.5 ? -kProbe : kProbe;
      const Vector3<double> slope = (off_at(at + probe) - off) / probe;
      if (slope.norm() < 1e-9) break;
      const double next = std::clamp(at - off.dot(slope) / slope.squaredNorm(), 0.0, 1.0);
      if (std::abs(next - at) < 1e-10) break;
      at = next;
    }
    return least;
  }

  const Timed* move_;
  machine::RotationOrder order_;
  std::vector<Vector3<double>> tips_;
  std::vector<Matrix3<double>> turns_;
};

// The machine that plays.
class Machine {
 public:
  Machine(const Job& job, const compensate::ToolInSpindle& tool) : model_(job.model), forces_(job.model) {
    forces_.machine.geometry = machine::with_tool(model_.geometry, tool.length);
    environment_ = forces_.environment();
    environment_.friction = job.settings.friction;
    environment_.dynamic = false;
    environment_.tool_mass = tool.mass - model_.reference_tool_mass;
    environment_.tool_centre_P = model_.geometry.tool_tip_P - Vector3<double>(0, 0, tool.along);
    radius_ = machine::platform_radius(forces_.machine.geometry);
  }

  Pose<double> stands(const Timed& piece, double f) const {
    const auto error = physics::tip_error(forces_, environment_, motion(piece, f));
    if (!error.converged()) FAIL("the played machine gives way");
    return error.pose;
  }
  machine::PerStrut<double> speeds(const Timed& piece, double f) const {
    const auto motion_there = motion(piece, f);
    return physics::strut_rates(machine::strut_geometry(forces_.machine.geometry, motion_there.pose), motion_there,
                                environment_)
        .speed;
  }
  double sign_speed() const { return environment_.sign_speed; }

 private:
  physics::Motion<double> motion(const Timed& piece, double f) const {
    const path::CurvePoint point = piece.curve.point(f);
    compensate::Target told;
    if (piece.move.motion.kind == nc::MotionKind::arc) {
      told.pose = piece.move.frame.to_pose(point.at);
      told.slope = nc::turned_about_z(point.slope, piece.move.frame.rotation_deg);
    } else {
      told.slope = piece.move.to_W - piece.move.from_W;
      for (const Axis axis : kAllAxes) told.pose[axis] = piece.move.from_W[axis] + f * told.slope[axis];
    }
    if (piece.end > piece.begin) told.seconds = piece.end - piece.begin;
    if (piece.move.motion.feed_mode == nc::FeedMode::per_revolution) told.seconds.reset();
    return compensate::motion_at(model_.rotation, radius_, told, environment_);
  }

  const machine::MachineModel& model_;
  physics::ForceModel forces_;
  physics::Environment environment_;
  double radius_ = 0;
};

// Where a piece is played: evenly, and about each place where a strut turns, as far as its friction takes to do so.
inline std::vector<double> places(const Machine& machine, const Timed& piece, int per_piece) {
  std::vector<double> all;
  for (int k = 0; k <= per_piece; ++k) all.push_back(std::clamp(1.0 * k / per_piece, 1e-9, 1 - 1e-9));
  constexpr int kIntervals = 16;
  for (int k = 0; k < kIntervals; ++k) {
    const double begin = 1.0 * k / kIntervals;
    const double end = 1.0 * (k + 1) / kIntervals;
    const machine::PerStrut<double> first = machine.speeds(piece, begin);
    const machine::PerStrut<double> last = machine.speeds(piece, end);
    for (int j = 0; j < machine::kStruts; ++j) {
      if (first[j] * last[j] > 0 || first[j] == last[j]) continue;
      double low = begin;
      double high = end;
      for (int i = 0; i < 40; ++i) {
        const double middle = (low + high) / 2;
        (machine.speeds(piece, middle)[j] * first[j] > 0 ? low : high) = middle;
      }
      const double width = machine.sign_speed() / std::abs((last[j] - first[j]) / (end - begin));
      for (const double away : {0.0, 0.4, 1.0, 1.7, 2.6, 3.6, 5.0}) {
        all.push_back(std::clamp(low - away * width, 1e-9, 1 - 1e-9));
        all.push_back(std::clamp(low + away * width, 1e-9, 1 - 1e-9));
      }
    }
  }
  return all;
}

}  // namespace dense

/// `per_piece` points of every piece that cuts, and the turns of struts.
/// The original's moves that may be under way then: those near it in time, with no rapid between.
inline DensePlay dense_play(const std::string& original, const std::string& output, const Job& job, int per_piece = 24,
                            const compensate::ToolInSpindle& tool = {}) {
  const nc::Dialect& dialect = nc::dialect(job.dialect);
  const std::vector<dense::Timed> before = dense::timed(moves_of(original, job.program, job.dialect), dialect);
  const std::vector<dense::Timed> after = dense::timed(moves_of(output, job.program, job.dialect), dialect);
  std::vector<dense::Original> originals;
  for (const dense::Timed& move : before) originals.emplace_back(move, job.model.rotation);
  const dense::Machine machine(job, tool);
  DensePlay played;
  for (const dense::Timed& piece : after) {
    const double late = 3.5e-3 * piece.end + 1e-9;
    std::vector<const dense::Original*> candidates;
    for (const dense::Original& move : originals) {
      const bool overlaps = move.move().begin <= piece.end + late && move.move().end >= piece.begin - late;
      if (overlaps && move.move().rapids == piece.rapids) candidates.push_back(&move);
    }
    played.pieces.push_back({0, 0, piece.end - piece.begin});
    const auto look = [&](double f) {
      const Pose<double> stands = machine.stands(piece, f);
      ++played.plays;
      double off = std::numeric_limits<double>::max();
      double turned = off;
      std::size_t line = 0;
      for (const dense::Original* move : candidates) {
        const double d = move->distance_mm(stands.p_WT / kMm) * kMm / kUm;
        if (d < off) line = move->move().move.motion.line;
        off = std::min(off, d);
        turned = std::min(turned, move->turn_deg(stands.R_WP));
      }
      played.turned_deg = std::max(played.turned_deg, turned);
      played.pieces.back().turned_deg = std::max(played.pieces.back().turned_deg, turned);
      played.pieces.back().tip_um = std::max(played.pieces.back().tip_um, off);
      if (off > played.tip_um) {
        played.tip_um = off;
        played.line = line;
      }
    };
    for (const double f : dense::places(machine, piece, per_piece)) look(f);
  }
  return played;
}

}  // namespace plumbline
