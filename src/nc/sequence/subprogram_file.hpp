// Which file beside a program holds a subprogram.
#pragma once

#include <filesystem>
#include <string>

#include "nc/language/dialect.hpp"

namespace plumbline::nc {

/// The file beside `program` that the dialect's control would look into for the subprogram of that name (as
/// canonical_program gives it; O words: as written, in small letters), in its folder or below. Empty: there is none.
std::filesystem::path subprogram_file(const std::string& program, const std::string& name, const Dialect& dialect);

/// What such a file is called, in the first of the dialect's ways.
std::string subprogram_file_name(const std::string& name, const Dialect& dialect);

}  // namespace plumbline::nc
