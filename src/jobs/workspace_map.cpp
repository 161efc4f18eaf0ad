#include "jobs/workspace_map.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/parallel.hpp"
#include "base/text/number_text.hpp"
#include "base/units.hpp"
#include "identify/equations/sensitivity.hpp"
#include "machine/axis_words.hpp"
#include "machine/condition.hpp"
#include "machine/forward.hpp"
#include "machine/limits.hpp"
#include "physics/tip_stiffness.hpp"

namespace plumbline::jobs {
namespace {

constexpr double kDefaultParts = 20;    // of the box's longest side
constexpr double kFurthest = 50;        // m
constexpr double kMostPoses = 1e9;      // more is a slip of units
constexpr std::size_t kBatch = 2048;    // cells that are computed together
constexpr double kSameStep = 1 - 1e-9;  // a side that is a whole number of steps, but for rounding

std::vector<double> evenly(const machine::Range& range, double step) {
  const auto parts = static_cast<std::size_t>(std::max(1.0, std::ceil((range.upper - range.lower) / step * kSameStep)));
  std::vector<double> points;
  for (std::size_t i = 0; i <= parts; ++i)
    points.push_back(std::lerp(range.lower, range.upper, static_cast<double>(i) / static_cast<double>(parts)));
  return points;
}

// What is the same for all cells.
class CellMaker {
 public:
  explicit CellMaker(const machine::MachineModel& model)
      : model_(model),
        unknowns_(identify::nuisances(model, physics::ForceModel(model))),
        forces_(unknowns_.at(unknowns_.start())),
        sensitivity_(forces_, unknowns_),
        at_rest_(forces_.environment()),
        radius_(machine::platform_radius(model.geometry)),
        side_(machine::side_of(model.geometry, machine::home_pose(model))) {
    at_rest_.friction = false;
    if (!has_uncertainty()) return;
    physics::Motion<double> motion;
    motion.pose = machine::home_pose(model);
    const physics::TipError<double> error = physics::tip_error(forces_, at_rest_, motion);
    if (!error.converged()) {
      refuse(
          "map-middle",
          fmt::format("in the middle of its travel the machine gives way: {}", physics::to_text(error.stopped_because)),
          "look at the masses, the compliances and [limits] of the model", {model.document.file});
    }
    middle_ = slopes_at(motion, error);
  }
  CellMaker(const CellMaker&) = delete;  // the sensitivity refers to the forces beside it
  CellMaker& operator=(const CellMaker&) = delete;

  bool has_uncertainty() const { return unknowns_.size() > 0; }

  MapCell operator()(const AxisWords& words) const {
    MapCell cell;
    cell.pose = words;
    physics::Motion<double> motion;
    motion.pose = machine::pose_of(model_.rotation, words);
    for (const machine::Violation& broken : machine::check_compensated(model_.limits, model_.geometry, motion.pose))
      cell.out.push_back(limit_text(broken));
    if (machine::side_of(model_.geometry, motion.pose) != side_) cell.out.emplace_back("beyond a singularity");
    if (!cell.reached()) return cell;
    const physics::TipError<double> error = physics::tip_error(forces_, at_rest_, motion);
    if (!error.converged()) {
      cell.out.emplace_back("gives way");
      return cell;
    }
    cell.error = error.displacement.head<3>();
    cell.stiffness = physics::least_stiffness(physics::tip_compliance(forces_, at_rest_, motion, error));
    cell.condition = machine::condition_number(machine::strut_geometry(model_.geometry, motion.pose), radius_);
    cell.largest_force = error.loads.nut_tension.cwiseAbs().maxCoeff();
    if (has_uncertainty()) judge(motion, error, cell);
    return cell;
  }

 private:
  static std::string limit_text(const machine::Violation& broken) {
    const bool beyond = broken.value > broken.limit;
    if (broken.what.starts_with("strut")) return broken.what + (beyond ? " too long" : " too short");
    return broken.what + (beyond ? " too large" : " too small");
  }

  identify::Slopes slopes_at(const physics::Motion<double>& motion, const physics::TipError<double>& error) const {
    identify::Slopes slopes(identify::kOutcomes, sensitivity_.unknowns());
    sensitivity_.at(at_rest_, motion, error, slopes);
    return slopes;
  }

  // sigma^2 = sum over what is not known exactly, and over x, y, z, of (slope sigma_i)^2; of a distance between two
  // poses with the difference of their slopes
  void judge(const physics::Motion<double>& motion, const physics::TipError<double>& error, MapCell& cell) const {
    const identify::Slopes slopes = slopes_at(motion, error);
    double variance = 0;
    double touched_off = 0;
    for (Eigen::Index i = 0; i < slopes.cols(); ++i) {
      const double sigma = unknowns_[static_cast<std::size_t>(i)].sigma;
      const Vector3<double> slope = slopes.col(i).segment<3>(identify::kTipRow);
      const Vector3<double> in_the_middle = middle_.col(i).segment<3>(identify::kTipRow);
      variance += slope.squaredNorm() * sigma * sigma;
      touched_off += (slope - in_the_middle).squaredNorm() * sigma * sigma;
    }
    cell.uncertainty = std::sqrt(variance);
    cell.touched_off = std::sqrt(touched_off);
  }

