#include "imported/circles.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/QR>
#include <fmt/format.h>

#include "base/angle.hpp"
#include "base/median.hpp"
#include "base/units.hpp"

namespace plumbline::imported {
namespace {

std::size_t column_of(const Source& source, Quantity quantity) {
  return static_cast<std::size_t>(source.find(quantity) - source.columns.data());
}

double step(const Ways& ways, std::size_t from, std::size_t to) {
  double sum = 0;
  for (std::size_t i = from + 1; i <= to; ++i) sum += std::remainder(ways.angle[i] - ways.angle[i - 1], kTurn);
  return sum;
}

// A row whose angle leaves its neighbours and comes back: the circle would end there, and most of it be thrown away.
void refuse_jumps(const Ways& ways, const ForeignTable& table) {
  constexpr double kBetween = 4;  // usual steps
  constexpr double kAway = 10;    // likewise
  const std::size_t count = ways.angle.size();
  std::vector<double> sizes;
  for (std::size_t i = 1; i < count; ++i) {
    if (const double size = std::abs(step(ways, i - 1, i)); size > 1e-9) sizes.push_back(size);
  }
  if (sizes.empty()) return;
  const double usual = median(std::move(sizes));
  for (std::size_t i = 1; i + 1 < count; ++i) {
    const double between = std::abs(std::remainder(ways.angle[i + 1] - ways.angle[i - 1], kTurn));
    const double away = std::min(std::abs(step(ways, i - 1, i)), std::abs(step(ways, i, i + 1)));
    if (between > kBetween * usual || away < kAway * usual) continue;
    refuse("import-number",
           fmt::format("the angle in line {} of {} is {:.6g} deg, and those beside it are {:.6g} and {:.6g} deg",
                       table.lines[i], table.file, ways.angle[i] / kDeg, ways.angle[i - 1] / kDeg,
                       ways.angle[i + 1] / kDeg),
           "the tip cannot go there and back between two samples: mend the number, or leave the line out",
           table.place(i));
  }
}

}  // namespace

Ways ways_of(const MapRun& map_run, const Source& source, const ForeignTable& table, const ImportOptions& options) {
  const measure::Run& run = map_run.run;
  Ways ways;
  ways.on_circle.assign(table.rows(), true);
  bool jumps_count = false;
  if (source.find(Quantity::angle) != nullptr) {
    ways.angle = table.values[column_of(source, Quantity::angle)];
    ways.from = "column";
    jumps_count = true;
  } else if (source.find(Quantity::x) != nullptr && source.find(Quantity::y) != nullptr) {
    const std::vector<double>& x = table.values[column_of(source, Quantity::x)];
    const std::vector<double>& y = table.values[column_of(source, Quantity::y)];
    for (std::size_t i = 0; i < table.rows(); ++i) {
      const double dx = x[i] - run.centre_W.x();
      const double dy = y[i] - run.centre_W.y();
      ways.angle.push_back(std::atan2(dy, dx));
      ways.on_circle[i] = std::abs(std::hypot(dx, dy) - run.radius) < options.off_circle * run.radius;
    }
    ways.from = "places";
  } else if (source.find(Quantity::time) != nullptr) {
    const std::vector<double>& time = table.values[column_of(source, Quantity::time)];
    const double speed = run.turn() * run.feed / run.radius;
    // without a word of where the record begins, the turn that is measured begins at angle 0
    const double sweep = std::abs(speed) * (time.back() - time.front());
    const double before = map_run.run_in.value_or(std::max(0.0, (sweep - kTurn) / 2));
    const double start = map_run.start_angle.value_or(sweep > options.most_turn * kTurn ? -run.turn() * before : 0);
    for (const double t : time) ways.angle.push_back(start + speed * (t - time.front()));
    ways.from = "time and feed";
  } else {
    refuse("import-angle", fmt::format("nothing tells where on the circle the samples of {} were taken", table.file),
           "name a column angle, the columns x and y of the tip, or time", run.place);
  }
  for (std::size_t i = 0; i < ways.angle.size(); ++i) {
    if (std::isfinite(ways.angle[i])) continue;
    refuse("import-number", fmt::format("row {} of {} does not say where it was taken", table.lines[i], table.file),
           "time, angle and places have to be there in each row", table.place(i));
  }
  if (jumps_count) refuse_jumps(ways, table);
  return ways;
}

std::vector<Circle> circles_in(const Ways& ways, const ImportOptions& options) {
  constexpr std::size_t kAside = 2;  // rows on either side that tell how fast the tip goes
  const std::size_t count = ways.angle.size();
  std::vector<double> speed(count, 0);
  std::vector<double> sizes;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t from = i - std::min(i, kAside);
    const std::size_t to = std::min(count - 1, i + kAside);
    if (to > from) speed[i] = step(ways, from, to) / static_cast<double>(to - from);
    if (std::abs(speed[i]) > 1e-9) sizes.push_back(std::abs(speed[i]));
  }
  std::vector<Circle> circles;
  if (sizes.empty()) return circles;
  const double usual = median(std::move(sizes));
  for (std::size_t i = 0; i < count;) {
    const auto goes = [&](std::size_t k) {
      return ways.on_circle[k] && std::abs(speed[k]) > options.standing * usual && speed[k] * speed[i] > 0;
    };
    if (!goes(i)) {
      ++i;
      continue;
    }
    std::size_t last = i;
    while (last + 1 < count && goes(last + 1)) ++last;
    Circle circle{i, last, 0, speed[i] > 0 ? 1.0 : -1.0};
    // rows that stand still before the start and after the end
    const auto stands = [&](std::size_t k) { return circle.turn * step(ways, k, k + 1) <= 0; };
    while (circle.first < circle.last && stands(circle.first)) ++circle.first;
    while (circle.last > circle.first && stands(circle.last - 1)) --circle.last;
    circle.sweep = std::abs(step(ways, circle.first, circle.last));
    if (circle.sweep >= options.least_sweep) circles.push_back(circle);
    i = last + 1;
  }
  return circles;
}

