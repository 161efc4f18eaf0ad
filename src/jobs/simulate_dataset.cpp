#include "jobs/simulate_dataset.hpp"

#include "machine/model_file.hpp"
#include "measure/dataset_text.hpp"
#include "measure/simulation.hpp"

namespace plumbline::jobs {

DatasetSimulationSummary simulate_dataset(const Source& model, const std::string& dataset, const std::string& folder) {
  const machine::MachineModel machine = machine::read_model(model);
  const physics::ForceModel forces(machine);
  measure::Dataset simulated = measure::simulated(machine, forces, measure::read_dataset(dataset));
  simulated.document.text = measure::without_plan(simulated.document.text);
  measure::write_dataset(simulated, folder);
  DatasetSimulationSummary summary;
  for (const measure::Run& run : simulated.runs) {
    ++summary.runs;
    summary.samples += run.samples();
  }
  return summary;
}

}  // namespace plumbline::jobs
