#include <memory>

#include <fmt/format.h>

#include "base/files/files.hpp"
#include "cli/command.hpp"
#include "cli/command_files.hpp"
#include "cli/messages.hpp"
#include "cli/options/report_file.hpp"
#include "cli/progress_line.hpp"
#include "cli/shared_options.hpp"
#include "jobs/compensate/compensate_file.hpp"
#include "jobs/compensate/compensated_files.hpp"
#include "jobs/compensate/output_of.hpp"
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
    files.push_back({arguments.json, [&](const jobs::Compensation& of, OutputFile& file) {
                       file.write(report::summary_json(of.summary, options));
                     }});
  }
  if (!arguments.report.empty()) {
    files.push_back({arguments.report,
                     [&](const jobs::Compensation& of, OutputFile& file) {
                       report::write_page(report::compensation_page(of, arguments.program, options), file);
                     },
                     true});
  }
  return files;
}

std::string output_of(const CompensateArguments& arguments, const settings::Options& options) {
  if (!arguments.output.empty()) return arguments.output;
  try {
    return jobs::output_of(arguments.program, options);
  } catch (const settings::OptionError& error) {
    throw UsageError(fmt::format("--output-name {}: {}", options.output_pattern, error.what()));
  }
}

int compensate(const CompensateArguments& arguments) {
  const settings::Options options = arguments.shared.read(arguments.program);
  require_model(options);
  const std::string output = output_of(arguments, options);
  check_outputs(files_read(arguments.program, options),
                {output, arguments.json, arguments.report, options.undo ? jobs::undo_name(output) : std::string()});
  if (options.undo && output_target(output).kind != OutputTarget::Kind::file) {
    throw UsageError("--undo writes a file beside the output: name one with -o");
  }
  ProgressLine line("compensate");
  const compensate::Summary summary =
      jobs::compensate_file(arguments.program, output, options, line.progress(), reports(arguments, options));
  line.clear();
  for (const Diagnostic& warning : summary.warnings) say(warning);
  if (arguments.output.empty() && output != kStandardStream)
    say_note(fmt::format("  output                {}\n", output));
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
  command
      ->add_option("-o,--output", arguments->output,
                   "the corrected program; - for standard output (default: as --output-name says)")
      ->type_name("FILE");
  command->add_option("--json", arguments->json, "write the summary as JSON, too")->type_name("FILE");
  add_report_option(*command, arguments->report);
  using Group = settings::OptionGroup;
  arguments->shared.add_to(*command, {Group::model, Group::program, Group::step, Group::bound, Group::compensation});
  command->callback([arguments, &run] { run = [arguments] { return compensate(*arguments); }; });
}

}  // namespace plumbline::cli
