#include <filesystem>
#include <memory>

#include <fmt/format.h>

#include "base/diagnostic.hpp"
#include "base/files/files.hpp"
#include "base/files/path_of.hpp"
#include "cli/command.hpp"
#include "cli/command_files.hpp"
#include "jobs/compensate/compensated_files.hpp"
#include "nc/rewrite/output/undo.hpp"

namespace plumbline::cli {
namespace {

struct RestoreArguments {
  std::string program, undo, output;
};

// Nobody named it: a pipe of that name may never give anything.
void refuse_no_file(const std::string& undo) {
  std::error_code none;
  const std::filesystem::file_status status = std::filesystem::status(path_of(undo), none);
  if (!std::filesystem::exists(status) || std::filesystem::is_regular_file(status)) return;
  refuse("undo-format", fmt::format("{} is a folder, a pipe or a device, and no undo file", undo),
         "name the undo file with --undo", {undo});
}

int restore(const RestoreArguments& arguments) {
  const std::string undo = arguments.undo.empty() ? jobs::undo_name(arguments.program) : arguments.undo;
  if (arguments.undo.empty()) refuse_no_file(undo);
  check_outputs({arguments.program, undo}, {arguments.output});
  OutputFile out(arguments.output);
  const auto [program, log] = jobs::open_pair(arguments.program, undo);
  nc::restore(program, log, out);
  program.check_unchanged();
  log.check_unchanged();
  out.commit();
  return kDone;
}

}  // namespace

void add_restore(CLI::App& app, Run& run) {
  CLI::App* const command =
      app.add_subcommand("restore", "Give back the original of a compensated program, byte for byte");
  const auto arguments = std::make_shared<RestoreArguments>();
  command->add_option("PROGRAM", arguments->program, "the compensated program")->type_name("FILE")->required();
  command->add_option("--undo", arguments->undo, "what compensate --undo wrote (default PROGRAM.undo)")
      ->type_name("FILE");
  command->add_option("-o,--output", arguments->output, "the original; - for standard output")
      ->type_name("FILE")
      ->required();
  command->callback([arguments, &run] { run = [arguments] { return restore(*arguments); }; });
}

}  // namespace plumbline::cli
