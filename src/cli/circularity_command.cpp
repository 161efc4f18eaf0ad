#include <memory>
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "cli/command_files.hpp"
#include "cli/options/report_file.hpp"
#include "jobs/circularity.hpp"
#include "report/measured/circularity_text.hpp"
#include "report/page/compare_page.hpp"
#include "report/page/paper_sections.hpp"

namespace plumbline::cli {
namespace {

struct CircularityArguments {
  std::string dataset, model, beside, json, report;
};

int circularity(const CircularityArguments& arguments) {
  if (!arguments.beside.empty() && arguments.model.empty()) throw UsageError("--beside MODEL2 needs -m MODEL");
  if (!arguments.model.empty() && arguments.report.empty()) {
    throw UsageError("-m MODEL needs --report FILE.html: the page shows what the model makes of the circles");
  }
  check_outputs(inputs_of(arguments.dataset, {arguments.model, arguments.beside}), {arguments.json, arguments.report});
  JsonResult json(arguments.json);
  ReportFile page(arguments.report);
  const measure::Dataset measured = measure::read_dataset(arguments.dataset);
  const jobs::CircularityTable table = jobs::circularity_table(measured);
  OutputSet files;
  json.add_to(files, report::circularity_json(table));
  page.add_to(files, [&] {
    std::vector<std::string> models;
    for (const std::string& model : {arguments.model, arguments.beside}) {
      if (!model.empty()) models.push_back(model);
    }
    report::Page made = report::circularity_page(table, jobs::profiles_of_files(measured.runs, models));
    report::add_paper(made, jobs::paper_of(arguments.dataset, models), false);
    return made;
  });
  if (!json.takes_standard_output() && !page.takes_standard_output()) print_result(report::circularity_text(table));
  files.commit();
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
  command->add_option("-m,--model", arguments->model, "for the page: what this model makes of the circles")
      ->type_name("MODEL");
  command->add_option("--beside", arguments->beside, "for the page: another model")->type_name("MODEL2");
  command->add_option("--json", arguments->json, "write the result as JSON, too")->type_name("FILE");
  add_report_option(*command, arguments->report);
  command->callback([arguments, &run] { run = [arguments] { return circularity(*arguments); }; });
}

}  // namespace plumbline::cli
