// How an output is named where nobody names it.
#pragma once

#include <string>
#include <string_view>

namespace plumbline::settings {

struct Options;

/// Stands for the program's folder in a pattern.
inline constexpr std::string_view kProgramFolder = "{folder}";
inline constexpr std::string_view kOutputPattern = "{folder}/{name}_straight{ext}";

/// Throws OptionError if the pattern holds other names in braces than folder, name, ext and machine, or no {name}: all
/// programs would have one output.
void check_output_pattern(std::string_view pattern);

/// The output of `program`: {folder} is its folder, {name} its file name without the ending, {ext} the ending with its
/// point, {machine} the name of the machine. The pattern is one that was checked. Throws OptionError if it holds
/// {machine} and no machine was named.
std::string output_name(std::string_view pattern, const std::string& program, const std::string& machine);

/// The same by the pattern and the machine of the options; kOutputPattern where they state no pattern.
std::string output_name(const std::string& program, const Options& options);

}  // namespace plumbline::settings
