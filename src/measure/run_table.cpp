#include "measure/run_table.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/angle.hpp"
#include "base/files/files.hpp"
#include "base/text/csv.hpp"
#include "base/text/nearest_name.hpp"
#include "base/text/number_text.hpp"
#include "base/units.hpp"

namespace plumbline::measure {

const std::array<ColumnSpec, kColumnCount> kColumns{{{"time_s", "s", 1, 1e6},
                                                     {"angle_deg", "deg", kDeg, 720},
                                                     {"radial_um", "um", kUm, 2e4},
                                                     {"torque1_Nm", "N m", 1, 1e4},
                                                     {"torque2_Nm", "N m", 1, 1e4},
                                                     {"torque3_Nm", "N m", 1, 1e4},
                                                     {"torque4_Nm", "N m", 1, 1e4},
                                                     {"torque5_Nm", "N m", 1, 1e4},
                                                     {"torque6_Nm", "N m", 1, 1e4}}};

namespace {

constexpr std::size_t kFirstTorque = static_cast<std::size_t>(Column::torque1);

const ColumnSpec& spec_of(Column column) { return kColumns[static_cast<std::size_t>(column)]; }

template <class AnyRun>
auto& values_of(AnyRun& run, Column column) {
  switch (column) {
    case Column::time:
      return run.time;
    case Column::angle:
      return run.angle;
    case Column::radial:
      return run.radial;
    default:
      return run.torque[static_cast<std::size_t>(column) - kFirstTorque];
  }
}

// Instruments write these where they have no reading. Where a sample was taken must be known.
const CsvField* empty_reading(const std::vector<TableColumn>& columns, const std::vector<CsvField>& fields) {
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const std::string_view text = fields[i].text;
    if (columns[i].column < Column::radial) continue;
    if (text.empty() || text == "NaN" || text == "nan" || text == "NAN") return &fields[i];
  }
  return nullptr;
}

// Single samples without a reading are left out, no more.
void check_left_out(const Run& run, std::size_t rows, const Place& first, const TableOptions& options) {
  const std::size_t left_out = run.left_out.size();
  const std::size_t all = left_out + rows;
  if (static_cast<double>(left_out) <= options.most_left_out * static_cast<double>(all)) return;
  refuse("table-number",
         fmt::format("row {}: \"{}\" is no finite number, and so it is in {} of {} rows", first.line,
                     first.text.size() < first.column ? "" : first.text.substr(first.column - 1, first.length),
                     left_out, all),
         "single samples without a reading are left out, not so many; leave the whole column out if it was not "
         "measured, or these rows",
         first);
}

// Angles that go against the direction from sample to sample.
bool goes_back(const Run& run) {
  std::size_t back = 0;
  for (std::size_t i = 1; i < run.angle.size(); ++i) {
    if (std::remainder(run.angle[i] - run.angle[i - 1], kTurn) * run.turn() < 0) ++back;
  }
  return run.angle.size() > 1 && back + 1 == run.angle.size();
}

class TableReader {
 public:
  TableReader(const std::string& path, Run& run, const TableOptions& options)
      : text_(read_text(path)), lines_(path, text_), run_(run), options_(options) {}

  void read() {
    read_header();
    check_header();
    while (lines_.next()) read_row();
    check_left_out(run_, rows(), first_left_out_, options_);
    if (run_.time.size() + run_.angle.size() == 0 || rows() < options_.fewest_samples) refuse_too_few();
    check_time();
    check_angle();
    check_feed();
    fill_in();
    check_turn();
  }

 private:
  std::size_t rows() const { return places_.size(); }

  // --- the first line ---

  void read_header() {
    header_ = lines_.place();
    if (!lines_.next()) return;
    for (const CsvField& field : lines_.fields()) {
      const auto* const known = std::find_if(kColumns.begin(), kColumns.end(),
                                             [&](const ColumnSpec& spec) { return spec.name == field.text; });
      if (known == kColumns.end()) refuse_unknown(field);
      const auto column = static_cast<Column>(known - kColumns.begin());
      if (has_column(run_, column)) {
        refuse("table-same-column", fmt::format("there are two columns {}", field.text), "leave one of them out",
               lines_.place(field));
      }
      run_.columns.push_back({column, 0});
    }
    header_ = lines_.place();
  }

