#include "jobs/diagnose.hpp"

#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "base/units.hpp"
#include "diagnose/verdict.hpp"
#include "identify/model_text.hpp"
#include "machine/model_file.hpp"
#include "measure/thinning.hpp"
#include "physics/generic_formula.hpp"

namespace plumbline::jobs {
namespace {

using diagnose::Diagnosis;
using diagnose::NamedEffect;

std::vector<std::string> notes_of(const Diagnosis& diagnosis) {
  std::vector<std::string> notes{fmt::format("diagnosis: {}", headline(diagnosis))};
  if (!diagnosis.withheld.empty()) notes.push_back("the numbers are those given: " + diagnosis.withheld);
  for (const NamedEffect& effect : diagnosis.effects) {
    notes.push_back(effect.alternatives.empty() ? effect.name
                                                : fmt::format("{}, which these data do not tell from {}", effect.name,
                                                              fmt::join(effect.alternatives, ", ")));
  }
  if (diagnosis.verdict == diagnose::Verdict::unknown) {
    notes.emplace_back("the effects named generic describe what was seen; they are no cause");
  }
  return notes;
}

}  // namespace

std::string headline(const Diagnosis& d) {
  if (d.verdict == diagnose::Verdict::unknown) return "unknown: there is a gap, and no effect of the catalogue is it";
  if (d.verdict == diagnose::Verdict::nothing_missing) return "nothing-missing, as far as these runs can show";
  return "named: " + diagnose::names_text(d);
}

DiagnoseResult diagnose(const DiagnoseJob& job, const diagnose::Say& say) {
  const machine::MachineModel machine = machine::read_model(job.model);
  const measure::Dataset dataset = measure::read_dataset(job.dataset);
  diagnose::DiagnoseOptions options;
  options.candidates.without = job.without;
  options.search.threshold.seed = job.seed;
  const measure::Thinned thinned = measure::thinned(dataset.runs);
  Diagnosis diagnosis = diagnose::diagnose(machine, thinned.runs, options, say);
  std::string model = identify::model_text(
      machine,
      {diagnosis.forces, diagnosis.errors,
       diagnosis.withheld.empty() ? "with what diagnose found" : "as it was given to diagnose", notes_of(diagnosis)});
  return {std::move(diagnosis), machine.name, std::move(model), thinned.text()};
}

}  // namespace plumbline::jobs
