#include <memory>
#include <string>

#include <fmt/format.h>

#include "base/files/files.hpp"
#include "cli/command.hpp"
#include "cli/command_files.hpp"
#include "cli/messages.hpp"
#include "cli/progress_line.hpp"
#include "cli/shared_options.hpp"
#include "jobs/simulate.hpp"
#include "jobs/simulate_dataset.hpp"
#include "report/text_table.hpp"

namespace plumbline::cli {
namespace {

struct SimulateArguments {
  std::string program, dataset;
  std::string output = std::string(kStandardStream);
  SharedOptions shared;
};

int simulate_dataset(const SimulateArguments& arguments) {
  if (!arguments.program.empty()) throw UsageError("either PROGRAM or -d DATASET, not both");
  if (arguments.output == kStandardStream) throw UsageError("-o DIR is required: the folder for the dataset");
  arguments.shared.allow_model_alone("a dataset says all of a circular test");
  const settings::Options options = arguments.shared.read(arguments.dataset);
  require_model(options);
  const jobs::DatasetSimulationSummary summary =
      jobs::simulate_dataset(options.paths.model, arguments.dataset, arguments.output);
  say_note(
      fmt::format("{}, {}\n", report::count_text(summary.runs, "run"), report::count_text(summary.samples, "sample")));
  return kDone;
}

std::string words_of(const jobs::SimulationSummary& summary) {
  std::string words =
      fmt::format("{} in {}", report::count_text(summary.points, "point"), report::time_text(summary.seconds));
  if (summary.points > 0) {
    words += fmt::format(": the tip up to {:.3f} um off (line {}), rms {:.3f} um", summary.largest_um,
                         summary.largest_line, summary.rms_um);
  }
  words += '\n';
  if (summary.passed_moves > 0) {
    words += fmt::format("{} left out of the table: machine coordinates, probing, or from where nobody knows\n",
                         report::count_text(summary.passed_moves, "move"));
  }
  return words;
}

int simulate(const SimulateArguments& arguments) {
  if (!arguments.dataset.empty()) return simulate_dataset(arguments);
  if (arguments.program.empty()) throw UsageError("PROGRAM is required: the NC program to be played, or -d DATASET");
  const settings::Options options = arguments.shared.read(arguments.program);
  require_model(options);
  check_outputs(files_read(arguments.program, options), {arguments.output});
  OutputFile out(arguments.output);
  ProgressLine line;
  const jobs::SimulationSummary summary = jobs::simulate_program(arguments.program, options, out, line.progress());
  line.clear();
  out.commit();
  say_note(words_of(summary));
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
                   "strut lengths (mm), nut tensions (N), motor torques (N m); default standard output")
      ->type_name("FILE");
  using Group = settings::OptionGroup;
  arguments->shared.add_to(*command, {Group::model, Group::program, Group::step});
  command->callback([arguments, &run] { run = [arguments] { return simulate(*arguments); }; });
}

}  // namespace plumbline::cli
