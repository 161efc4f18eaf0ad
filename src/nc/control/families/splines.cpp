// G5, G5.1 and NURBS (G5.2, G5.3): curves in the XY plane, followed by straight pieces.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "nc/control/execution.hpp"
#include "nc/language/codes.hpp"

namespace plumbline::nc {
namespace {

constexpr int kPiecesPerPoint = 15;    // of the control polygon, at least [LinuxCNC takes as many]
constexpr double kChordMm = 1e-4;      // that the middle of a piece may lie off the curve
constexpr int kMostPieces = 1 << 16U;  // of one curve
constexpr int kLeastOrder = 3;
constexpr int kMostOrder = 10;

using Point = std::array<double, 2>;

// A rational B-spline whose knots are whole numbers, the first and the last repeated so that it goes through its ends.
// A Bezier curve is one with as many points as its order.
class Curve {
 public:
  Curve(const std::vector<NurbsPoint>& points, int order) : points_(points), order_(order) {}

  double end() const { return static_cast<double>(points_.size()) - order_ + 1; }

  // de Boor's algorithm on (w x, w y, w)  [Piegl, Tiller: The NURBS Book, 4.1, 3.5]
  Point at(double u) const {
    const int count = static_cast<int>(points_.size());
    const int span = std::clamp(static_cast<int>(std::floor(u)), 0, count - order_) + order_ - 1;
    const int first = span - order_ + 1;
    std::array<NurbsPoint, kMostOrder> d;
    for (int j = 0; j < order_; ++j) {
      const NurbsPoint& p = points_[static_cast<std::size_t>(first) + static_cast<std::size_t>(j)];
      d[static_cast<std::size_t>(j)] = {p.x * p.weight, p.y * p.weight, p.weight};
    }
    for (int r = 1; r < order_; ++r) {
      for (int j = order_ - 1; j >= r; --j) {
        const int i = first + j;
        const double low = knot(i);
        const double t = (u - low) / (knot(i + order_ - r) - low);
        const NurbsPoint& before = d[static_cast<std::size_t>(j - 1)];
        NurbsPoint& here = d[static_cast<std::size_t>(j)];
        here = {(1 - t) * before.x + t * here.x, (1 - t) * before.y + t * here.y,
                (1 - t) * before.weight + t * here.weight};
      }
    }
    const NurbsPoint& p = d[static_cast<std::size_t>(order_ - 1)];
    return {p.x / p.weight, p.y / p.weight};
  }

 private:
  double knot(int i) const { return std::clamp(static_cast<double>(i - order_ + 1), 0.0, end()); }
  const std::vector<NurbsPoint>& points_;
  int order_;
};

std::vector<Point> points_on(const Curve& curve, int pieces) {
  std::vector<Point> points;
  for (int i = 0; i <= pieces; ++i) points.push_back(curve.at(curve.end() * i / pieces));
  return points;
}

// As many pieces as keep the middles of all of them on the curve.
std::vector<Point> straight_pieces(const Curve& curve, std::size_t control_points) {
  int pieces = kPiecesPerPoint * static_cast<int>(control_points);
  while (true) {
    const std::vector<Point> finer = points_on(curve, 2 * pieces);
    double off = 0;
    for (std::size_t i = 1; i < finer.size(); i += 2) {
      const Point middle{(finer[i - 1][0] + finer[i + 1][0]) / 2, (finer[i - 1][1] + finer[i + 1][1]) / 2};
      off = std::max(off, distance(middle, finer[i]));
    }
    if (off <= kChordMm || pieces >= kMostPieces) return points_on(curve, pieces);
    pieces *= 2;
  }
}

void follow(Execution& run, const std::vector<NurbsPoint>& control_points, int order) {
  Control& control = run.control;
  const std::vector<Point> points = straight_pieces(Curve(control_points, order), control_points.size());
  const double feed = feed_of_move(run, true);
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double piece = distance(points[i - 1], points[i]);
    if (piece == 0 && i + 1 < points.size()) continue;
    Motion motion;
    motion.kind = MotionKind::feed;
    motion.to = control.position;
    motion.to[Axis::X] = points[i][0];
    motion.to[Axis::Y] = points[i][1];
    motion.known_after = control.known;
    motion.feed = feed;
    motion.goes_on = i + 1 < points.size();
    add_motion(run, motion);
  }
  run.step.cycle = CycleForm::moves;
}

// Under G93 the control sets no feed for a spline: it goes on with that of the move before [LinuxCNC, measured].
void check_spline(const Execution& run) {
  need_offsets(run);
  if (run.control.modal.feed_mode == FeedMode::inverse_time) {
    run.refuse(run.motion_code(), codes::kFeedMissing,
               "under inverse time (G93) the control ignores F of a spline, and feeds as in the move before",
               "write G94 and its F before it");
  }
  if (run.control.modal.plane != Plane::xy) {
    run.refuse(run.motion_code(), codes::kOutOfRange, "splines lie in the XY plane", "write G17 before it");
  }
  for (const Axis axis : kAllAxes) {
    if (axis == Axis::X || axis == Axis::Y || !run.axes.contains(axis)) continue;
    run.refuse(*run.words.find(axis), codes::kAxesUnused, fmt::format("{} stands still in a spline", letter(axis)),
               "move it in a block of its own");
  }
  if (run.control.known.contains(AxisSet{Axis::X, Axis::Y})) return;
  run.refuse(run.motion_code(), codes::kPositionUnknown, "the spline starts where X or Y is not known",
             "move there with a G0 that names both");
}

Point offset(const Execution& run, char first, char second) {
  const auto length = [&](char letter) {
    const Word* const word = run.words.find(letter);
    return word == nullptr ? 0 : run.length(*word);
  };
  return {length(first), length(second)};
}

}  // namespace

