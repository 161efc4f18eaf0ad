#include "imported/import.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/angle.hpp"
#include "base/files/path_of.hpp"
#include "base/units.hpp"
#include "imported/circles.hpp"
#include "imported/taken_rows.hpp"
#include "measure/dataset_text.hpp"

namespace plumbline::imported {
namespace {

using measure::Column;
using measure::Run;

constexpr std::array<Quantity, 7> kReadings{Quantity::radial,  Quantity::torque1, Quantity::torque2, Quantity::torque3,
                                            Quantity::torque4, Quantity::torque5, Quantity::torque6};

const std::vector<double>* column(const Source& source, const ForeignTable& table, Quantity quantity) {
  const ColumnSource* const found = source.find(quantity);
  return found == nullptr ? nullptr : &table.values[static_cast<std::size_t>(found - source.columns.data())];
}

// The file that a run names, among those that were given.
const std::string& file_of(const std::vector<std::string>& files, const std::string& name, const Place& place) {
  for (const std::string& file : files) {
    if (path_of(file).filename() == path_of(name).filename()) return file;
  }
  std::vector<std::string> names;
  for (const std::string& file : files) names.push_back(path_of(file).filename().generic_string());
  refuse("import-file", fmt::format("no file {} was given", name),
         fmt::format("name it on the command line; there are {}", fmt::join(names, ", ")), place);
}

// Milliseconds that are called seconds, and the like. What the control's own slowing does stays below.
void check_duration(const std::vector<double>& time, const Ways& ways, const Turn& turn, const Run& run,
                    const ForeignTable& table) {
  constexpr double kOtherUnit = 5;
  double sweep = 0;
  for (std::size_t i = turn.first + 1; i <= turn.last; ++i)
    sweep += std::abs(std::remainder(ways.angle[i] - ways.angle[i - 1], kTurn));
  const double expected = sweep * run.radius / run.feed;
  const double found = time[turn.last] - time[turn.first];
  if (found < kOtherUnit * expected && expected < kOtherUnit * found) return;
  refuse("import-value",
         fmt::format("from line {} to {} pass {:.6g} s, and run {} takes {:.6g} s there by its feed and radius",
                     table.lines[turn.first], table.lines[turn.last], found, run.id, expected),
         "check the unit of the column time (s, ms, us, min), and feed_mm_min and radius_mm of the run",
         table.place(turn.first));
}

class Importer {
 public:
  Importer(const Map& map, const std::vector<std::string>& files, const ImportOptions& options)
      : map_(map), files_(files), options_(options) {}

  Imported import() {
    for (const MapRun& run : map_.runs) add_run(run);
    imported_.dataset.machine = map_.machine;
    imported_.dataset.document.text = measure::dataset_text(imported_.dataset);
    return std::move(imported_);
  }

 private:
  // Each file is read once.
  std::size_t table_of(const std::string& name, const Source& source, const Place& place) {
    const std::string& file = file_of(files_, name, place);
    for (std::size_t i = 0; i < paths_.size(); ++i) {
      if (paths_[i] == file && read_by_[i] == &source) return i;
    }
    imported_.tables.push_back(read_foreign_table(file, source));
    imported_.sources.push_back(source);
    read_by_.push_back(&source);
    paths_.push_back(file);
    taken_of_.push_back(0);
    return paths_.size() - 1;
  }

  void add_run(const MapRun& map_run) {
    const Source& source = map_.source;
    const std::size_t number = table_of(map_run.run.file, source, map_run.run.place);
    const ForeignTable& table = imported_.tables[number];
    const Ways ways = ways_of(map_run, source, table, options_);
    const std::vector<Circle> circles = circles_in(ways, options_);
    const std::size_t which = map_run.circle > 0 ? map_run.circle : taken_of_[number] + 1;
    if (which > circles.size()) {
      refuse("import-no-circle",
             fmt::format("{} holds {} circle{} about [{:.6g}, {:.6g}] mm, and run {} is number {}", table.file,
                         circles.size(), circles.size() == 1 ? "" : "s", map_run.run.centre_W.x() / kMm,
                         map_run.run.centre_W.y() / kMm, map_run.run.id, which),
             "check centre, radius and feed of the run, the unit of the angle, and circle = ...", map_run.run.place);
    }
    taken_of_[number] = which;
    const Circle& circle = circles[which - 1];
    check_direction(map_run, circle, table);
    const Turn turn = turn_of(ways, circle, map_run, options_);
    check_run_in(map_run, circle, table);
    check_places(map_run, source, table, turn);
    if (const std::vector<double>* const time = column(source, table, Quantity::time)) {
      check_rises(*time, turn.first, turn.last, table);
      check_duration(*time, ways, turn, map_run.run, table);
    }
    TakenRun taken{map_run.run.id,
                   table.file,
                   table.lines[turn.first],
                   table.lines[turn.last],
                   which,
                   circles.size(),
                   circle.sweep,
                   turn.before,
                   turn.after,
                   0,
                   0,
                   ways.from};
    imported_.dataset.runs.push_back(run_of(map_run, number, ways, turn, taken));
    imported_.taken.push_back(taken);
  }