Turn turn_of(const Ways& ways, const Circle& circle, const MapRun& run, const ImportOptions& options) {
  Turn turn{circle.first, circle.last, 0, 0};
  if (circle.sweep <= options.most_turn * kTurn) return turn;
  const double before = std::min(run.run_in.value_or((circle.sweep - kTurn) / 2), circle.sweep - kTurn);
  double swept = 0;
  std::size_t row = circle.first;
  const auto on = [&] { swept += circle.turn * std::remainder(ways.angle[row + 1] - ways.angle[row], kTurn); };
  while (row < circle.last && swept < before - 1e-9) {
    on();
    ++row;
  }
  turn.first = row;
  turn.before = swept;
  while (row < circle.last) {
    const double there = swept;
    on();
    if (swept >= turn.before + kTurn - 1e-9) {
      swept = there;
      break;
    }
    ++row;
  }
  turn.last = row;
  turn.after = circle.sweep - swept;
  return turn;
}

// x^2 + y^2 = 2 a x + 2 b y + c, linear in a, b and c  [Kasa 1976]
std::optional<PlacedCircle> circle_through(const std::vector<double>& x, const std::vector<double>& y,
                                           const Turn& turn) {
  constexpr double kLeastSpread = 0.25;  // of the diameter, in x and in y: flat arcs say little of a centre
  const auto count = static_cast<Eigen::Index>(turn.last - turn.first + 1);
  Eigen::MatrixX3d rows(count, 3);
  Eigen::VectorXd squares(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const std::size_t k = turn.first + static_cast<std::size_t>(i);
    rows.row(i) << 2 * x[k], 2 * y[k], 1;
    squares[i] = x[k] * x[k] + y[k] * y[k];
  }
  const Eigen::ColPivHouseholderQR<Eigen::MatrixX3d> qr(rows);
  if (count < 8 || qr.rank() < 3) return std::nullopt;
  const Eigen::Vector3d found = qr.solve(squares);
  const double radius = std::sqrt(std::max(0.0, found[2] + found[0] * found[0] + found[1] * found[1]));
  const Eigen::RowVector3d spread = rows.colwise().maxCoeff() - rows.colwise().minCoeff();
  if (std::min(spread[0], spread[1]) / 2 < kLeastSpread * 2 * radius) return std::nullopt;
  return PlacedCircle{found[0], found[1], radius};
}

}  // namespace plumbline::imported
