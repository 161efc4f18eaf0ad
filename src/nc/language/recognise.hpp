// Which control a program was written for, seen from what it holds.
#pragma once

#include <string>

#include "base/files/files.hpp"
#include "nc/language/dialect.hpp"

namespace plumbline::nc {

struct Recognised {
  const Dialect* dialect;  // linuxcnc where nothing speaks for any
  std::string evidence;    // what spoke for it; empty: nothing
  std::size_t line = 0;    // where
};

/// Looks at the first 64 kB for what only one dialect has (`marks` of the tables), and at the ending of the file's
/// name. Refuses with nc-dialect-ambiguous where something speaks for two.
Recognised recognise(const InputFile& file);

}  // namespace plumbline::nc
