#include "measure/thinning.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/parallel.hpp"
#include "base/units.hpp"
#include "measure/circular_motion.hpp"
#include "measure/even_grid.hpp"
#include "measure/fine_waves.hpp"
#include "measure/friction_turns.hpp"
#include "measure/simulation.hpp"

namespace plumbline::measure {
namespace {

using machine::kStruts;

constexpr double kSameCircle = 1e-6;  // m, rad: files write places to a micrometre

// The bar's readings are channel 0, the torques follow.
std::vector<double>& column(Run& run, std::size_t channel) {
  return channel == 0 ? run.radial : run.torque.at(channel - 1);
}
const std::vector<double>& column(const Run& run, std::size_t channel) {
  return channel == 0 ? run.radial : run.torque.at(channel - 1);
}

// Those that were measured.
std::vector<std::size_t> columns_of(const Run& run) {
  std::vector<std::size_t> columns;
  for (std::size_t channel = 0; channel <= kStruts; ++channel) {
    if (!column(run, channel).empty()) columns.push_back(channel);
  }
  return columns;
}

SampleColumns readings_of(const Run& run, const std::vector<std::size_t>& columns) {
  SampleColumns readings(static_cast<Eigen::Index>(columns.size()), static_cast<Eigen::Index>(run.samples()));
  for (std::size_t c = 0; c < columns.size(); ++c) {
    readings.row(static_cast<Eigen::Index>(c)) =
        Eigen::Map<const Eigen::RowVectorXd>(column(run, columns[c]).data(), readings.cols());
  }
  return readings;
}

// s_j at each sample, on the commanded path.
SampleColumns signs_of(const machine::MachineModel& machine, const physics::Environment& environment, const Run& run) {
  SampleColumns signs(kStruts, static_cast<Eigen::Index>(run.samples()));
  for (std::size_t i = 0; i < run.samples(); ++i) {
    const physics::Motion<double> motion = circular_motion(machine.rotation, run, i);
    signs.col(static_cast<Eigen::Index>(i)) =
        physics::strut_rates(machine::strut_geometry(machine.geometry, motion.pose), motion, environment).sign;
  }
  return signs;
}

std::vector<int> circles_of(const std::vector<Run>& runs) {
  std::vector<int> circles(runs.size());
  for (std::size_t i = 0; i < runs.size(); ++i) {
    circles[i] = static_cast<int>(i);
    for (std::size_t k = i; k-- > 0;) {
      const bool same = (runs[i].centre_W - runs[k].centre_W).norm() < kSameCircle &&
                        (runs[i].tilt - runs[k].tilt).norm() < kSameCircle &&
                        std::abs(runs[i].radius - runs[k].radius) < kSameCircle;
      if (same) circles[i] = circles[k];
    }
  }
  return circles;
}

// The readings of a run on the finest grid, by angle; a row for each channel, empty if it was not measured.
using FineRun = std::array<Eigen::RowVectorXd, kStruts + 1>;

FineRun fine_run(const Run& run, std::size_t points) {
  FineRun fine;
  const EvenGrid grid(run, points);
  if (!grid.possible() || !grid.whole_turn()) return fine;
  const auto columns = columns_of(run);
  const Eigen::MatrixXd readings = grid.project(readings_of(run, columns));
  const std::vector<double> angles = grid.angles();
  for (std::size_t c = 0; c < columns.size(); ++c) {
    Eigen::RowVectorXd& row = fine.at(columns[c]);
    row.resize(static_cast<Eigen::Index>(points));
    for (std::size_t k = 0; k < points; ++k) {
      const double place = angles[k] / (2 * std::numbers::pi) * static_cast<double>(points);
      row[std::lround(place) % row.size()] = readings(static_cast<Eigen::Index>(c), static_cast<Eigen::Index>(k));
    }
  }
  return fine;
}

// What all channels of long records hold of waves, and those that the machine's screws may make.
std::vector<OrderRange> waves_in(const std::vector<Run>& runs, const physics::ForceModel& forces,
                                 const std::vector<bool>& is_long, std::size_t most) {
  std::vector<OrderRange> waves;
  std::size_t points = most;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (!is_long[i]) continue;
    points = std::min(points, runs[i].samples() / 2);
    // dL / d angle is at most the radius
    waves.push_back({0, 2 * std::numbers::pi * runs[i].radius / forces.machine.lead.minCoeff()});
  }
  std::vector<FineRun> fine(runs.size());
  for_each_index(runs.size(), [&](std::size_t i) {
    if (is_long[i]) fine[i] = fine_run(runs[i], points);
  });
  const std::vector<int> circles = circles_of(runs);
  for (std::size_t channel = 0; channel <= kStruts; ++channel) {
    std::vector<int> circle;
    std::vector<const Eigen::RowVectorXd*> rows;
    for (std::size_t i = 0; i < runs.size(); ++i) {
      if (fine[i].at(channel).size() == 0) continue;
      rows.push_back(&fine[i].at(channel));
      circle.push_back(circles[i]);
    }
    Eigen::MatrixXd readings(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(points));
    for (std::size_t r = 0; r < rows.size(); ++r) readings.row(static_cast<Eigen::Index>(r)) = *rows[r];
    const FineWaveOptions options;
    const double least = channel == 0 ? options.least_um * kUm : options.least_Nm;
    const std::vector<OrderRange> more = fine_waves(readings, circle, least, options);
    waves.insert(waves.end(), more.begin(), more.end());
  }
  return waves;
}

bool make_short(const machine::MachineModel& machine, const physics::ForceModel& forces, std::size_t points, Run& run) {
  const EvenGrid grid(run, points);
  if (!grid.possible()) return false;
  const auto columns = columns_of(run);
  const Eigen::MatrixXd readings = grid.project(readings_of(run, columns));
  const Eigen::MatrixXd signs = grid.project(signs_of(machine, environment_of(forces, run), run));
  const Eigen::MatrixXd time =
      grid.project(Eigen::Map<const Eigen::RowVectorXd>(run.time.data(), static_cast<Eigen::Index>(run.samples())));
  run.time.assign(time.data(), time.data() + time.size());
  run.angle = grid.angles();
  for (std::size_t c = 0; c < columns.size(); ++c) {
    const auto row = readings.row(static_cast<Eigen::Index>(c));
    column(run, columns[c]) = std::vector<double>(row.begin(), row.end());
  }
  run.signs.resize(run.samples());
  for (std::size_t k = 0; k < run.samples(); ++k) {
    Eigen::Map<machine::PerStrut<double>>(run.signs[k].data()) = signs.col(static_cast<Eigen::Index>(k));
  }
  return true;
}

}  // namespace

