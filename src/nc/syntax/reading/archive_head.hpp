// How a program of an archive of a SINUMERIK begins.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

#include "base/text/characters.hpp"

namespace plumbline::nc {

/// Whether a line, from its % on, begins a program: %_N_NAME_MPF, %NAME_SPF [N p. 43, files in punch tape format].
inline bool is_archive_head(std::string_view text) {
  const std::string name = upper(without_blanks(text));
  if (!name.starts_with('%')) return false;
  const bool is_name = std::all_of(name.begin() + 1, name.end(), is_of_name);
  return name.starts_with("%_") || (is_name && (name.ends_with("_MPF") || name.ends_with("_SPF")));
}

}  // namespace plumbline::nc
