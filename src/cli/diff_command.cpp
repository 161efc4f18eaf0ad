#include <memory>

#include "cli/command.hpp"
#include "cli/command_files.hpp"
#include "cli/options/number_check.hpp"
#include "cli/options/report_file.hpp"
#include "cli/progress_line.hpp"
#include "cli/shared_options.hpp"
#include "jobs/diff/diff.hpp"
#include "report/page/program_pages.hpp"
#include "report/program/diff_text.hpp"

namespace plumbline::cli {
namespace {

struct DiffArguments {
  std::string a, b, json, report;
  bool expect_equal = false;
  double tolerance_mm = 1e-4;
  double tolerance_deg = 1e-4;
  SharedOptions shared;
};

int diff(const DiffArguments& arguments) {
  const settings::Options options = arguments.shared.read(arguments.a);
  std::vector<std::string> inputs = files_read(arguments.a, options);
  inputs.push_back(arguments.b);
  check_outputs(inputs, {arguments.json, arguments.report});
  JsonResult json(arguments.json);
  ReportFile page(arguments.report);
  ProgressLine line("diff");
  compensate::DrawnPath path;
  const jobs::DiffSummary summary =
      jobs::diff_files(arguments.a, arguments.b, options, line.progress(), !arguments.report.empty() ? &path : nullptr);
  line.clear();
  OutputSet files;
  json.add_to(files, report::diff_json(summary));
  page.add_to(files, [&] { return report::diff_page(summary, path, arguments.a, arguments.b); });
  if (!json.takes_standard_output() && !page.takes_standard_output()) print_result(report::diff_text(summary));
  files.commit();
  const bool differs = arguments.expect_equal && !summary.equal_within(arguments.tolerance_mm, arguments.tolerance_deg);
  return differs ? kFound : kDone;
}

void add_files(CLI::App& command, DiffArguments& arguments) {
  command.add_option("A", arguments.a, "the NC program to compare with; - for standard input")
      ->type_name("FILE")
      ->required();
  command.add_option("B", arguments.b, "the NC program to compare, whose blocks may be pieces of A's")
      ->type_name("FILE")
      ->required();
  command.add_option("--json", arguments.json, "write the result as JSON, too")->type_name("FILE");
  add_report_option(command, arguments.report);
  command.add_flag("--expect-equal", arguments.expect_equal,
                   "exit code 3 if an axis is off by more than the tolerance, or blocks are out of line");
  command.add_option("--tolerance-mm", arguments.tolerance_mm, "of X, Y, Z (default 0.0001 mm)")
      ->type_name("MM")
      ->check(number_from_zero());
  command.add_option("--tolerance-deg", arguments.tolerance_deg, "of A, B, C (default 0.0001 deg)")
      ->type_name("DEG")
      ->check(number_from_zero());
}

}  // namespace

void add_diff(CLI::App& app, Run& run) {
  CLI::App* const command = app.add_subcommand(
      "diff",
      "Compare two programs by the poses of the tool tip in W; offsets, tools and start that are not given are "
      "zero for both, without a model tilted planes and directions of the tool take ZYX as the order of rotations, and "
      "the settings file is that beside A");
  const auto arguments = std::make_shared<DiffArguments>();
  add_files(*command, *arguments);
  arguments->shared.add_to(*command, {settings::OptionGroup::model, settings::OptionGroup::program});
  command->callback([arguments, &run] { run = [arguments] { return diff(*arguments); }; });
}

}  // namespace plumbline::cli
