// Measurements: circular tests with a ballbar and the torques of the motors, as a dataset holds them.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostic.hpp"
#include "base/pose.hpp"
#include "base/text/toml.hpp"
#include "machine/geometry.hpp"
#include "measure/protocol.hpp"
#include "physics/motion.hpp"

namespace plumbline::measure {

enum class Direction { ccw, cw };
std::string_view to_text(Direction direction);

/// The columns of a run's table, in the order of kColumns.
enum class Column { time, angle, radial, torque1, torque2, torque3, torque4, torque5, torque6 };
struct ColumnSpec {
  std::string_view name;  // in the first line of the table
  std::string_view unit;
  double si = 1;
  double largest = 0;  // magnitude that makes sense, in the file's unit
};
inline constexpr std::size_t kColumnCount = 9;
extern const std::array<ColumnSpec, kColumnCount> kColumns;

/// A column as the table has it.
struct TableColumn {
  Column column = Column::time;
  int decimals = 3;  // the most that a number of it has
};

/// What a table says otherwise than the dataset.
enum class Contradiction { direction, feed };

/// One full turn of the tool tip at constant feed, from angle 0, without a run-in. SI.
struct Run {
  std::string id;
  std::string file;                                    // of the table, beside the dataset
  Vector3<double> centre_W = Vector3<double>::Zero();  // of the tool tip's circle, m
  double radius = 0;                                   // m
  std::optional<double> bar;                           // length, m; nothing: the bar lies in the plane of the circle
  Vector3<double> tilt = Vector3<double>::Zero();      // A, B, C, rad
  Direction direction = Direction::ccw;
  double feed = 0;          // m/s
  double start = 0;         // on the clock of the dataset, s
  double payload_mass = 0;  // known, suspended from the tool tip, kg
  std::string planned;      // hash of the table that a plan wrote for it; empty: none did
  bool as_planned = false;  // its table is that one: nothing was measured
  Place place;              // of centre_mm in the dataset; no file: the run was made

  // Columns, one number per sample. time and angle are always there: one that was not measured follows from the other
  // and the feed. radial and torque are empty if they were not measured.
  std::vector<double> time;                                  // from the start of the run, s
  std::vector<double> angle;                                 // commanded, from +X towards +Y, rad
  std::vector<double> radial;                                // bar reading minus bar length, m
  std::array<std::vector<double>, machine::kStruts> torque;  // N m
  std::vector<TableColumn> columns;                          // of the table, in its order
  std::vector<std::size_t> left_out;  // lines of the table with a reading that is empty or NaN, taken for no samples
  std::vector<Contradiction> contradictions;  // in which the table was believed
  // s_j of each sample of a run that was made short, as the low-pass left it; empty: that of its motion
  std::vector<physics::StrutSigns> signs;

  std::size_t samples() const { return angle.size(); }
  bool has_radial() const { return !radial.empty(); }
  bool has_torque() const { return !torque[0].empty(); }
  /// +1 counterclockwise, seen from +Z; -1 clockwise.
  double turn() const { return direction == Direction::ccw ? 1 : -1; }
  double bar_length() const { return bar.value_or(radius); }
};

/// Where a table contradicts the dataset.
enum class Believe {
  nothing,    // it is refused
  the_table,  // the run is as its table says, and keeps a note: for who judges data
};

/// A run without some of its samples (ascending).
Run without_samples(Run run, const std::vector<std::size_t>& samples);

/// Of a dataset, and of datasets that are joined: plumbline plan proposes no more. What judges runs by each other takes
/// time with the square of their number.
inline constexpr std::size_t kMostRuns = 200;

struct Dataset {
  std::string machine;  // name of the model that it was measured on
  Protocol protocol;
  Instrument instrument;
  std::vector<Run> runs;
  TomlDocument document;  // what it was read from; without a file's name: it was made
};

/// What a [[run]] says, without its table; keys beside those of a dataset are `others`. Refuses as read_dataset does.
Run read_run(const TomlDocument& document, const TomlValue& table, const std::vector<std::string_view>& others = {});

/// Refuses with dataset-too-many-runs.
void check_run_count(std::size_t runs, const Place& place);

/// What `planned` of a run says of its table.
std::string table_hash(std::string_view table);

/// Refuses with dataset-not-measured a run whose table is the one that a plan wrote.
void check_measured(const Dataset& dataset);

/// Reads a dataset.toml and the tables of its runs. Refuses with toml-syntax, dataset-marker, dataset-unknown-key,
/// dataset-missing-key, dataset-wrong-type, dataset-wrong-size, dataset-out-of-range, dataset-direction, dataset-bar,
/// dataset-same-id, dataset-no-runs, dataset-too-many-runs, dataset-file-outside or dataset-file-missing at the value,
/// with what run_table.hpp lists at the row and column, and as read_text does.
Dataset read_dataset(const std::string& path, Believe believe = Believe::nothing);

/// The same of a text; tables are looked for in `folder`.
Dataset parse_dataset(std::string text, const std::string& file, const std::string& folder,
                      Believe believe = Believe::nothing);

/// What read_dataset would read: `path` and the tables of its runs; of a pipe, which is read once, `path` alone.
/// Refuses a dataset.toml whose runs cannot be listed as read_dataset does.
std::vector<std::string> files_of_dataset(const std::string& path);

/// What is simulated can be made again, and replaces what stands there.
enum class Readings : std::uint8_t { simulated, measured };

/// Writes the dataset's text, as it was read, as dataset.toml into a folder, made if need be, and the tables beside it.
/// Refuses, before anything is written, with dataset-file-outside a table that would lie outside the folder, with
/// file-overwrites-input what would overwrite the dataset that was read or a table of it, and with dataset-same-file
/// two runs of one table, with dataset-folder-taken, for readings that are measured, a folder where another file of
/// such a name stands; and with file-unwritable.
void write_dataset(const Dataset& dataset, const std::string& folder, Readings readings = Readings::simulated);

}  // namespace plumbline::measure
