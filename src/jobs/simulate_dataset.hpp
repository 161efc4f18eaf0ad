// A dataset as the model of a machine would have measured it.
#pragma once

#include <cstdint>
#include <string>

#include "base/files/source.hpp"

namespace plumbline::jobs {

struct DatasetSimulationSummary {
  std::uint64_t runs = 0;
  std::uint64_t samples = 0;
};

/// Writes the dataset into a folder, its measured columns simulated: without noise, ideal set-up. Refuses what the
/// readers of models and datasets, physics::ForceModel, measure::simulate_run and measure::write_dataset refuse.
DatasetSimulationSummary simulate_dataset(const Source& model, const std::string& dataset, const std::string& folder);

}  // namespace plumbline::jobs