  [[noreturn]] void refuse_unknown(const CsvField& field) const {
    std::vector<std::string_view> names;
    for (const ColumnSpec& spec : kColumns) names.push_back(spec.name);
    const std::string separated = other_separator(field.text);
    refuse("table-unknown-column", fmt::format("\"{}\" is no column of a run", field.text),
           separated.empty() ? suggestion(field.text, names) : separated, lines_.place(field));
  }

  void check_header() const {
    if (!has_column(run_, Column::time) && !has_column(run_, Column::angle)) {
      refuse("table-missing-column", "there is neither a column angle_deg nor a column time_s",
             "one of them says where on the circle each sample was taken", header_);
    }
    std::string missing;
    std::size_t torques = 0;
    for (std::size_t j = kFirstTorque; j < kColumnCount; ++j) {
      if (has_column(run_, static_cast<Column>(j))) {
        ++torques;
      } else {
        missing += fmt::format("{}{}", missing.empty() ? "" : ", ", kColumns[j].name);
      }
    }
    if (torques > 0 && !missing.empty()) {
      refuse("table-missing-column", fmt::format("torques are given in part: {} is missing", missing),
             "give the torques of all six struts, or of none", header_);
    }
    if (torques == 0 && !has_column(run_, Column::radial)) {
      refuse("table-missing-column", "nothing was measured: there is neither radial_um nor a torque",
             "add the column radial_um (bar reading minus bar length), the columns torque1_Nm to torque6_Nm, or both",
             header_);
    }
  }

  // --- rows ---

  void read_row() {
    const std::vector<CsvField> fields = lines_.fields();
    if (fields.size() != run_.columns.size()) {
      refuse("table-columns",
             fmt::format("row {} has {} columns, and the first line names {}", lines_.number(), fields.size(),
                         run_.columns.size()),
             "write one number for each column, a point for decimals and a comma between columns", lines_.place());
    }
    if (const CsvField* const none = empty_reading(run_.columns, fields)) {
      run_.left_out.push_back(lines_.number());
      if (run_.left_out.size() == 1) first_left_out_ = lines_.place(*none);
      return;
    }
    places_.push_back(lines_.place());
    for (std::size_t i = 0; i < fields.size(); ++i) read_number(fields[i], run_.columns[i]);
  }

  void read_number(const CsvField& field, TableColumn& column) {
    const ColumnSpec& spec = spec_of(column.column);
    const std::optional<double> value = parse_number(field.text);
    if (!value || std::abs(*value) > spec.largest) {
      refuse("table-number",
             fmt::format("row {}, column {}: \"{}\" is {}", lines_.number(), spec.name, field.text,
                         value ? fmt::format("beyond {} {}", spec.largest, spec.unit) : "no finite number"),
             fmt::format("expected a number in {}, as in 12.5; leave the whole column out if it was not measured",
                         spec.unit),
             lines_.place(field));
    }
    const std::size_t point = field.text.find('.');
    const bool has_exponent = field.text.find_first_of("eE") != std::string_view::npos;
    const std::size_t digits = has_exponent                      ? kMostDecimals
                               : point == std::string_view::npos ? 0
                                                                 : field.text.size() - point - 1;
    column.decimals = std::max(column.decimals, static_cast<int>(std::min<std::size_t>(digits, kMostDecimals)));
    values_of(run_, column.column).push_back(*value * spec.si);
  }

  [[noreturn]] void refuse_too_few() const {
    refuse("table-too-few", fmt::format("{} samples are too few for a circle", rows()),
           fmt::format("a run needs at least {}, best every 0.5 to 3 deg", options_.fewest_samples), header_);
  }

  // --- what the numbers mean together ---

  void check_time() const {
    for (std::size_t i = 1; i < run_.time.size(); ++i) {
      if (run_.time[i] > run_.time[i - 1]) continue;
      refuse("table-time", fmt::format("time_s does not go on: {} s after {} s", run_.time[i], run_.time[i - 1]),
             "samples are in the order in which they were taken, each later than the one before", places_[i]);
    }
  }

