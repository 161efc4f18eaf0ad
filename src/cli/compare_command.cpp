#include <cmath>
#include <limits>
#include <memory>

#include "base/diagnostic.hpp"
#include "cli/command.hpp"
#include "cli/command_files.hpp"
#include "jobs/compare.hpp"
#include "report/measured/compare_text.hpp"

namespace plumbline::cli {
namespace {

struct CompareArguments {
  std::string model, dataset, json;
  double most_radial_um = std::numeric_limits<double>::infinity();
};

int compare(const CompareArguments& arguments) {
  check_outputs(inputs_of(arguments.dataset, {arguments.model}), {arguments.json});
  JsonResult json(arguments.json);
  const jobs::Comparison comparison = jobs::compare(arguments.model, measure::read_dataset(arguments.dataset));
  const bool is_bounded = std::isfinite(arguments.most_radial_um);
  if (is_bounded && !comparison.radial_rms_um) {
    refuse("compare-no-bar", "--max-radial-um bounds readings of the bar, and no run has any",
           "leave it out, or measure radial_um", Place{.file = arguments.dataset});
  }
  json.give(report::compare_text(comparison), report::compare_json(comparison));
  return comparison.radial_rms_um.value_or(0) <= arguments.most_radial_um ? kDone : kFound;
}

}  // namespace

void add_compare(CLI::App& app, Run& run) {
  CLI::App* const command = app.add_subcommand(
      "compare", "Compare a model with measurements: simulated and measured readings, the set-up fitted per run");
  const auto arguments = std::make_shared<CompareArguments>();
  command->add_option("-m,--model", arguments->model, "the machine's model file")->type_name("MODEL")->required();
  command->add_option("-d,--dataset", arguments->dataset, "the measurements: a dataset.toml")
      ->type_name("DATASET")
      ->required();
  command->add_option("--json", arguments->json, "write the result as JSON, too")->type_name("FILE");
  command
      ->add_option("--max-radial-um", arguments->most_radial_um,
                   "exit code 3 if the rms of all bar readings is above that")
      ->type_name("UM")
      ->check(CLI::NonNegativeNumber);
  command->callback([arguments, &run] { run = [arguments] { return compare(*arguments); }; });
}

}  // namespace plumbline::cli
