#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "base/diagnostic.hpp"
#include "cli/command.hpp"
#include "cli/command_files.hpp"
#include "cli/messages.hpp"
#include "cli/options/number_check.hpp"
#include "cli/options/report_file.hpp"
#include "cli/options/with.hpp"
#include "jobs/compare.hpp"
#include "jobs/measured/joined.hpp"
#include "report/measured/compare_text.hpp"
#include "report/measured/inspection_text.hpp"
#include "report/page/compare_page.hpp"
#include "report/page/paper_sections.hpp"

namespace plumbline::cli {
namespace {

struct CompareArguments {
  std::string model, beside, dataset, json, report;
  std::vector<std::string> with;
  double most_radial_um = std::numeric_limits<double>::infinity();
};

// Two models beside each other: the words of each under its name.
std::string words_of(const std::vector<jobs::Comparison>& comparisons, const std::vector<std::string>& models) {
  if (comparisons.size() == 1) return report::compare_text(comparisons[0]);
  std::string text;
  for (std::size_t i = 0; i < comparisons.size(); ++i) {
    text += (i > 0 ? "\n" : "") + models[i] + "\n" + report::compare_text(comparisons[i]);
  }
  return text;
}

int compare(const CompareArguments& arguments) {
  check_outputs(inputs_of(arguments.dataset, {arguments.model, arguments.beside}, arguments.with),
                {arguments.json, arguments.report});
  JsonResult json(arguments.json);
  ReportFile page(arguments.report);
  std::vector<std::string> models{arguments.model};
  if (!arguments.beside.empty()) models.push_back(arguments.beside);
  const measure::Dataset measured = jobs::read_joined(arguments.dataset, arguments.with).dataset;
  std::vector<jobs::Comparison> comparisons;
  for (const std::string& model : models) comparisons.push_back(jobs::compare(model, measured));
  for (const jobs::Comparison& comparison : comparisons) {
    if (comparison.other_model) say(*comparison.other_model);
  }
  const bool is_bounded = std::isfinite(arguments.most_radial_um);
  if (is_bounded && !comparisons[0].radial_rms_um) {
    refuse("compare-no-bar", "--max-radial-um bounds readings of the bar, and no run has any",
           "leave it out, or measure radial_um", Place{.file = arguments.dataset});
  }
  OutputSet files;
  json.add_to(files, comparisons.size() > 1 ? report::compare_json(comparisons[0], comparisons[1], models[1])
                                            : report::compare_json(comparisons[0]));
  page.add_to(files, [&] {
    report::Page made = report::compare_page(comparisons, jobs::profiles_of_files(measured.runs, models));
    report::add_paper(made, jobs::paper_of(arguments.dataset, models, arguments.with));
    return made;
  });
  if (!json.takes_standard_output() && !page.takes_standard_output()) print_result(words_of(comparisons, models));
  files.commit();
  if (const inspect::Inspection& inspection = comparisons[0].inspection; !inspection.faults.empty()) {
    say_note(report::faults_text(inspection, measured.runs));
  }
  return comparisons[0].radial_rms_um.value_or(0) <= arguments.most_radial_um ? kDone : kFound;
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
  add_with(*command, arguments->with);
  command->add_option("--beside", arguments->beside, "another model, compared with the same measurements")
      ->type_name("MODEL2");
  command->add_option("--json", arguments->json, "write the result as JSON, too")->type_name("FILE");
  add_report_option(*command, arguments->report);
  command
      ->add_option("--max-radial-um", arguments->most_radial_um,
                   "exit code 3 if the rms of all bar readings with MODEL is above that")
      ->type_name("UM")
      ->check(number_from_zero());
  command->callback([arguments, &run] { run = [arguments] { return compare(*arguments); }; });
}

}  // namespace plumbline::cli
