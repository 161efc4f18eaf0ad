#include <cerrno>
#include <cstring>
#include <filesystem>
#include <list>
#include <memory>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "base/diagnostic.hpp"
#include "base/files/files.hpp"
#include "base/files/path_of.hpp"
#include "base/platform/platform.hpp"
#include "cli/command.hpp"
#include "cli/command_files.hpp"
#include "cli/messages.hpp"
#include "cli/options/accept.hpp"
#include "cli/options/number_check.hpp"
#include "cli/options/test_dialect.hpp"
#include "cli/options/with.hpp"
#include "cli/progress_line.hpp"
#include "jobs/run_profiles.hpp"
#include "jobs/test_program.hpp"
#include "report/measured/datasets_text.hpp"
#include "report/measured/diagnosis_text.hpp"
#include "report/measured/inspection_text.hpp"
#include "report/measured/model_file.hpp"
#include "report/measured/thinning_text.hpp"
#include "report/page/diagnosis_page.hpp"
#include "report/page/paper_sections.hpp"

namespace plumbline::cli {
namespace {

namespace fs = std::filesystem;

struct DiagnoseArguments {
  jobs::DiagnoseJob job;
  std::string model, folder;
  std::string report;  // empty: report.html of the folder
  std::string dialect = "linuxcnc";
  bool json = false;
};

// A file of the folder.
struct FolderFile {
  std::string path, text;
};

[[noreturn]] void refuse_folder(const std::string& folder, const std::string& why) {
  Place place;
  place.file = folder;
  refuse("file-unwritable", fmt::format("cannot be made a folder: {}", why),
         "name a folder that can be written with -o", place);
}

// Before the work; the folder itself is made after it, so that work that fails leaves none.
void check_folder(const std::string& folder) {
  std::error_code missing;
  fs::path there = fs::absolute(path_of(folder));
  while (!fs::exists(there, missing) && there.has_relative_path()) there = there.parent_path();
  if (!fs::is_directory(there, missing)) refuse_folder(folder, fmt::format("{} is a file", there.generic_string()));
  if (!platform::may_write(there.generic_string())) refuse_folder(folder, std::strerror(errno));
}

// The model last: where it is, the files that it rests on are, too.
void write_folder(const std::string& folder, const std::vector<FolderFile>& texts) {
  NewFolder made(folder);
  OutputSet files;
  std::list<OutputFile> outputs;
  for (const auto& [path, text] : texts) {
    outputs.emplace_back(path).write(text);
    files.add(outputs.back());
  }
  files.clear_last_first();
  files.commit();
  made.keep();
}

Verdict verdict_of(const diagnose::Diagnosis& diagnosis) {
  if (diagnosis.verdict == diagnose::Verdict::nothing_missing) return Verdict::good;
  return diagnosis.verdict == diagnose::Verdict::named ? Verdict::doubtful : Verdict::bad;
}

// The NC program of each test that would tell effects apart.
std::vector<FolderFile> programs_of(const DiagnoseArguments& arguments, const jobs::DiagnoseResult& result) {
  const nc::Dialect& dialect = nc::dialect(arguments.dialect);
  std::vector<FolderFile> programs;
  for (const diagnose::Separation& next : result.diagnosis.next) {
    if (!next.test) continue;
    measure::Run run = next.test->run;
    run.id = "next-test-" + next.from;
    const fs::path path = path_of(arguments.folder) / path_of(jobs::test_program_name(run.id, dialect));
    programs.push_back({path.generic_string(), jobs::test_program(result.machine, run, dialect)});
  }
  return programs;
}

std::string page_of(const DiagnoseArguments& arguments, const jobs::DiagnoseResult& result,
                    const std::vector<FolderFile>& programs) {
  const physics::ForceModel given(result.machine);
  std::vector<jobs::NamedModel> models{{"model as given", &result.machine, &given}};
  if (!result.diagnosis.withheld && !result.diagnosis.effects.empty()) {
    models.push_back({"with what was found", &result.machine, &result.diagnosis.forces});
  }
  jobs::RunsAndModels profiles;
  for (const jobs::NamedModel& model : models) profiles.models.push_back(model.name);
  profiles.runs = jobs::run_profiles(result.runs, models);
  std::vector<std::string> texts;
  for (const FolderFile& program : programs) texts.push_back(program.text);
  report::Page page = report::diagnosis_page(result, profiles, texts);
  report::add_paper(page, jobs::paper_of(arguments.job.dataset, {arguments.model}, arguments.job.with));
  return report::page_text(page);
}

int diagnose(const DiagnoseArguments& arguments) {
  const std::string json = (path_of(arguments.folder) / "diagnosis.json").generic_string();
  const std::string model = (path_of(arguments.folder) / "model.toml").generic_string();
  if (arguments.report == kStandardStream) throw UsageError("--report of diagnose names a file");
  const std::string page =
      arguments.report.empty() ? (path_of(arguments.folder) / "report.html").generic_string() : arguments.report;
  const std::string judged = (path_of(arguments.folder) / "inspection.json").generic_string();
  const std::string posterior = report::posterior_path(model);
  const std::vector<std::string> inputs = inputs_of(arguments.job.dataset, {arguments.model}, arguments.job.with);
  check_folder(arguments.folder);
  check_outputs(inputs, {json, model, posterior, page, judged});
  ProgressLine line("diagnose");
  const diagnose::Say told{[](const std::string& step) { say_step(step); },
                           [&](const std::string& what) { line.begin(what); }};
  jobs::DiagnoseJob job = arguments.job;
  job.model = arguments.model;
  const jobs::DiagnoseResult result = jobs::diagnose(job, told);
  line.clear();
  if (result.other_model) say(*result.other_model);
  const std::string numbers = report::diagnosis_json(result.diagnosis, result.measured);
  std::vector<FolderFile> files = programs_of(arguments, result);
  files.insert(files.begin(), {{json, numbers},
                               {judged, report::inspection_json(result.inspection, result.runs)},
                               {page, page_of(arguments, result, files)}});
  const report::LearntFiles learnt = report::learnt_files(result, path_of(posterior).filename().generic_string());
  files.push_back({posterior, learnt.posterior});
  files.push_back({model, learnt.model});
  std::vector<std::string> outputs;
  for (const FolderFile& file : files) outputs.push_back(file.path);
  check_outputs(inputs, outputs);
  write_folder(arguments.folder, files);
  const std::string words = report::diagnosis_text(result.diagnosis) +
                            report::faults_text(result.inspection, result.runs) +
                            report::thinning_text(result.thinning) + report::renamed_text(result.measured);
  if (arguments.json) {
    print_result(numbers);
  } else {
    print_result(words, {std::string_view(words).substr(0, words.find('\n')), verdict_of(result.diagnosis)});
  }
  if (result.diagnosis.converged) return kDone;
  say({"diagnose-not-converged",
       "the last fit did not converge: do not use the numbers found",
       "look at the runs of report.html for what is odd in the readings; measure anew, or more runs",
       {},
       Severity::error});
  return kFailed;
}

}  // namespace

void add_diagnose(CLI::App& app, Run& run) {
  CLI::App* const command = app.add_subcommand(
      "diagnose", "Find which effect a model misses: name it, say how sure that is, add it, predict runs left out");
  const auto arguments = std::make_shared<DiagnoseArguments>();
  command->add_option("-m,--model", arguments->model, "the machine's model file")->type_name("MODEL")->required();
  command->add_option("-d,--dataset", arguments->job.dataset, "the measurements: a dataset.toml")
      ->type_name("DATASET")
      ->required();
  add_with(*command, arguments->job.with);
  command
      ->add_option("-o,--output", arguments->folder,
                   "folder for diagnosis.json, model.toml, report.html and NC programs of tests that would tell more")
      ->type_name("DIR")
      ->required();
  command->add_option("--report", arguments->report, "where the page goes, in place of report.html in that folder")
      ->type_name("FILE.html");
  add_accept(*command, arguments->job.accepted);
  add_test_dialect(*command, arguments->dialect);
  command->add_option("--without", arguments->job.without, "effects to leave out of the catalogue")
      ->type_name("NAME,...")
      ->delimiter(',');
  command->add_option("--seed", arguments->job.seed, "of the random numbers that the threshold is computed with")
      ->check(whole_number())
      ->capture_default_str();
  command->add_flag("--json", arguments->json, "print the result as JSON");
  command->callback([arguments, &run] { run = [arguments] { return diagnose(*arguments); }; });
}

}  // namespace plumbline::cli