// G5: control points at I, J from the start and P, Q from the end. G5.1: one at I, J from the start.
void move_spline(Execution& run) {
  if (run.axes.empty()) {
    run.refuse(run.motion_code(), codes::kAxesMissing, "the spline names no axis", "add X or Y of its end");
  }
  check_spline(run);
  Control& control = run.control;
  const bool cubic = run.motion->action == Action::cubic_spline;
  const Point start{control.position[Axis::X], control.position[Axis::Y]};
  const AxisWords words = end_of_move(run);
  const Point end{words[Axis::X], words[Axis::Y]};
  const bool has_i = run.words.has('I');
  const bool has_j = run.words.has('J');
  Point leaves = offset(run, 'I', 'J');
  std::vector<NurbsPoint> points{{start[0], start[1]}};
  if (cubic) {
    run.need('P', "G5");
    run.need('Q', "G5");
    if (!has_i && !has_j && control.spline_end) {
      leaves = {-(*control.spline_end)[0], -(*control.spline_end)[1]};  // goes on in the direction of the one before
    } else {
      run.need('I', "the first G5 of a row");
      run.need('J', "the first G5 of a row");
    }
    const Point arrives = offset(run, 'P', 'Q');
    points.push_back({start[0] + leaves[0], start[1] + leaves[1]});
    points.push_back({end[0] + arrives[0], end[1] + arrives[1]});
    control.spline_end = arrives;
  } else {
    run.need('I', "G5.1");
    run.need('J', "G5.1");
    points.push_back({start[0] + leaves[0], start[1] + leaves[1]});
    control.spline_end.reset();
  }
  points.push_back({end[0], end[1]});
  follow(run, points, static_cast<int>(points.size()));
}

void add_nurbs_point(Execution& run) {
  check_spline(run);
  Control& control = run.control;
  if (control.modal.incremental) {
    run.refuse(run.motion_code(), codes::kOutOfRange, "control points of G5.2 are absolute", "write G90 before it");
  }
  if (control.motion_row != run.motion) control.nurbs.clear();  // another motion came between
  const bool begins = control.nurbs.empty();
  const bool of_start = begins && run.axes.empty();  // its P is the weight of where the curve starts
  const Word* const weight = of_start ? run.words.find('P') : &run.need('P', "G5.2");
  if (weight != nullptr && weight->value <= 0) {
    run.refuse(*weight, codes::kOutOfRange, "the weight of a control point is not positive", "write P greater than 0");
  }
  if (!of_start && !run.axes.contains(AxisSet{Axis::X, Axis::Y})) {
    run.refuse(run.motion_code(), codes::kAxesMissing, "a control point needs X and Y",
               "add them; the first point alone may do without both");
  }
  if (begins) {
    const double of_first = of_start && weight != nullptr ? weight->value : 1;
    control.nurbs.push_back({control.position[Axis::X], control.position[Axis::Y], of_first});
    control.nurbs_order = kLeastOrder;
  }
  // L counts from 4 on, and a lower one does not take it back [LinuxCNC, measured].
  const Word* const order = run.words.find('L');
  const int asked = order != nullptr ? run.whole(*order, 1, kMostOrder) : kLeastOrder;
  if (asked > kLeastOrder) control.nurbs_order = asked;
  run.step.nurbs = NurbsBlock::point;
  if (of_start) return;
  const AxisWords words = end_of_move(run);
  control.nurbs.push_back({words[Axis::X], words[Axis::Y], weight->value});
}

void move_nurbs(Execution& run) {
  check_spline(run);
  Control& control = run.control;
  if (control.motion_row == nullptr || control.motion_row->action != Action::nurbs_point) {
    run.refuse(run.motion_code(), codes::kOutOfRange, "this ends a curve that was not begun",
               "write its control points with G5.2 before it, and no other motion between them");
  }
  if (static_cast<int>(control.nurbs.size()) < control.nurbs_order) {
    run.refuse(
        run.motion_code(), codes::kOutOfRange,
        fmt::format("a curve of order {} needs as many control points, with where it starts", control.nurbs_order),
        "add points with G5.2, or a lower order with L");
  }
  const std::vector<NurbsPoint> points = std::exchange(control.nurbs, {});
  follow(run, points, control.nurbs_order);
  run.step.nurbs = NurbsBlock::end;
}

}  // namespace plumbline::nc
