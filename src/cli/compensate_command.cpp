#include <algorithm>
#include <filesystem>
#include <memory>

#include <fmt/format.h>

#include "base/files/files.hpp"
#include "base/files/files_beside.hpp"
#include "base/files/path_of.hpp"
#include "cli/command.hpp"
#include "cli/command_files.hpp"
#include "cli/messages.hpp"
#include "cli/options/report_file.hpp"
#include "cli/progress_line.hpp"
#include "cli/shared_options.hpp"
#include "jobs/compensate/compensate_file.hpp"
#include "jobs/compensate/compensated_files.hpp"
#include "jobs/compensate/output_of.hpp"
#include "report/depfile.hpp"
#include "report/page/program_pages.hpp"
#include "report/program/summary_text.hpp"

namespace plumbline::cli {
namespace {

struct CompensateArguments {
  std::string program, output, json, report, depfile;
  SharedOptions shared;
};

// The program, what it calls, and what the options name.
std::vector<std::string> dependencies(const CompensateArguments& arguments, const settings::Options& options,
                                      const FilesBeside& beside) {
  std::vector<std::string> files = files_read(arguments.program, options);
  for (const FilesBeside::Sought& one : beside.files()) {
    const std::string path = path_of(one.path).lexically_normal().generic_string();
    if (std::find(files.begin(), files.end(), path) == files.end()) files.push_back(path);
  }
  return files;
}

std::vector<jobs::ReportFile> reports(const CompensateArguments& arguments, const settings::Options& options,
                                      const std::string& output, const FilesBeside& beside) {
  std::vector<jobs::ReportFile> files;
  if (!arguments.json.empty()) {
    files.push_back({arguments.json, [&](const jobs::Compensation& of, OutputFile& file) {
                       file.write(report::summary_json(of.summary, options, of.expected.error));
                     }});
  }
  if (!arguments.report.empty()) {
    files.push_back({arguments.report,
                     [&](const jobs::Compensation& of, OutputFile& file) {
                       report::write_page(report::compensation_page(of, arguments.program, options), file);
                     },
                     true});
  }
  if (!arguments.depfile.empty()) {
    files.push_back({arguments.depfile, [&](const jobs::Compensation&, OutputFile& file) {
                       file.write(report::depfile_text(output, dependencies(arguments, options, beside)));
                     }});
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
  check_outputs(files_read(arguments.program, options), {output, arguments.json, arguments.report, arguments.depfile,
                                                         options.undo ? jobs::undo_name(output) : std::string()});
  if (options.undo && output_target(output).kind != OutputTarget::Kind::file) {
    throw UsageError("--undo writes a file beside the output: name one with -o");
  }
  if (!arguments.depfile.empty() &&
      (arguments.program == kStandardStream || output_target(output).kind != OutputTarget::Kind::file)) {
    throw UsageError("--depfile says what a file depends on: name the program, and its output with -o");
  }
  ProgressLine line("compensate");
  const FilesBeside beside(arguments.program);
  jobs::Expectation expected;
  const compensate::Summary summary = jobs::compensate_file(arguments.program, output, options, line.progress(),
                                                            reports(arguments, options, output, beside), {}, &expected);
  line.clear();
  for (const Diagnostic& warning : summary.warnings) say(warning);
  if (expected.warning) say(*expected.warning);
  if (arguments.output.empty() && output != kStandardStream)
    say_note(fmt::format("  output                {}\n", output));
  say_note(report::summary_text(summary, options, expected.error));
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
  command->add_option("--depfile", arguments->depfile, "write which files were read, as a rule for make and ninja")
      ->type_name("FILE");
  using Group = settings::OptionGroup;
  arguments->shared.add_to(*command, {Group::model, Group::program, Group::step, Group::bound, Group::compensation});
  command->callback([arguments, &run] { run = [arguments] { return compensate(*arguments); }; });
}

}  // namespace plumbline::cli
