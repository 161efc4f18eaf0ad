#include "cli/identified_output.hpp"

#include <filesystem>
#include <optional>

#include <fmt/format.h>

#include "base/files/files.hpp"
#include "base/files/path_of.hpp"
#include "cli/command_files.hpp"
#include "cli/messages.hpp"
#include "cli/options/report_file.hpp"
#include "identify/posterior/posterior_file.hpp"
#include "report/measured/datasets_text.hpp"
#include "report/measured/identification_text.hpp"
#include "report/measured/model_file.hpp"
#include "report/measured/objection_text.hpp"
#include "report/measured/thinning_text.hpp"
#include "report/page/identification_page.hpp"
#include "report/page/paper_sections.hpp"

namespace plumbline::cli {

void add_identified_output(CLI::App& command, IdentifiedOutput& output) {
  command
      .add_option("-o,--output", output.model,
                  "the model with what was found: the same text, comments and all, but for the numbers")
      ->type_name("MODEL2")
      ->required();
  command.add_option("--json", output.json, "write values, errors, correlations and the gap as JSON, too")
      ->type_name("FILE");
  add_report_option(command, output.report);
  command.add_flag("--force", output.force,
                   "write the model even where something speaks against it: numbers beyond six sigma of [uncertainty], "
                   "or circles that it predicts worse than the model as given");
}

namespace {

constexpr const char* kMendData =
    "mend what the dataset or the table says, or leave the run out; --accept RUN takes it as it is. plumbline inspect "
    "says more";

// Errors refuse the model, a warning lets it pass.
void object(const jobs::IdentifiedModel& identified, const IdentifiedOutput& output) {
  const std::string objection = report::objection_text(identified);
  Diagnostic diagnostic{
      "identify-not-plausible", objection + fmt::format(": {} is not written", output.model),
      identified.inspection.blocks()
          ? kMendData
          : "something else is missing in the model, or a channel has another unit or sign than it says: run "
            "plumbline diagnose on the same data. If [uncertainty] is too narrow, widen it; --force writes the model "
            "all the same"};
  if (!output.force) throw Refusal(diagnostic);
  diagnostic.severity = Severity::warning;
  diagnostic.message = objection;
  diagnostic.help =
      "--force: the model is written all the same. Do not cut with it before plumbline compare says that "
      "it fits circles that were not used here";
  say(diagnostic);
}

}  // namespace

namespace {

// With a protocol, where circular tests were measured.
report::Page signed_page(const jobs::IdentifiedModel& identified) {
  report::Page page = report::identification_page(identified, report::profiles_of(identified));
  std::vector<std::string> datasets;
  for (const jobs::MeasuredFile& file : identified.measured) {
    if (file.kind == jobs::MeasuredFile::Kind::runs) datasets.push_back(file.path);
  }
  if (datasets.empty()) return page;
  report::add_paper(page, jobs::paper_of(datasets.front(), {identified.machine.document.file},
                                         {datasets.begin() + 1, datasets.end()}));
  return page;
}

// The posterior gets its name from the model's, and nobody named it: what stands there goes if it is the model's own.
void refuse_strange_posterior(const std::string& posterior, const std::string& model) {
  std::error_code none;
  if (!std::filesystem::exists(std::filesystem::symlink_status(path_of(posterior), none))) return;
  const std::string known = identify::posterior_named_in(model);
  if (!known.empty() && std::filesystem::equivalent(path_of(known), path_of(posterior), none)) return;
  refuse("file-exists", fmt::format("{} stands there already, and is not the posterior of {}", posterior, model),
         "the model's posterior would be written there: name another model with -o, or move this file away",
         {posterior, 0});
}

}  // namespace

int write_identified(const std::vector<std::string>& inputs, const IdentifiedOutput& output,
                     const std::function<jobs::IdentifiedModel()>& make) {
  const OutputTarget target = output_target(output.model);
  const bool has_posterior = target.kind == OutputTarget::Kind::file;
  // links followed: the model looks for its posterior beside itself
  const std::string posterior = has_posterior ? report::posterior_path(target.path) : std::string();
  check_outputs(inputs, {output.model, posterior, output.json, output.report});
  if (has_posterior) refuse_strange_posterior(posterior, target.path);
  OutputFile out(output.model);
  JsonResult json_result(output.json);
  ReportFile page(output.report);
  const jobs::IdentifiedModel identified = make();
  if (identified.other_model) say(*identified.other_model);
  std::string words = report::identification_text(identified.found) + report::thinning_text(identified.thinning) +
                      report::renamed_text(identified.measured);
  if (output.model == kStandardStream || page.takes_standard_output()) {
    say_note(words);
    words.clear();
  }
  OutputSet files;
  json_result.add_to(files, report::identification_json(identified.found));
  page.add_to(files, [&] { return signed_page(identified); });
  const bool refused = !identified.found.converged() || (identified.objected() && !output.force);
  if (refused) {
    if (!json_result.takes_standard_output()) print_result(words);
    files.commit();
  }
  if (!identified.found.converged()) {
    refuse(
        "identify-not-converged",
        fmt::format("{}: {} is not written", report::not_converged_text(identified), output.model),
        identified.inspection.blocks()
            ? kMendData
            : "give fewer unknowns by --free, or priors for them in [uncertainty]; check that the dataset belongs to "
              "this machine");
  }
  if (identified.objected()) object(identified, output);
  std::optional<OutputFile> posterior_file;
  if (has_posterior) {
    const report::LearntFiles learnt = report::learnt_files(identified, path_of(posterior).filename().generic_string());
    posterior_file.emplace(posterior).write(learnt.posterior);
    files.add(*posterior_file);
    out.write(learnt.model);
  } else {
    out.write(report::model_file(identified));
  }
  files.add(out);
  files.commit();
  if (!json_result.takes_standard_output()) print_result(words);
  return kDone;
}

}  // namespace plumbline::cli
