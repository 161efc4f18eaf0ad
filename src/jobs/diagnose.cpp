#include "jobs/diagnose.hpp"

#include <utility>

#include "machine/model_file.hpp"

namespace plumbline::jobs {

DiagnoseResult diagnose(const DiagnoseJob& job, const diagnose::Say& say) {
  machine::MachineModel machine = machine::read_model(job.model);
  measure::Dataset dataset = measure::read_dataset(job.dataset);
  diagnose::DiagnoseOptions options;
  options.candidates.without = job.without;
  options.search.threshold.seed = job.seed;
  const measure::Thinned thinned = measure::thinned(machine, std::move(dataset.runs));
  diagnose::Diagnosis diagnosis = diagnose::diagnose(machine, thinned.runs, options, say);
  return {std::move(machine), std::move(diagnosis), thinned.thinning};
}

}  // namespace plumbline::jobs
