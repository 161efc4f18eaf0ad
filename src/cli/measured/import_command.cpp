#include <memory>
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "cli/command_files.hpp"
#include "cli/messages.hpp"
#include "imported/import.hpp"
#include "report/measured/import_text.hpp"

namespace plumbline::cli {
namespace {

struct ImportArguments {
  std::vector<std::string> files;
  std::string map, folder, example;
  bool explain = false;
};

int import_files(const ImportArguments& arguments) {
  if (!arguments.example.empty()) {
    print_result(imported::example_map(arguments.example));
    return kDone;
  }
  if (arguments.files.empty() || arguments.map.empty()) {
    throw UsageError("FILE... and --map MAP.toml are needed; --example-map general prints a map to start from");
  }
  if (arguments.folder.empty() && !arguments.explain) {
    throw UsageError("-o DIR is needed for the dataset, or --explain to see what would be taken for what");
  }
  const imported::Map map = imported::read_map(arguments.map);
  const imported::Imported made = imported::import_files(map, arguments.files);
  if (!arguments.folder.empty()) measure::write_dataset(made.dataset, arguments.folder, measure::Readings::measured);
  print_result(report::import_text(made, arguments.explain));
  return kDone;
}

}  // namespace

void add_import(CLI::App& app, Run& run) {
  CLI::App* const command = app.add_subcommand(
      "import", "Make a dataset of files that an instrument or a control wrote, by a map of their columns");
  const auto arguments = std::make_shared<ImportArguments>();
  command->add_option("files", arguments->files, "the files, as the map names them")->type_name("FILE...");
  command->add_option("--map", arguments->map, "how the files are written, and which circles they hold")
      ->type_name("MAP.toml");
  command->add_option("-o,--output", arguments->folder, "folder for dataset.toml and the table of each run")
      ->type_name("DIR");
  command->add_flag("--explain", arguments->explain,
                    "say in full what was taken for what; without -o nothing is written");
  command
      ->add_option("--example-map", arguments->example,
                   "print a map to start from, with comments: general, or linuxcnc-halsampler")
      ->type_name("NAME");
  command->callback([arguments, &run] { run = [arguments] { return import_files(*arguments); }; });
}

}  // namespace plumbline::cli
