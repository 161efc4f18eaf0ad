// The INI file of a control, as LinuxCNC reads it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.hpp"

namespace plumbline::jobs {

struct IniEntry {
  std::string section;
  std::string key;
  std::string value;  // without blanks around it
  Place place;        // of the value
};

struct IniFile {
  std::string file;
  std::vector<IniEntry> entries;  // in their order

  /// The first of that name, which is the one that LinuxCNC takes.
  const IniEntry* find(std::string_view section, std::string_view key) const;
  Place whole() const { return {file}; }
};

/// Reads sections, KEY = VALUE, comments (lines that begin with # or ;) and `#INCLUDE FILE`, whose path counts from the
/// including file. Refuses as read_text does, with draft-file an included file that is not there or includes
/// itself, and with draft-syntax a line that is none of these.
IniFile read_ini(const std::string& path);

/// The numbers that a value consists of, with blanks between them; what follows a # or ; is a comment. Refuses with
/// draft-number.
std::vector<double> numbers_of(const IniEntry& entry);

}  // namespace plumbline::jobs
