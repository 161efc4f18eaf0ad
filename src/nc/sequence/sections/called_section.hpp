// The part of a program that CALL BLOCK FIRST TO LAST calls.
#pragma once

#include "nc/language/block.hpp"
#include "nc/language/dialect.hpp"
#include "nc/sequence/label_index.hpp"
#include "nc/sequence/program_files.hpp"
#include "nc/sequence/sections/repeated_sections.hpp"

namespace plumbline::nc {

/// From the first label, wherever it stands in the program, to the line of the second one, the first of its name behind
/// it; where reading goes on then. Refuses parts whose labels are missing, behind / or (the first) there twice, that
/// hold the call itself or the end of a program, and words beside the second label. `has_variables`: what is executed
/// has variables of its own; refused as well.
RepeatedSection section_called(const Block& block, const ProgramFiles& files, LabelIndex& labels,
                               const Dialect& dialect, bool has_variables);

}  // namespace plumbline::nc
