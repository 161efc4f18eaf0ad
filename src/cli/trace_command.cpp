#include <memory>

#include "base/files.hpp"
#include "cli/command.hpp"
#include "cli/command_files.hpp"
#include "cli/progress_line.hpp"
#include "cli/shared_options.hpp"
#include "jobs/program_dialect.hpp"
#include "jobs/trace.hpp"

namespace plumbline::cli {
namespace {

struct TraceArguments {
  std::string program;
  std::string output = std::string(kStandardStream);
  SharedOptions shared;
};

int trace(const TraceArguments& arguments) {
  const jobs::Options options = arguments.shared.read(arguments.program);
  check_outputs(files_read(arguments.program, options), {arguments.output});
  nc::ProgramSettings settings = jobs::program_settings(options);
  settings.as_with_empty_tables = true;
  const InputFile program(arguments.program);
  OutputFile out(arguments.output);
  ProgressLine line;
  plumbline::trace(program, jobs::dialect_of(options, program), std::move(settings), out, line.progress());
  out.commit();
  return kDone;
}

}  // namespace

void add_trace(CLI::App& app, Run& run) {
  CLI::App* const command = app.add_subcommand(
      "trace", "Print the motion that a program makes, one JSON object a line, mm and deg; what nobody gave is zero");
  const auto arguments = std::make_shared<TraceArguments>();
  command->add_option("PROGRAM", arguments->program, "the NC program; - for standard input")
      ->type_name("FILE")
      ->required();
  command->add_option("-o,--output", arguments->output, "default standard output")->type_name("FILE");
  arguments->shared.add_to(*command, {jobs::OptionGroup::program});
  command->callback([arguments, &run] { run = [arguments] { return trace(*arguments); }; });
}

}  // namespace plumbline::cli
