#include <memory>

#include "base/files/files.hpp"
#include "cli/command.hpp"
#include "cli/command_files.hpp"
#include "cli/progress_line.hpp"
#include "cli/shared_options.hpp"
#include "jobs/trace.hpp"
#include "report/program/trace_text.hpp"

namespace plumbline::cli {
namespace {

struct TraceArguments {
  std::string program;
  std::string output = std::string(kStandardStream);
  SharedOptions shared;
};

int trace(const TraceArguments& arguments) {
  const settings::Options options = arguments.shared.read(arguments.program);
  check_outputs(files_read(arguments.program, options), {arguments.output});
  OutputFile out(arguments.output);
  report::TraceWriter writer(out);
  ProgressLine line("trace");
  jobs::trace_file(
      arguments.program, options, [&](const nc::Motion& motion) { writer.add(motion); }, line.progress());
  writer.flush();
  out.commit();
  return kDone;
}

}  // namespace

void add_trace(CLI::App& app, Run& run) {
  CLI::App* const command =
      app.add_subcommand("trace",
                         "Print the motion that a program makes, one JSON object a line, mm and deg; what is not "
                         "given counts as zero, and without a model tilted planes and directions of the tool take ZYX "
                         "as the order of rotations");
  const auto arguments = std::make_shared<TraceArguments>();
  command->add_option("PROGRAM", arguments->program, "the NC program; - for standard input")
      ->type_name("FILE")
      ->required();
  command->add_option("-o,--output", arguments->output, "default standard output")->type_name("FILE");
  arguments->shared.add_to(*command, {settings::OptionGroup::model, settings::OptionGroup::program});
  command->callback([arguments, &run] { run = [arguments] { return trace(*arguments); }; });
}

}  // namespace plumbline::cli
