#include <memory>
#include <string>

#include "base/files/files.hpp"
#include "cli/command.hpp"
#include "cli/command_files.hpp"
#include "cli/messages.hpp"
#include "cli/options/report_file.hpp"
#include "cli/progress_line.hpp"
#include "cli/shared_options.hpp"
#include "machine/model_file.hpp"
#include "report/page/program_pages.hpp"
#include "report/program/simulation_text.hpp"

namespace plumbline::cli {
namespace {

struct SimulateArguments {
  std::string program, dataset, report;
  std::string output = std::string(kStandardStream);
  SharedOptions shared;
};

int simulate_dataset(const SimulateArguments& arguments) {
  if (!arguments.program.empty()) throw UsageError("either PROGRAM or -d DATASET, not both");
  if (!arguments.report.empty()) throw UsageError("--report draws a PROGRAM; readings are drawn by compare --report");
  if (arguments.output == kStandardStream) throw UsageError("-o DIR is required: the folder for the dataset");
  arguments.shared.allow_model_alone("a dataset says all of a circular test");
  const settings::Options options = arguments.shared.read(arguments.dataset);
  require_model(options);
  const jobs::DatasetSimulationSummary summary =
      jobs::simulate_dataset(options.paths.model, arguments.dataset, arguments.output);
  say_note(report::dataset_simulation_text(summary));
  return kDone;
}

int simulate(const SimulateArguments& arguments) {
  if (!arguments.dataset.empty()) return simulate_dataset(arguments);
  if (arguments.program.empty()) throw UsageError("PROGRAM is required: the NC program to be played, or -d DATASET");
  const settings::Options options = arguments.shared.read(arguments.program);
  require_model(options);
  check_outputs(files_read(arguments.program, options), {arguments.output, arguments.report});
  OutputFile out(arguments.output);
  ReportFile page(arguments.report);
  const jobs::Knowledge known = jobs::knowledge_of(machine::read_model(options.paths.model));
  if (known.warning) say(*known.warning);
  report::SimulationTable table(out, known.posterior.has_value());
  ProgressLine line("simulate");
  jobs::ProgramPicture picture;
  const jobs::SimulationSummary summary = jobs::simulate_program(
      arguments.program, options, [&](const jobs::SimulatedPoint& point) { table.add(point); }, line.progress(),
      arguments.report.empty() ? nullptr : &picture, known.posterior_or_null());
  line.clear();
  OutputSet files;
  page.add_to(files, [&] { return report::simulation_page(summary, picture, arguments.program); });
  files.add(out);
  files.commit();
  if (summary.first_beyond) say(*summary.first_beyond);
  say_note(report::simulation_text(summary));
  return kDone;
}

}  // namespace

void add_simulate(CLI::App& app, Run& run) {
  CLI::App* const command = app.add_subcommand(
      "simulate",
      "Play a program, as it stands, on the model: path, error of the tool tip, struts, forces, torques; or the "
      "circular tests of a dataset: readings of bar and motors");
  const auto arguments = std::make_shared<SimulateArguments>();
  command->add_option("PROGRAM", arguments->program, "the NC program; - for standard input")->type_name("FILE");
  command
      ->add_option("-d,--dataset", arguments->dataset,
                   "a dataset.toml instead of a program: writes the same dataset, simulated, into the folder -o")
      ->type_name("DATASET");
  command
      ->add_option("-o,--output", arguments->output,
                   "CSV: line, motion, time (s), pose (mm, deg), error of the tip (um) and of the orientation (urad), "
                   "strut lengths (mm), nut tensions (N), motor torques (N m), if the model says how sure its numbers "
                   "are how far the tip may be from "
                   "there (um, 95 %); default standard output")
      ->type_name("FILE");
  add_report_option(*command, arguments->report);
  using Group = settings::OptionGroup;
  arguments->shared.add_to(*command, {Group::model, Group::program, Group::step});
  command->callback([arguments, &run] { run = [arguments] { return simulate(*arguments); }; });
}

}  // namespace plumbline::cli
