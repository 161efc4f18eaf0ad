// What is wrong alike with several runs, and not with the others: a day on which torques were logged as currents.
#pragma once

#include <optional>

#include "inspect/fine_noise.hpp"
#include "inspect/hypothesis.hpp"
#include "inspect/looked.hpp"

namespace plumbline::inspect {

/// A fault that some of the runs have alike, with these (numbers among `looked`): where others are spoiled alike no run
/// is judged by the others, but all of them together, with the model's priors, by which of them are mended.
/// `labels`: whether what the dataset says is doubted, too; that takes long.
std::optional<Fault> fault_of_some(const Looked& looked, const Bench& bench, const FineNoise& noise, bool labels,
                                   const InspectOptions& options);

}  // namespace plumbline::inspect