  static void check_direction(const MapRun& run, const Circle& circle, const ForeignTable& table) {
    if (circle.turn == run.run.turn()) return;
    Place place = table.place(circle.first);
    refuse("import-direction",
           fmt::format("from line {} on the tip goes {}, and the map says that run {} is {}", table.lines[circle.first],
                       circle.turn > 0 ? "ccw" : "cw", run.run.id, measure::to_text(run.run.direction)),
           "seen from +Z; angles count from +X towards +Y: check direction, the sign of the angle (sign = -1), and the "
           "order "
           "of the runs of this file",
           place);
  }

  // A run-in that is said must leave a turn behind it.
  static void check_run_in(const MapRun& run, const Circle& circle, const ForeignTable& table) {
    const double step = circle.sweep / static_cast<double>(std::max<std::size_t>(1, circle.last - circle.first));
    if (!run.run_in || *run.run_in + kTurn <= circle.sweep + 1.5 * step) return;
    refuse("import-value",
           fmt::format("after a run-in of {:.6g} deg no whole turn is left: from line {} on the tip goes {:.6g} deg",
                       *run.run_in / kDeg, table.lines[circle.first], circle.sweep / kDeg),
           "check run_in_deg, feed_mm_min and radius_mm of the run; without run_in_deg the turn in the middle is taken",
           run.run.place);
  }

  // Where the table says where the tip was, its circle is the one that the map says.
  void check_places(const MapRun& run, const Source& source, const ForeignTable& table, const Turn& turn) const {
    const std::vector<double>* const x = column(source, table, Quantity::x);
    const std::vector<double>* const y = column(source, table, Quantity::y);
    if (x == nullptr || y == nullptr) return;
    const std::optional<PlacedCircle> there = circle_through(*x, *y, turn);
    if (!there) return;
    const double dx = there->x - run.run.centre_W.x();
    const double dy = there->y - run.run.centre_W.y();
    if (std::hypot(dx, dy) < options_.other_place && std::abs(there->radius - run.run.radius) < options_.other_place) {
      return;
    }
    refuse("import-value",
           fmt::format("the places of {} lie on a circle of radius {:.2f} mm about [{:.2f}, {:.2f}], and the map says "
                       "{:.6g} mm about [{:.6g}, {:.6g}]",
                       table.file, there->radius / kMm, there->x / kMm, there->y / kMm, run.run.radius / kMm,
                       run.run.centre_W.x() / kMm, run.run.centre_W.y() / kMm),
           "check centre_mm and radius_mm of the run, and unit and minus of the columns x and y", run.run.place);
  }

  static void check_rises(const std::vector<double>& time, std::size_t first, std::size_t last,
                          const ForeignTable& table) {
    for (std::size_t i = first + 1; i <= last; ++i) {
      if (!(time[i] < time[i - 1])) continue;
      refuse("import-value",
             fmt::format("time goes back in line {}: {:.6g} s after {:.6g} s", table.lines[i], time[i], time[i - 1]),
             "rows belong in the order in which they were taken: turn the table around, or check the column time",
             table.place(i));
    }
  }

  // A reading of the motors at a time of the bar's clock.
  static double at(const std::vector<double>& time, const std::vector<double>& values, double t) {
    const auto above = std::upper_bound(time.begin(), time.end(), t);
    if (above == time.begin() || (above == time.end() && t > time.back())) return std::nan("");
    if (above == time.end()) return values.back();
    const auto k = static_cast<std::size_t>(above - time.begin());
    const double share = (t - time[k - 1]) / (time[k] - time[k - 1]);
    return values[k - 1] + share * (values[k] - values[k - 1]);
  }

  // Readings of one quantity in the rows of a turn; empty: it was not measured.
  std::vector<double> readings(const MapRun& run, std::size_t number, Quantity quantity, const Turn& turn) {
    const bool motor = quantity != Quantity::radial;
    const bool apart = motor && map_.motors.has_value();
    const Source& source = apart ? *map_.motors : map_.source;
    if (source.find(quantity) == nullptr) return {};
    const std::size_t of =
        apart ? table_of(run.motors_file.empty() ? run.run.file : run.motors_file, source, run.run.place) : number;
    const ForeignTable& table = imported_.tables[of];
    const std::vector<double>& values = *column(source, table, quantity);
    if (!motor || (!apart && map_.motors_later == 0)) {
      return {values.begin() + static_cast<std::ptrdiff_t>(turn.first),
              values.begin() + static_cast<std::ptrdiff_t>(turn.last) + 1};
    }
    const std::vector<double>* const bar_time = column(map_.source, imported_.tables[number], Quantity::time);
    const std::vector<double>* const time = column(source, table, Quantity::time);
    if (bar_time == nullptr || time == nullptr) {
      refuse("import-clock", "readings of two clocks need the time of each of them",
             "name a column time for both tables, or leave out motors_later_s", run.run.place);
    }
    check_rises(*time, 0, time->size() - 1, table);  // it is searched
    std::vector<double> moved;
    for (std::size_t i = turn.first; i <= turn.last; ++i) {
      moved.push_back(at(*time, values, (*bar_time)[i] + map_.motors_later));
    }
    return moved;
  }

