// What may be wrong with measurements, in words and as JSON.
#pragma once

#include <string>
#include <vector>

#include "inspect/fault.hpp"
#include "measure/dataset.hpp"

namespace plumbline::report {

/// A fault in one sentence without its end: "run 04: with direction cw instead of ccw it is at 1.1 times the noise
/// instead of 9.3".
std::string fault_text(const inspect::Fault& fault, const std::vector<measure::Run>& runs);

/// All of them; the first line is the verdict.
std::string inspection_text(const inspect::Inspection& inspection, const std::vector<measure::Run>& runs,
                            bool with_model);
/// The faults alone, under a line that says so; empty: there are none.
std::string faults_text(const inspect::Inspection& inspection, const std::vector<measure::Run>& runs);

std::string inspection_json(const inspect::Inspection& inspection, const std::vector<measure::Run>& runs);

}  // namespace plumbline::report
