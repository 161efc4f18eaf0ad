// How programs end, and what stands behind them in their file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>

#include "base/files/files.hpp"
#include "nc/control/step.hpp"
#include "nc/language/block.hpp"
#include "nc/language/dialect.hpp"
#include "nc/sequence/label_index.hpp"

namespace plumbline::nc {

/// What ends a subprogram, as a way out says it.
std::string how_programs_end(const Dialect& dialect);
/// Refuses a block that begins another program before the one above it ended; but in an archive, where it ends it.
void refuse_unended(const Block& block, Statements statements);
/// Refuses with nc-flow-open an archive of several programs whose first one is a subprogram.
void check_first_of_archive(LabelIndex& labels);
/// Refuses with nc-flow-open where the program's file holds a main program that nothing called, or where a
/// subprogram is the first of several. `begun`: the lines in which the programs begin that were read. `left_out`: lines
/// behind / are. `returned`: the first program is a subprogram by its end, and so may each of the file be.
void check_other_programs(LabelIndex& labels, const std::set<std::size_t>& begun, const Dialect& dialect, bool left_out,
                          bool returned);

/// What stands behind the main program of an archive.
struct ProgramsBehind {
  std::uint64_t begin = 0;    // to the end of the file
  std::optional<Place> main;  // the first main program of them, by its name
};
/// Nothing where the file is no archive, or holds one program.
std::optional<ProgramsBehind> programs_behind(const InputFile& file, const Dialect& dialect);

/// RTS, RET: the step is executed, and returns to the program that called this file.
bool returns_from_file(const Step& step);

}  // namespace plumbline::nc
