#include <memory>

#include "cli/command.hpp"
#include "cli/command_files.hpp"
#include "jobs/circularity.hpp"
#include "report/measured/circularity_text.hpp"

namespace plumbline::cli {
namespace {

struct CircularityArguments {
  std::string dataset, json;
};

int circularity(const CircularityArguments& arguments) {
  check_outputs(inputs_of(arguments.dataset, {}), {arguments.json});
  JsonResult json(arguments.json);
  const jobs::CircularityTable table = jobs::circularity_table(measure::read_dataset(arguments.dataset));
  json.give(report::circularity_text(table), report::circularity_json(table));
  return kDone;
}

}  // namespace

void add_circularity(CLI::App& app, Run& run) {
  CLI::App* const command = app.add_subcommand(
      "circularity", "Tabulate the figures of ISO 230-4 of measured circular tests: circularity, G, F, G(b), D");
  const auto arguments = std::make_shared<CircularityArguments>();
  command->add_option("-d,--dataset", arguments->dataset, "the measurements: a dataset.toml")
      ->type_name("DATASET")
      ->required();
  command->add_option("--json", arguments->json, "write the result as JSON, too")->type_name("FILE");
  command->callback([arguments, &run] { run = [arguments] { return circularity(*arguments); }; });
}

}  // namespace plumbline::cli
