#include "report/measured/model_file.hpp"

#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "base/files/path_of.hpp"
#include "base/text/hash.hpp"
#include "base/version.hpp"
#include "identify/model_text.hpp"
#include "identify/posterior/posterior_file.hpp"
#include "machine/model_file.hpp"
#include "machine/numbers_hash.hpp"
#include "report/measured/diagnosis_text.hpp"
#include "report/measured/functions_text.hpp"
#include "report/measured/objection_text.hpp"
#include "report/measured/observability_text.hpp"

namespace plumbline::report {
namespace {

using diagnose::Diagnosis;
using jobs::IdentifiedModel;
using jobs::MeasuredFile;

// "measurements/dataset.toml (fnv1a ..., 26 runs) and ..., model fnv1a ..."
std::string sources_text(const IdentifiedModel& model) {
  std::vector<std::string> files;
  for (const MeasuredFile& file : model.measured) {
    files.push_back(fmt::format("{} (fnv1a {}, {} {})", file.path, to_hex(file.hash), file.count,
                                file.kind == MeasuredFile::Kind::runs ? "runs" : "poses"));
  }
  return fmt::format("{}, model fnv1a {}", fmt::join(files, " and "), to_hex(model.machine.hash));
}

// "K1: 0.01287 -> 0.01209 +- 0.0002 um/N per m"
std::string found_text(const identify::Fit& fit, std::size_t i) {
  const identify::Unknown& u = fit.unknowns[i];
  return fmt::format("{}: {:.6g} -> {:.6g} +- {:.2g} {}", u.label, u.start / u.unit.si,
                     fit.values[static_cast<Eigen::Index>(i)] / u.unit.si, fit.standard_error(i) / u.unit.si,
                     u.unit.name);
}

std::vector<std::string> notes_of(const IdentifiedModel& model, const std::string& sources) {
  std::vector<std::string> notes{
      fmt::format("{} by plumbline {} from {}", model.calibrated ? "Calibrated" : "Identified", version(), sources),
      "What was before, what it is now, and its standard error:"};
  for (const identify::Stage& stage : model.found.stages) {
    for (std::size_t i = 0; i < stage.fit.unknowns.size(); ++i) notes.push_back("  " + found_text(stage.fit, i));
    for (const std::string& sentence : observability_text(stage)) notes.push_back("  " + sentence);
  }
  return notes;
}

std::vector<std::string> notes_of(const Diagnosis& diagnosis) {
  std::vector<std::string> notes{fmt::format("diagnosis: {}", headline(diagnosis))};
  if (diagnosis.withheld) notes.push_back("the numbers are those given: " + objection_text(*diagnosis.withheld));
  for (const diagnose::NamedEffect& effect : diagnosis.effects) {
    notes.push_back(effect.alternatives.empty() ? effect.name
                                                : fmt::format("{}, which these data do not tell from {}", effect.name,
                                                              fmt::join(effect.alternatives, ", ")));
  }
  if (diagnosis.verdict == diagnose::Verdict::unknown) {
    notes.emplace_back("the effects named generic describe what was seen; they are no cause");
    for (const std::string& line : function_lines(diagnosis)) notes.push_back(line);
  }
  return notes;
}

identify::ModelChanges changes_of(const IdentifiedModel& model) {
  const std::string sources = sources_text(model);
  std::string provenance =
      fmt::format("{} by plumbline {} to {}", model.calibrated ? "calibrated" : "refitted", version(), sources);
  return {model.forces, model.errors, std::move(provenance), notes_of(model, sources), model.joints};
}

identify::ModelChanges changes_of(const jobs::DiagnoseResult& result) {
  const Diagnosis& diagnosis = result.diagnosis;
  return {diagnosis.forces,
          diagnosis.errors,
          diagnosis.withheld ? "as it was given to diagnose" : "with what diagnose found",
          notes_of(diagnosis),
          {}};
}

// The posterior belongs to the numbers of the model as it is written, and the model names the posterior by its hash.
LearntFiles learnt_files(const machine::MachineModel& machine, identify::ModelChanges changes,
                         identify::Posterior posterior, const std::string& posterior_name) {
  const machine::MachineModel written =
      machine::parse_model(identify::model_text(machine, changes), machine.document.file);
  posterior = identify::about(posterior, physics::ForceModel(written));
  LearntFiles files;
  files.posterior = identify::posterior_text(posterior, machine::numbers_hash(written));
  changes.posterior = identify::PosteriorName{posterior_name, to_hex(fnv1a(files.posterior))};
  files.model = identify::model_text(machine, changes);
  return files;
}

}  // namespace

std::string model_file(const IdentifiedModel& model) { return identify::model_text(model.machine, changes_of(model)); }

std::string model_file(const jobs::DiagnoseResult& result) {
  return identify::model_text(result.machine, changes_of(result));
}

LearntFiles learnt_files(const IdentifiedModel& model, const std::string& posterior_name) {
  identify::Posterior posterior = model.posterior.value();
  posterior.made_by = fmt::format("plumbline {} {} from {}", model.calibrated ? "calibrate" : "identify", version(),
                                  sources_text(model));
  return learnt_files(model.machine, changes_of(model), std::move(posterior), posterior_name);
}

LearntFiles learnt_files(const jobs::DiagnoseResult& result, const std::string& posterior_name) {
  identify::Posterior posterior = result.diagnosis.posterior;
  posterior.made_by = fmt::format("plumbline diagnose {} from {} runs, model fnv1a {}", version(), result.runs.size(),
                                  to_hex(result.machine.hash));
  return learnt_files(result.machine, changes_of(result), std::move(posterior), posterior_name);
}

std::string posterior_path(const std::string& model_path) {
  std::filesystem::path path = path_of(model_path);
  path.replace_extension(".posterior.toml");
  return path.generic_string();
}

}  // namespace plumbline::report
