#include <memory>

#include "base/files/files.hpp"
#include "cli/command.hpp"
#include "cli/command_files.hpp"
#include "cli/messages.hpp"
#include "machine/model_file.hpp"
#include "report/program/error_text.hpp"

namespace plumbline::cli {
namespace {

struct ErrorArguments {
  std::string poses, model;
  std::string output = std::string(kStandardStream);
};

int error(const ErrorArguments& arguments) {
  check_outputs({arguments.poses, arguments.model}, {arguments.output});
  const machine::MachineModel model = machine::read_model(arguments.model);
  const std::vector<jobs::PoseRow> poses = jobs::read_poses(arguments.poses);
  OutputFile out(arguments.output);
  const jobs::Knowledge known = jobs::knowledge_of(model);
  if (known.warning) say(*known.warning);
  report::ErrorTable table(out, known.posterior.has_value());
  const jobs::ErrorTableSummary summary = jobs::error_table(
      model, poses, [&](const jobs::PoseError& error) { table.add(error); }, known.posterior_or_null());
  out.commit();
  if (summary.first_beyond) say(*summary.first_beyond);
  say_note(report::error_text(summary));
  return kDone;
}

}  // namespace

void add_error(CLI::App& app, Run& run) {
  CLI::App* const command =
      app.add_subcommand("error", "Tabulate strut lengths, forces and the error of the tool tip, the machine at rest");
  const auto arguments = std::make_shared<ErrorArguments>();
  command
      ->add_option("POSES", arguments->poses,
                   "CSV with the columns x_mm,y_mm,z_mm,a_deg,b_deg,c_deg: poses of the tool tip in W; - for "
                   "standard input")
      ->type_name("FILE")
      ->required();
  command->add_option("-m,--model", arguments->model, "the machine's model file")->type_name("MODEL")->required();
  command
      ->add_option("-o,--output", arguments->output,
                   "CSV: pose (mm, deg), strut lengths (mm), nut tensions (N), stretches (um), error of the tip (um) "
                   "and of the orientation (urad), in W; if the model says how sure its numbers are, how far the tip "
                   "may be from there (um, 95 %); "
                   "default standard output")
      ->type_name("FILE");
  command->callback([arguments, &run] { run = [arguments] { return error(*arguments); }; });
}

}  // namespace plumbline::cli
