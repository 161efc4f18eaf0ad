#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>

#include <fmt/format.h>
#include <unistd.h>

#include "base/diagnostic.hpp"
#include "base/files.hpp"
#include "cli/command.hpp"
#include "cli/command_files.hpp"
#include "jobs/diagnose.hpp"
#include "report/diagnosis_page.hpp"

namespace plumbline::cli {
namespace {

struct DiagnoseArguments {
  jobs::DiagnoseJob job;
  std::string folder;
  bool json = false;
};

void make_folder(const std::string& folder) {
  std::error_code problem;
  std::filesystem::create_directories(folder, problem);
  if (problem) {
    refuse("file-unwritable", fmt::format("cannot make the folder {}: {}", folder, problem.message()),
           "name a folder that can be written with -o");
  }
}

int diagnose(const DiagnoseArguments& arguments) {
  const std::string json = arguments.folder + "/diagnosis.json";
  const std::string model = arguments.folder + "/model.toml";
  const std::string page = arguments.folder + "/report.html";
  make_folder(arguments.folder);
  check_outputs({arguments.job.model, arguments.job.dataset}, {json, model, page});
  const bool terminal = isatty(STDERR_FILENO) != 0;
  const jobs::DiagnoseReport report = jobs::diagnose(arguments.job, [&](const std::string& step) {
    if (terminal) fmt::print(stderr, "{}\n", step);
  });
  write_text(json, report.json);
  write_text(model, report.model_toml);
  write_text(page, report::diagnosis_page(report.diagnosis, "Diagnosis of " + report.machine));
  fmt::print("{}", arguments.json ? report.json : report.text);
  return report.diagnosis.converged ? kDone : kFailed;
}

}  // namespace

void add_diagnose(CLI::App& app, Run& run) {
  CLI::App* const command = app.add_subcommand(
      "diagnose", "Find which effect a model misses: name it, say how sure that is, add it, predict runs left out");
  const auto arguments = std::make_shared<DiagnoseArguments>();
  command->add_option("-m,--model", arguments->job.model, "the machine's model file")->type_name("MODEL")->required();
  command->add_option("-d,--dataset", arguments->job.dataset, "the measurements: a dataset.toml")
      ->type_name("DATASET")
      ->required();
  command->add_option("-o,--output", arguments->folder, "folder for diagnosis.json, model.toml and report.html")
      ->type_name("DIR")
      ->required();
  command->add_option("--without", arguments->job.without, "effects to leave out of the catalogue")
      ->type_name("NAME,...")
      ->delimiter(',');
  command->add_option("--seed", arguments->job.seed, "of the random numbers behind the threshold")
      ->capture_default_str();
  command->add_flag("--json", arguments->json, "print the result as JSON");
  command->callback([arguments, &run] { run = [arguments] { return diagnose(*arguments); }; });
}

}  // namespace plumbline::cli