  const machine::MachineModel& model_;
  identify::Unknowns unknowns_;
  physics::ForceModel forces_;
  identify::Sensitivity sensitivity_;
  physics::Environment at_rest_;
  identify::Slopes middle_;  // in the middle of the travel
  double radius_;
  int side_;
};

void note(MapFigure& figure, double value, const AxisWords& where, bool low_is_bad = false) {
  const bool first = figure.spread.count() == 0;
  if (first || (low_is_bad ? value < figure.spread.least() : value > figure.spread.largest())) figure.worst = where;
  figure.spread.add(value);
}

void note(MapSummary& summary, const MapCell& cell) {
  ++summary.poses;
  for (const std::string& limit : cell.out) ++summary.out[limit];
  if (!cell.reached()) return;
  ++summary.reached;
  note(summary.error, cell.error.norm(), cell.pose);
  note(summary.stiffness, cell.stiffness, cell.pose, true);
  note(summary.condition, cell.condition, cell.pose);
  note(summary.force, cell.largest_force, cell.pose);
  if (!summary.has_uncertainty) return;
  note(summary.uncertainty, cell.uncertainty, cell.pose);
  note(summary.touched_off, cell.touched_off, cell.pose);
}

// The pose of that number, X fastest.
AxisWords pose_at(const WorkspaceGrid& grid, std::uint64_t number) {
  std::array<std::size_t, 3> at{};
  for (std::size_t a = 0; a < 3; ++a) {
    at[a] = number % grid.axes[a].size();
    number /= grid.axes[a].size();
  }
  AxisWords words = grid.tilts[number];
  for (const Axis axis : {Axis::X, Axis::Y, Axis::Z}) words[axis] = grid.axes[index(axis)][at[index(axis)]] / kMm;
  return words;
}

void check_reach(double end, Axis axis) {
  if (std::abs(end) <= kFurthest) return;
  refuse("map-box", fmt::format("{} {:.4g} mm is further out than any machine goes", letter(axis), end / kMm),
         "give the box and its planes in mm");
}

}  // namespace

WorkspaceGrid workspace_grid(const machine::MachineModel& model, const MapOptions& options) {
  std::array<machine::Range, 3> box;
  double longest = 0;
  for (const double z : options.planes) check_reach(z, Axis::Z);
  for (std::size_t a = 0; a < 3; ++a) {
    box[a] = options.box[a].value_or(model.limits.travel[a]);
    for (const double end : {box[a].lower, box[a].upper}) check_reach(end, kAllAxes[a]);
    const double width = box[a].upper - box[a].lower;
    if (!(width > 0)) {
      refuse("map-box",
             fmt::format("the box has no width in {}: {} to {} mm", kAxisLetters[a], to_decimal(box[a].lower / kMm),
                         to_decimal(box[a].upper / kMm)),
             "give the lower end first; for one plane of Z use --z");
    }
    longest = std::max(longest, width);
  }
  const double step = options.step.value_or(longest / kDefaultParts);
  auto poses = static_cast<double>(options.tilts.size());
  for (std::size_t a = 0; a < 3; ++a) {
    const bool planes = a == 2 && !options.planes.empty();
    poses *= planes ? static_cast<double>(options.planes.size()) : (box[a].upper - box[a].lower) / step + 1;
  }
  if (!(step > 0) || poses > kMostPoses) {
    refuse("map-step", fmt::format("a step of {} mm makes {:.2g} poses", to_decimal(step / kMm), poses),
           "take a larger step, in mm, or a smaller box");
  }
  WorkspaceGrid grid;
  for (std::size_t a = 0; a < 3; ++a) grid.axes[a] = evenly(box[a], step);
  if (!options.planes.empty()) {
    grid.axes[2] = options.planes;
    std::sort(grid.axes[2].begin(), grid.axes[2].end());
    grid.axes[2].erase(std::unique(grid.axes[2].begin(), grid.axes[2].end()), grid.axes[2].end());
  }
  grid.tilts = options.tilts;
  return grid;
}

bool knows_uncertainty(const machine::MachineModel& model) {
  return identify::nuisances(model, physics::ForceModel(model)).size() > 0;
}

MapSummary map_workspace(const machine::MachineModel& model, const MapOptions& options,
                         const std::function<void(const MapCell&)>& take, const Progress& progress) {
  const WorkspaceGrid grid = workspace_grid(model, options);
  const CellMaker make(model);
  MapSummary summary;
  summary.has_uncertainty = make.has_uncertainty();
  const std::uint64_t all = grid.poses();
  std::vector<MapCell> batch;
  while (summary.poses < all) {
    const std::uint64_t first = summary.poses;
    batch.resize(static_cast<std::size_t>(std::min<std::uint64_t>(kBatch, all - first)));
    for_each_index(batch.size(), [&](std::size_t i) { batch[i] = make(pose_at(grid, first + i)); });
    for (const MapCell& cell : batch) {
      note(summary, cell);
      take(cell);
    }
    if (progress) progress(summary.poses, all);
  }
  return summary;
}

}  // namespace plumbline::jobs
