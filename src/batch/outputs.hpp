// What lies in the folder of the outputs besides those of today's programs.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "batch/program_list.hpp"
#include "batch/record.hpp"

namespace plumbline::batch {

/// Places of outputs, and the programs that they are of.
using OutputPlaces = std::map<std::string, std::string>;

/// Outputs of earlier runs whose program is gone. Entries without a program and without an output are forgotten.
std::vector<std::string> vanished_outputs(const std::string& folder, const OutputPlaces& places, Record& record);

/// Programs in the folder of the outputs that are no outputs: nobody looks at them there. Ascending.
std::vector<std::string> programs_among_outputs(const ProgramRequest& programs, const OutputPlaces& places,
                                                Record& record);

}  // namespace plumbline::batch