Thinned fit_runs(const machine::MachineModel& machine, std::vector<Run> runs, ThinningOptions options) {
  options.fill_turns = true;
  Thinned made = thinned(machine, std::move(runs), options);
  const physics::ForceModel forces(machine);
  for_each_index(made.runs.size(), [&](std::size_t i) {
    made.runs[i] = without_friction_turns(machine, forces, std::move(made.runs[i]));
  });
  return made;
}

Thinned thinned(const machine::MachineModel& machine, std::vector<Run> runs, const ThinningOptions& options) {
  Thinning thinning{.runs = runs.size()};
  std::vector<bool> is_long;
  for (const Run& run : runs) {
    thinning.longest = std::max(thinning.longest, run.samples());
    is_long.push_back(run.samples() >= 2 * options.points.front());
  }
  if (std::find(is_long.begin(), is_long.end(), true) == is_long.end()) return {std::move(runs), thinning};
  const physics::ForceModel forces(machine);
  const std::vector<OrderRange> waves = waves_in(runs, forces, is_long, options.points.back());
  thinning.points = points_for(waves, options.points);
  std::vector<unsigned char> made_short(runs.size(), 0);
  for_each_index(runs.size(), [&](std::size_t i) {
    if (!is_long[i] || runs[i].samples() < 2 * thinning.points) return;
    if (options.fill_turns) fill_friction_turns(machine, forces, runs[i]);
    made_short[i] = make_short(machine, forces, thinning.points, runs[i]) ? 1 : 0;
  });
  thinning.thinned = static_cast<std::size_t>(std::count(made_short.begin(), made_short.end(), 1));
  return {std::move(runs), thinning};
}

}  // namespace plumbline::measure