  Run run_of(const MapRun& map_run, std::size_t number, const Ways& ways, const Turn& turn, TakenRun& taken) {
    Run run = map_run.run;
    run.file = run.id + ".csv";
    std::replace(run.file.begin(), run.file.end(), '/', '-');
    if (const std::vector<double>* const time = column(map_.source, imported_.tables[number], Quantity::time)) {
      for (std::size_t i = turn.first; i <= turn.last; ++i) run.time.push_back((*time)[i] - (*time)[turn.first]);
    }
    for (std::size_t i = turn.first; i <= turn.last; ++i) run.angle.push_back(ways.angle[i]);
    run.radial = readings(map_run, number, Quantity::radial, turn);
    for (std::size_t j = 0; j < run.torque.size(); ++j) {
      run.torque[j] = readings(map_run, number, kReadings[j + 1], turn);
    }
    check_rows(run, imported_.tables[number], turn.first, map_.samples != 0 && run.samples() > map_.samples);
    drop_missing(run, taken);
    check_count(run, taken.missing, map_.motors || map_.motors_later != 0);
    average(run);
    for (double& angle : run.angle) angle -= kTurn * std::floor(angle / kTurn + 1e-12);
    if (!run.time.empty()) run.columns.push_back({Column::time, 6});
    run.columns.push_back({Column::angle, 6});
    if (run.has_radial()) run.columns.push_back({Column::radial, 4});
    for (std::size_t j = 0; j < run.torque.size(); ++j) {
      if (!run.torque[j].empty()) {
        run.columns.push_back({static_cast<Column>(static_cast<std::size_t>(Column::torque1) + j), 5});
      }
    }
    taken.samples = run.samples();
    return run;
  }

  // Each list of a run's numbers that is not empty.
  template <class Do>
  static void each_list(Run& run, Do&& what) {
    for (std::vector<double>* list : {&run.time, &run.angle, &run.radial}) {
      if (!list->empty()) what(*list);
    }
    for (std::vector<double>& torque : run.torque) {
      if (!torque.empty()) what(torque);
    }
  }

  static void drop_missing(Run& run, TakenRun& taken) {
    std::vector<bool> keep(run.samples(), true);
    each_list(run, [&](std::vector<double>& list) {
      for (std::size_t i = 0; i < list.size(); ++i) keep[i] = keep[i] && std::isfinite(list[i]);
    });
    taken.missing = static_cast<std::size_t>(std::count(keep.begin(), keep.end(), false));
    each_list(run, [&](std::vector<double>& list) {
      std::size_t to = 0;
      for (std::size_t i = 0; i < list.size(); ++i) {
        if (keep[i]) list[to++] = list[i];
      }
      list.resize(to);
    });
  }

  // The mean of the samples that fall into each of so many parts of a turn.
  void average(Run& run) const {
    if (map_.samples == 0 || run.samples() <= map_.samples) return;
    std::vector<double> swept(run.samples(), 0);
    for (std::size_t i = 1; i < swept.size(); ++i) {
      swept[i] = swept[i - 1] + std::abs(std::remainder(run.angle[i] - run.angle[i - 1], kTurn));
    }
    const double start = run.angle.front();
    for (std::size_t i = 0; i < swept.size(); ++i) run.angle[i] = start + run.turn() * swept[i];
    std::vector<std::size_t> part(swept.size());
    for (std::size_t i = 0; i < swept.size(); ++i) {
      part[i] = static_cast<std::size_t>(swept[i] / kTurn * static_cast<double>(map_.samples) + 1e-9);
    }
    each_list(run, [&](std::vector<double>& list) {
      std::vector<double> means;
      for (std::size_t i = 0; i < list.size();) {
        std::size_t end = i;
        double sum = 0;
        while (end < list.size() && part[end] == part[i]) sum += list[end++];
        means.push_back(sum / static_cast<double>(end - i));
        i = end;
      }
      list = std::move(means);
    });
  }

  const Map& map_;
  const std::vector<std::string>& files_;
  ImportOptions options_;
  Imported imported_;
  std::vector<std::string> paths_;      // of each table,
  std::vector<const Source*> read_by_;  // by which part of the map
  std::vector<std::size_t> taken_of_;   // of each table, the number of the circle that was taken last
};

}  // namespace

Imported import_files(const Map& map, const std::vector<std::string>& files, const ImportOptions& options) {
  return Importer(map, files, options).import();
}

}  // namespace plumbline::imported
