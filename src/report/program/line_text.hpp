// A line of a program in words.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include <fmt/format.h>

namespace plumbline::report {

/// "8", and "8 of SUB1.SPF" where a subprogram's file is named, without its folder.
inline std::string line_text(std::size_t line, std::string_view file) {
  if (file.empty()) return fmt::format("{}", line);
  return fmt::format("{} of {}", line, file.substr(file.find_last_of("/\\") + 1));
}

}  // namespace plumbline::report
