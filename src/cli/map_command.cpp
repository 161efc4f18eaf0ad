#include <cmath>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "base/files/files.hpp"
#include "base/units.hpp"
#include "cli/command.hpp"
#include "cli/command_files.hpp"
#include "cli/messages.hpp"
#include "cli/options/number_list.hpp"
#include "cli/progress_line.hpp"
#include "jobs/workspace_map.hpp"
#include "machine/model_file.hpp"
#include "report/page/map_page.hpp"
#include "report/program/map_text.hpp"

namespace plumbline::cli {
namespace {

// As the command line says it, in its units.
struct MapArguments {
  std::string model, output, report;
  std::vector<double> box_mm, planes_mm;
  std::optional<double> step_mm;
  std::vector<std::string> tilts;
};

AxisWords tilt_of(const std::string& text) {
  const std::vector<double> angles = numbers_between_commas(text, "--tilt " + text);
  if (angles.size() != 2 && angles.size() != 3)
    throw UsageError(fmt::format("--tilt {}: expected A,B or A,B,C in deg", text));
  for (const double angle : angles) {
    if (!(angle >= -360 && angle <= 360))
      throw UsageError(fmt::format("--tilt {}: expected angles within a turn", text));
  }
  AxisWords tilt;
  tilt[Axis::A] = angles[0];
  tilt[Axis::B] = angles[1];
  if (angles.size() == 3) tilt[Axis::C] = angles[2];
  return tilt;
}

jobs::MapOptions options_of(const MapArguments& arguments) {
  jobs::MapOptions options;
  for (const double x : arguments.box_mm) {
    if (!std::isfinite(x)) throw UsageError(fmt::format("--box: {} is no number", x));
  }
  for (const double z : arguments.planes_mm) {
    if (!std::isfinite(z)) throw UsageError(fmt::format("--z: {} is no number", z));
  }
  if (!arguments.box_mm.empty()) {
    if (arguments.box_mm.size() != 6)
      throw UsageError(
          fmt::format("--box: expected six numbers, from and to in X, Y, Z, not {}", arguments.box_mm.size()));
    for (std::size_t a = 0; a < 3; ++a)
      options.box[a] = machine::Range{arguments.box_mm[2 * a] * kMm, arguments.box_mm[2 * a + 1] * kMm};
  }
  if (arguments.step_mm) {
    if (!(*arguments.step_mm > 0)) throw UsageError("--step: expected a positive number of mm");
    options.step = *arguments.step_mm * kMm;
  }
  for (const double z : arguments.planes_mm) options.planes.push_back(z * kMm);
  if (!arguments.tilts.empty()) options.tilts.clear();
  for (const std::string& tilt : arguments.tilts) options.tilts.push_back(tilt_of(tilt));
  return options;
}

int map(const MapArguments& arguments) {
  const jobs::MapOptions options = options_of(arguments);
  // who asks for a page alone does not want the table on the terminal
  const bool has_table = !arguments.output.empty() || arguments.report.empty();
  const std::string output = arguments.output.empty() ? std::string(kStandardStream) : arguments.output;
  check_outputs({arguments.model}, {has_table ? output : "", arguments.report});
  const machine::MachineModel model = machine::read_model(arguments.model);
  std::optional<OutputFile> table_file, page_file;
  std::optional<report::MapTable> table;
  std::optional<report::MapPage> page;
  if (!arguments.report.empty()) {
    page.emplace(model, options);
    page_file.emplace(arguments.report);
  }
  if (has_table) table.emplace(table_file.emplace(output), jobs::knows_uncertainty(model));
  ProgressLine line("map");
  const auto take = [&](const jobs::MapCell& cell) {
    if (table) table->add(cell);
    if (page) page->add(cell);
  };
  const jobs::MapSummary summary = jobs::map_workspace(model, options, take, line.progress());
  line.clear();
  OutputSet files;
  if (table_file) files.add(*table_file);
  if (page_file) {
    report::write_page(page->page(summary), *page_file);
    files.add(*page_file);
  }
  files.commit();
  say_note(report::map_text(summary));
  return kDone;
}

}  // namespace

void add_map(CLI::App& app, Run& run) {
  CLI::App* const command = app.add_subcommand(
      "map",
      "Map where the machine is to be trusted: error, stiffness, condition, forces and uncertainty over its work");
  const auto arguments = std::make_shared<MapArguments>();
  command->add_option("-m,--model", arguments->model, "the machine's model file")->type_name("MODEL")->required();
  command
      ->add_option(
          "-o,--output", arguments->output,
          "CSV: pose (mm, deg), in reach or the limits that are broken, error of the tip (um), stiffness in the "
          "softest direction (N/um), condition number, largest force of a strut (N), uncertainty (um, 1 sigma) if "
          "the model has [uncertainty]; default standard output, if no page is asked for")
      ->type_name("FILE");
  command
      ->add_option("--report", arguments->report,
                   "write a page to look at it: each figure in colours, plane by plane, and its worst places")
      ->type_name("FILE");
  command
      ->add_option("--box", arguments->box_mm,
                   "from and to of the tool tip in X, Y and Z of W; default the model's travel")
      ->type_name("X,X,Y,Y,Z,Z")
      ->delimiter(',');
  command
      ->add_option("--step", arguments->step_mm,
                   "the most between two points; default a twentieth of the longest side of the box")
      ->type_name("MM");
  command->add_option("--z", arguments->planes_mm, "planes to map, in place of steps in Z")
      ->type_name("MM,...")
      ->delimiter(',');
  command->add_option("--tilt", arguments->tilts, "A,B or A,B,C to map at, once for each; default 0,0")
      ->type_name("DEG,DEG[,DEG]")
      ->expected(1)
      ->type_size(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command->footer("At rest, without friction, and as the model has it: nothing is corrected.");
  command->callback([arguments, &run] { run = [arguments] { return map(*arguments); }; });
}

}  // namespace plumbline::cli
