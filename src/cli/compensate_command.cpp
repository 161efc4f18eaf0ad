#include <memory>

#include "base/files/files.hpp"
#include "cli/command.hpp"
#include "cli/command_files.hpp"
#include "cli/messages.hpp"
#include "cli/options/report_file.hpp"
#include "cli/progress_line.hpp"
#include "cli/shared_options.hpp"
#include "jobs/compensate/compensate_file.hpp"
#include "jobs/compensate/compensated_files.hpp"
#include "report/page/program_pages.hpp"
#include "report/program/summary_text.hpp"

namespace plumbline::cli {
namespace {

struct CompensateArguments {
  std::string program, output, json, report;
  SharedOptions shared;
};

std::vector<jobs::ReportFile> reports(const CompensateArguments& arguments, const settings::Options& options) {
  std::vector<jobs::ReportFile> files;
  if (!arguments.json.empty()) {
    files.push_back(
        {arguments.json, [&](const jobs::Compensation& of) { return report::summary_json(of.summary, options); }});
  }
  if (!arguments.report.empty()) {
    files.push_back({arguments.report,
                     [&](const jobs::Compensation& of) {
                       return report::page_text(report::compensation_page(of, arguments.program, options));
                     },
                     true});
  }
  return files;
}

int compensate(const CompensateArguments& arguments) {
  const settings::Options options = arguments.shared.read(arguments.program);
  require_model(options);
  check_outputs(files_read(arguments.program, options),
                {arguments.output, arguments.json, arguments.report,
                 options.undo ? jobs::undo_name(arguments.output) : std::string()});
  if (options.undo && output_target(arguments.output).kind != OutputTarget::Kind::file) {
    throw UsageError("--undo writes a file beside the output: name one with -o");
  }
  ProgressLine line("compensate");
  const compensate::Summary summary =
      jobs::compensate_file(arguments.program, arguments.output, options, line.progress(), reports(arguments, options));
  line.clear();
  for (const Diagnostic& warning : summary.warnings) say(warning);
  say_note(report::summary_text(summary, options));
  return kDone;
}

}  // namespace

void add_compensate(CLI::App& app, Run& run) {
  CLI::App* const command = app.add_subcommand("compensate",
                                               "Correct a program, so that the tool tip of the deformed "
                                               "machine goes where the program means it to go");
  const auto arguments = std::make_shared<CompensateArguments>();
  command->add_option("PROGRAM", arguments->program, "the NC program; - for standard input")
      ->type_name("FILE")
      ->required();
  command->add_option("-o,--output", arguments->output, "the corrected program; - for standard output")
      ->type_name("FILE")
      ->required();
  command->add_option("--json", arguments->json, "write the summary as JSON, too")->type_name("FILE");
  add_report_option(*command, arguments->report);
  using Group = settings::OptionGroup;
  arguments->shared.add_to(*command, {Group::model, Group::program, Group::step, Group::bound, Group::compensation});
  command->callback([arguments, &run] { run = [arguments] { return compensate(*arguments); }; });
}

}  // namespace plumbline::cli