  void check_angle() {
    if (options_.believe == Believe::the_table && goes_back(run_)) {
      run_.direction = run_.direction == Direction::ccw ? Direction::cw : Direction::ccw;
      run_.contradictions.push_back(Contradiction::direction);
    }
    swept_.assign(1, 0);
    for (std::size_t i = 1; i < run_.angle.size(); ++i) {
      const double step = std::remainder(run_.angle[i] - run_.angle[i - 1], kTurn) * run_.turn();
      if (step <= 0) {
        refuse("table-angle",
               fmt::format("angle_deg goes from {:.6g} to {:.6g}, and the run is {}", run_.angle[i - 1] / kDeg,
                           run_.angle[i] / kDeg, to_text(run_.direction)),
               fmt::format("angles {} from sample to sample (past 0 or 360 they go on at the other end); check the "
                           "direction of this run in the dataset",
                           run_.turn() > 0 ? "grow" : "fall"),
               places_[i]);
      }
      swept_.push_back(swept_.back() + step);
      if (swept_.back() > options_.most_turns * kTurn) {
        refuse("table-angle", "the angles go more than once around", "a run is one turn: make each turn a run",
               places_[i]);
      }
    }
  }

  void check_feed() {
    if (run_.time.empty() || run_.angle.empty()) return;
    const double stated = run_.feed / run_.radius;
    const double found = swept_.back() / (run_.time.back() - run_.time.front());
    if (std::abs(found / stated - 1) <= options_.feed_tolerance) return;
    if (options_.believe == Believe::the_table) {
      run_.feed = found * run_.radius;
      run_.contradictions.push_back(Contradiction::feed);
      return;
    }
    refuse("table-feed",
           fmt::format("the table takes {:.4g} mm/min around the circle, and the dataset says feed_mm_min = {:.4g}",
                       found * run_.radius / kMmPerMin, run_.feed / kMmPerMin),
           "check the units: time_s in seconds, angle_deg in degrees, feed_mm_min in mm/min, radius_mm in mm", header_);
  }

  void fill_in() {
    const double speed = run_.feed / run_.radius;  // rad/s
    if (run_.time.empty()) {
      // the run starts at angle 0
      const double first = std::remainder(run_.angle.front(), kTurn) * run_.turn();
      for (const double swept : swept_) run_.time.push_back((std::max(first, 0.0) + swept) / speed);
    }
    measured_angles_ = !run_.angle.empty();
    if (!measured_angles_) {
      for (const double time : run_.time) run_.angle.push_back(run_.turn() * speed * time);
    }
  }

  // How much of the circle the samples cover, by their angles or by time and feed.
  void check_turn() const {
    const double turns = std::abs(measured_angles_ ? swept_.back() : run_.angle.back() - run_.angle.front()) / kTurn;
    if (turns < options_.least_turns) {
      refuse("table-too-few", fmt::format("the samples cover {:.3g} deg of the circle", turns * kTurn / kDeg),
             fmt::format("a run is one turn, or at least {:.3g} deg of it; check the units of time_s, angle_deg and "
                         "feed_mm_min",
                         options_.least_turns * kTurn / kDeg),
             header_);
    }
    if (measured_angles_ || turns <= options_.most_turns_by_time) return;
    refuse("table-time", fmt::format("at {:.4g} mm/min the times go {:.3g} times around", run_.feed / kMmPerMin, turns),
           "a run is one turn: make each turn a run; check that time_s is in seconds and feed_mm_min right",
           places_.back());
  }

  std::string text_;
  CsvLines lines_;
  Run& run_;
  const TableOptions& options_;
  Place header_;
  Place first_left_out_;
  std::vector<Place> places_;  // of the rows
  std::vector<double> swept_;  // angle from the first sample, rad
  bool measured_angles_ = false;
};

}  // namespace

bool has_column(const Run& run, Column column) {
  return std::any_of(run.columns.begin(), run.columns.end(),
                     [&](const TableColumn& there) { return there.column == column; });
}

void read_run_table(const std::string& path, Run& run, const TableOptions& options) {
  TableReader(path, run, options).read();
}

std::string run_table_text(const Run& run) {
  std::string text;
  for (const TableColumn& column : run.columns) {
    text += fmt::format("{}{}", text.empty() ? "" : ",", spec_of(column.column).name);
  }
  text += '\n';
  for (std::size_t i = 0; i < run.samples(); ++i) {
    std::string_view comma;
    for (const TableColumn& column : run.columns) {
      const int least = column.column >= Column::torque1 ? 5 : column.column == Column::radial ? 4 : 0;
      const double value = values_of(run, column.column)[i] / spec_of(column.column).si;
      text += fmt::format("{}{:.{}f}", comma, value, std::max(column.decimals, least));
      comma = ",";
    }
    text += '\n';
  }
  return text;
}

}  // namespace plumbline::measure
