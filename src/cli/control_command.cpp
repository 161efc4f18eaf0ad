#include <memory>

#include <fmt/format.h>

#include "cli/command.hpp"
#include "cli/messages.hpp"
#include "cli/options/number_check.hpp"
#include "cli/shared_options.hpp"
#include "jobs/linuxcnc_control.hpp"

namespace plumbline::cli {
namespace {

struct ControlArguments {
  std::string control, folder;
  jobs::SimulatedDrives drives;
  SharedOptions shared;
};

int control(const ControlArguments& arguments) {
  const settings::Options options = arguments.shared.given();
  require_model(options);
  jobs::write_linuxcnc_control(options, arguments.drives, arguments.folder);
  say_note(fmt::format("to see the machine move: linuxcnc {}/hexapod.ini\n", arguments.folder));
  return kDone;
}

}  // namespace

void add_control(CLI::App& app, Run& run) {
  CLI::App* const command = app.add_subcommand(
      "control", "Write the configuration of a control that simulates the machine, so that a program can be run on it");
  const auto arguments = std::make_shared<ControlArguments>();
  command->add_option("CONTROL", arguments->control, "linuxcnc: version 2.9, with its kinematics genhexkins")
      ->type_name("NAME")
      ->required()
      ->check(CLI::IsMember({"linuxcnc"}));
  command->add_option("-o,--output", arguments->folder, "write hexapod.ini and what belongs to it into this folder")
      ->type_name("DIR")
      ->required();
  command
      ->add_option("--speed", arguments->drives.speed_mm_min,
                   "fastest speed of the tip, and of a rapid; a degree counts as a millimetre")
      ->type_name("MM/MIN")
      ->check(number_between(1, 1e6))
      ->capture_default_str();
  command->add_option("--acceleration", arguments->drives.acceleration_mm_s2, "largest acceleration of an axis, mm/s^2")
      ->type_name("MM/S2")
      ->check(number_between(1, 1e6))
      ->capture_default_str();
  arguments->shared.add_named(*command, {"model", "tools", "work-offset", "variables"});
  command->callback([arguments, &run] { run = [arguments] { return control(*arguments); }; });
}

}  // namespace plumbline::cli
