// What is said of a machine: at poses, along a program; and what codes mean.
#include <plumbline/plumbline.hpp>

#include "api/files_of_call.hpp"
#include "api/given_options.hpp"
#include "api/guarded.hpp"
#include "api/inside.hpp"
#include "base/units.hpp"
#include "base/version.hpp"
#include "jobs/error_table.hpp"
#include "jobs/simulate.hpp"
#include "machine/model_file.hpp"
#include "report/explain.hpp"
#include "report/program/error_text.hpp"
#include "report/program/expected_text.hpp"
#include "report/program/simulation_text.hpp"

namespace plumbline::api {
namespace {

using Group = settings::OptionGroup;

std::vector<std::string> names_between_commas(std::string_view text) {
  std::vector<std::string> names;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(',', at), text.size());
    names.emplace_back(text.substr(at, end - at));
    at = end + 1;
  }
  return names;
}

template <class Numbers>
void append(std::vector<double>& row, const Numbers& numbers, double unit) {
  for (const double number : numbers) row.push_back(number / unit);
}

double number_of(nc::MotionKind kind) {
  return kind == nc::MotionKind::rapid ? 0 : kind == nc::MotionKind::arc ? 2 : 1;
}

void add_warning(std::vector<Diagnostic>& warnings, const std::optional<plumbline::Diagnostic>& warning) {
  if (warning) warnings.push_back(public_diagnostic(*warning));
}

void append_expected(Table& table, const std::optional<jobs::PoseDoubt>& doubt) {
  const std::vector<double> numbers = report::expected_numbers(doubt);
  table.values.insert(table.values.end(), numbers.begin(), numbers.end());
}

// Names of its columns, and of what is expected besides where something is known of that.
Table table_of(std::string_view columns, const jobs::Knowledge& known) {
  std::string names(columns);
  if (known.posterior) names += report::expected_columns();
  return {names_between_commas(names), {}};
}

void add_row(Table& table, const jobs::SimulatedPoint& point) {
  std::vector<double>& row = table.values;
  append(row, std::array{static_cast<double>(point.line), number_of(point.motion), point.time_s}, 1);
  for (const Axis axis : kAllAxes) row.push_back(point.pose[axis]);
  append(row, point.error.head<3>(), kUm);
  append(row, point.error.tail<3>(), kUrad);
  append(row, point.lengths, kMm);
  append(row, point.nut_tension, 1);
  append(row, point.torque, 1);
}

void add_row(Table& table, const jobs::PoseError& error) {
  std::vector<double>& row = table.values;
  for (const Axis axis : kAllAxes) row.push_back(error.pose[axis]);
  append(row, error.lengths, kMm);
  append(row, error.nut_tension, 1);
  append(row, error.stretch, kUm);
  append(row, error.error.head<3>(), kUm);
  append(row, error.error.tail<3>(), kUrad);
}

std::vector<jobs::PoseRow> rows_of(const std::vector<Pose>& poses) {
  std::vector<jobs::PoseRow> rows;
  rows.reserve(poses.size());
  for (const Pose& pose : poses) {
    const AxisWords words{{pose.x_mm, pose.y_mm, pose.z_mm, pose.a_deg, pose.b_deg, pose.c_deg}};
    rows.push_back({words, plumbline::Place{.file = "<poses>", .line = rows.size() + 1, .column = 1}});
  }
  return rows;
}

}  // namespace

inline namespace v1 {

std::string version() { return std::string(plumbline::version()); }

Result simulate(const Input& program, const Model& model, const Options& options, const Output& output,
                const Progress& progress) {
  return guarded([&] {
    const GivenOptions given(options, {Group::program, Group::step});
    const settings::Options how = given.machine_options(model);
    const Destination to = Inside::destination(output);
    refuse_shared_files(files_read(program, how), files_written({to}));
    OutputFile out(to);
    const jobs::Knowledge known = jobs::knowledge_of(machine::read_model(how.paths.model));
    report::SimulationTable table(out, known.posterior.has_value());
    const jobs::SimulationSummary summary = jobs::simulate_program(
        Inside::source(program), how, [&](const jobs::SimulatedPoint& point) { table.add(point); }, progress, nullptr,
        known.posterior_or_null());
    out.commit();
    Inside::Found found;
    add_warning(found.warnings, known.warning);
    add_warning(found.warnings, summary.first_beyond);
    found.json = report::simulation_json(summary);
    found.words = report::simulation_text(summary);
    return Inside::result(std::move(found));
  });
}

Table simulate(const Input& program, const Model& model, const Options& options, const Progress& progress) {
  return guarded([&] {
    const GivenOptions given(options, {Group::program, Group::step});
    const settings::Options how = given.machine_options(model);
    const jobs::Knowledge known = jobs::knowledge_of(machine::read_model(how.paths.model));
    Table table = table_of(report::simulation_columns(), known);
    const jobs::SimulationSummary summary = jobs::simulate_program(
        Inside::source(program), how,
        [&](const jobs::SimulatedPoint& point) {
          add_row(table, point);
          if (known.posterior) append_expected(table, point.doubt);
        },
        progress, nullptr, known.posterior_or_null());
    add_warning(table.warnings, known.warning);
    add_warning(table.warnings, summary.first_beyond);
    return table;
  });
}

Result error(const Input& poses, const Model& model, const Output& output) {
  return guarded([&] {
    const machine::MachineModel& machine = Inside::machine_of(model).machine;
    const Source source = Inside::source(poses);
    const Destination to = Inside::destination(output);
    refuse_shared_files(file_names({source}), files_written({to}));
    const std::vector<jobs::PoseRow> rows = jobs::read_poses(source);
    OutputFile out(to);
    const jobs::Knowledge known = jobs::knowledge_of(machine);
    report::ErrorTable table(out, known.posterior.has_value());
    const jobs::ErrorTableSummary summary = jobs::error_table(
        machine, rows, [&](const jobs::PoseError& error) { table.add(error); }, known.posterior_or_null());
    out.commit();
    Inside::Found found;
    add_warning(found.warnings, known.warning);
    add_warning(found.warnings, summary.first_beyond);
    found.json = report::error_json(summary);
    found.words = report::error_text(summary);
    return Inside::result(std::move(found));
  });
}

Table error(const std::vector<Pose>& poses, const Model& model) {
  return guarded([&] {
    const machine::MachineModel& machine = Inside::machine_of(model).machine;
    const jobs::Knowledge known = jobs::knowledge_of(machine);
    Table table = table_of(report::error_columns(), known);
    table.values.reserve(poses.size() * table.columns.size());
    const jobs::ErrorTableSummary summary = jobs::error_table(
        machine, rows_of(poses),
        [&](const jobs::PoseError& error) {
          add_row(table, error);
          if (known.posterior) append_expected(table, error.doubt);
        },
        known.posterior_or_null());
    add_warning(table.warnings, known.warning);
    add_warning(table.warnings, summary.first_beyond);
    return table;
  });
}

std::string explain(std::string_view code) {
  return guarded([&] { return report::explain_text(code); });
}

std::string explain() {
  return guarded([] { return report::explain_list(); });
}

}  // namespace v1
}  // namespace plumbline::api
