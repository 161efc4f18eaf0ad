#include <memory>

#include "base/units.hpp"
#include "cli/command_files.hpp"
#include "cli/identified_output.hpp"
#include "cli/options/accept.hpp"
#include "cli/options/number_check.hpp"
#include "cli/options/with.hpp"

namespace plumbline::cli {
namespace {

struct CalibrateArguments {
  jobs::CalibrateJob job;
  std::string model, poses;
  IdentifiedOutput output;
  double joint_um = 1000;
  double offset_um = 1000;
};

int calibrate(const CalibrateArguments& arguments) {
  jobs::CalibrateJob job = arguments.job;
  job.model = arguments.model;
  job.poses = arguments.poses;
  if (job.dataset.empty() && job.poses.empty()) {
    throw UsageError("-d DATASET or --poses TABLE is required: circular tests, a tracker's poses, or both");
  }
  job.options.geometry.joint_sigma = arguments.joint_um * kUm;
  job.options.geometry.offset_sigma = arguments.offset_um * kUm;
  return write_identified(inputs_of(job.dataset, {arguments.model, arguments.poses}, job.with), arguments.output,
                          [&] { return jobs::calibrate_model(job); });
}

void add_measurements(CLI::App& command, CalibrateArguments& arguments) {
  command.add_option("-m,--model", arguments.model, "the machine's model file")->type_name("MODEL")->required();
  command.add_option("-d,--dataset", arguments.job.dataset, "circular tests: a dataset.toml")->type_name("DATASET");
  add_with(command, arguments.job.with);
  command
      .add_option("--poses", arguments.poses,
                  "poses that a tracker measured: CSV, x_mm,y_mm,z_mm,a_deg,b_deg,c_deg as commanded, then "
                  "measured_x_mm, ..., where they are there measured_a_deg, ... and payload_kg")
      ->type_name("TABLE");
  command.add_flag("--frame-known", arguments.job.frame_known,
                   "the tracker measures in the machine's base frame W; else its frame is fitted");
}

void add_unknowns(CLI::App& command, CalibrateArguments& arguments) {
  command.add_flag("--geometry-alone", arguments.job.options.geometry.alone,
                   "move joints and strut offsets alone; else all that [uncertainty] lists is fitted with them");
  command
      .add_option("--free", arguments.job.options.free,
                  "fit these keys, too, without a prior: table.key of the model file, or effect.key")
      ->type_name("KEY,...")
      ->delimiter(',');
  command
      .add_option("--joint-sigma", arguments.joint_um,
                  "1 sigma of a joint's coordinate, um, if [uncertainty] does not list joint_position_um")
      ->type_name("UM")
      ->check(number_above_zero())
      ->capture_default_str();
  command
      .add_option("--offset-sigma", arguments.offset_um,
                  "1 sigma of a strut's length, um, if [uncertainty] does not list strut_offset_um")
      ->type_name("UM")
      ->check(number_above_zero())
      ->capture_default_str();
}

}  // namespace

void add_calibrate(CLI::App& app, Run& run) {
  CLI::App* const command = app.add_subcommand(
      "calibrate", "Find where the joints are and how long the struts, from circular tests or a tracker's poses");
  const auto arguments = std::make_shared<CalibrateArguments>();
  add_measurements(*command, *arguments);
  add_identified_output(*command, arguments->output);
  add_unknowns(*command, *arguments);
  add_accept(*command, arguments->job.accepted);
  command->add_flag("--controller", arguments->job.controller,
                    "write the joints as new coordinates for the controller, not as what it has wrong");
  command->callback([arguments, &run] { run = [arguments] { return calibrate(*arguments); }; });
}

}  // namespace plumbline::cli
