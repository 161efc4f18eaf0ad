#include <memory>

#include "cli/command.hpp"
#include "cli/command_files.hpp"
#include "cli/messages.hpp"
#include "cli/options/report_file.hpp"
#include "cli/progress_line.hpp"
#include "cli/shared_options.hpp"
#include "jobs/check.hpp"
#include "report/page/program_pages.hpp"
#include "report/program/check_text.hpp"

namespace plumbline::cli {
namespace {

struct CheckArguments {
  std::string program, json, report;
  SharedOptions shared;
};

int check(const CheckArguments& arguments) {
  const settings::Options options = arguments.shared.read(arguments.program);
  require_model(options);
  check_outputs(files_read(arguments.program, options), {arguments.json, arguments.report});
  JsonResult json(arguments.json);
  ReportFile page(arguments.report);
  ProgressLine line("check");
  jobs::ProgramPicture picture;
  const jobs::CheckSummary summary =
      jobs::check_file(arguments.program, options, line.progress(), !arguments.report.empty() ? &picture : nullptr);
  line.clear();
  if (summary.expected.warning) say(*summary.expected.warning);
  if (summary.refusal) {
    Diagnostic warning = *summary.refusal;
    warning.severity = Severity::warning;
    warning.message = "compensate would refuse this: " + warning.message;
    say(warning);
  }
  const bool all_kept = summary.violations == 0;
  OutputSet files;
  json.add_to(files, report::check_json(summary));
  page.add_to(files, [&] { return report::check_page(summary, picture, arguments.program); });
  if (!json.takes_standard_output() && !page.takes_standard_output()) {
    print_result(report::check_text(summary),
                 {all_kept ? "all kept" : "beyond its limit in", all_kept ? Verdict::good : Verdict::bad});
  }
  files.commit();
  return all_kept ? kDone : kFound;
}

}  // namespace

void add_check(CLI::App& app, Run& run) {
  CLI::App* const command =
      app.add_subcommand("check",
                         "Check a program, as it would be compensated, against the limits of the machine; exit "
                         "code 3 if it breaks one");
  const auto arguments = std::make_shared<CheckArguments>();
  command->add_option("PROGRAM", arguments->program, "the NC program; - for standard input")
      ->type_name("FILE")
      ->required();
  command->add_option("--json", arguments->json, "write the result as JSON, too")->type_name("FILE");
  add_report_option(*command, arguments->report);
  using Group = settings::OptionGroup;
  arguments->shared.add_to(*command, {Group::model, Group::program, Group::step, Group::bound});
  command->callback([arguments, &run] { run = [arguments] { return check(*arguments); }; });
}

}  // namespace plumbline::cli
