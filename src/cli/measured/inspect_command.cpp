#include <memory>
#include <string>

#include "cli/command.hpp"
#include "cli/command_files.hpp"
#include "cli/messages.hpp"
#include "cli/options/report_file.hpp"
#include "cli/options/with.hpp"
#include "jobs/measured/inspect.hpp"
#include "jobs/measured/paper.hpp"
#include "report/measured/datasets_text.hpp"
#include "report/measured/inspection_text.hpp"
#include "report/page/inspection_page.hpp"
#include "report/page/paper_sections.hpp"

namespace plumbline::cli {
namespace {

struct InspectArguments {
  jobs::InspectJob job;
  std::string json, report;
};

int inspect(const InspectArguments& arguments) {
  check_outputs(inputs_of(arguments.job.dataset, {arguments.job.model}, arguments.job.with),
                {arguments.json, arguments.report});
  JsonResult json(arguments.json);
  ReportFile page(arguments.report);
  const jobs::InspectResult result = jobs::inspect(arguments.job);
  if (result.other_model) say(*result.other_model);
  OutputSet files;
  json.add_to(files, report::inspection_json(result.inspection, result.runs));
  page.add_to(files, [&] {
    report::Page made = report::inspection_page(result);
    report::add_paper(made, jobs::paper_of(arguments.job.dataset, {arguments.job.model}, arguments.job.with));
    return made;
  });
  const bool blocks = result.inspection.blocks();
  if (!json.takes_standard_output() && !page.takes_standard_output()) {
    const std::string words = report::inspection_text(result.inspection, result.runs, result.with_model) +
                              report::renamed_text(result.measured);
    print_result(words, {std::string_view(words).substr(0, words.find('\n')), blocks ? Verdict::bad : Verdict::good});
  }
  files.commit();
  return blocks ? kFound : kDone;
}

}  // namespace

void add_inspect(CLI::App& app, Run& run) {
  CLI::App* const command = app.add_subcommand(
      "inspect",
      "Judge measurements before anything is learnt from them: runs that do not fit the others, and what "
      "would mend them");
  const auto arguments = std::make_shared<InspectArguments>();
  command->add_option("-d,--dataset", arguments->job.dataset, "the measurements: a dataset.toml")
      ->type_name("DATASET")
      ->required();
  add_with(*command, arguments->job.with);
  command
      ->add_option("-m,--model", arguments->job.model,
                   "the machine's model file; without it the records alone are looked at")
      ->type_name("MODEL");
  command->add_option("--json", arguments->json, "write the result as JSON, too")->type_name("FILE");
  add_report_option(*command, arguments->report);
  command->callback([arguments, &run] { run = [arguments] { return inspect(*arguments); }; });
}

}  // namespace plumbline::cli
