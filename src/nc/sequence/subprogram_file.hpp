// Which file beside a program holds a subprogram.
#pragma once

#include <filesystem>
#include <string>

#include "nc/language/dialect.hpp"

namespace plumbline::nc {

/// The file beside `program` that the dialect's control would look into for the subprogram of that name (as
/// program_name gives it; O words: as written, in small letters), in its folder or below. Empty: there is none. Refuses
/// with nc-subprogram-ambiguous where several files may be it that differ: of a number, and of a name under user
/// task 2.
std::filesystem::path subprogram_file(const std::string& program, const std::string& name, const Dialect& dialect);

/// True of a path below the program's folder: a name is text of the program, and no program says what else is read.
bool is_below(const std::string& name);

/// The name of a file beside the program that is of that name but for the zeros before its number; empty: there is
/// none.
std::string subprogram_file_with_other_zeros(const std::string& program, const std::string& name,
                                             const Dialect& dialect);

/// What such a file is called, in the first of the dialect's ways.
std::string subprogram_file_name(const std::string& name, const Dialect& dialect);

}  // namespace plumbline::nc
