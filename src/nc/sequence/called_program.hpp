// Where a program that is called begins, and calls of which that is not known.
#pragma once

#include <string>

#include "nc/language/block.hpp"
#include "nc/language/dialect.hpp"
#include "nc/sequence/label_index.hpp"

namespace plumbline::nc {

/// Of the program that the block calls, by its name as program_name gives it. Refuses with nc-flow-open where there is
/// none, or one but for the zeros before its number, or several in one file; under user task 2 with
/// nc-subprogram-ambiguous where another file holds it as well, or where a file that is opened for this call holds one
/// that was called before.
FilePlace program_called(const Block& block, const std::string& name, LabelIndex& labels, const Dialect& dialect);

}  // namespace plumbline::nc
