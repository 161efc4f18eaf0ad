#include "nc/sequence/subprogram_file.hpp"

#include <algorithm>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "base/diagnostic.hpp"
#include "base/files/file_state.hpp"
#include "base/files/files_beside.hpp"
#include "base/files/path_of.hpp"
#include "base/text/characters.hpp"
#include "nc/syntax/line_head.hpp"

namespace plumbline::nc {
namespace fs = std::filesystem;
namespace {

bool is_file(const fs::path& path) {
  std::error_code ignored;  // a name too long for a file is none
  return fs::is_regular_file(path, ignored);
}

// A pattern of a file's name with the program's name in place of {}, or of {4}, which has at least four digits.
std::string filled(std::string_view pattern, const std::string& name) {
  std::string padded = name;
  while (padded.size() < 4) padded.insert(padded.begin(), '0');
  std::string out(pattern);
  if (const std::size_t at = out.find("{4}"); at != std::string::npos) out.replace(at, 3, padded);
  if (const std::size_t at = out.find("{}"); at != std::string::npos) out.replace(at, 2, name);
  return out;
}

std::vector<fs::path> files_in(const fs::path& folder) {
  std::error_code ignored;
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder, ignored)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

bool is_number(std::string_view name) { return std::all_of(name.begin(), name.end(), is_digit); }

// A control has one program of a number; which of these files it was is not known.
void refuse_if_different(const std::string& program, const std::string& name, const fs::path& one,
                         const fs::path& other) {
  if (file_hash(one.generic_string()) == file_hash(other.generic_string())) return;
  Place place;
  place.file = program;
  refuse("nc-subprogram-ambiguous",
         fmt::format("program {} is called, and both {} and {} may be it: they differ", name,
                     one.filename().generic_string(), other.filename().generic_string()),
         "move away the one that the control does not have", place);
}

fs::path looked_for(const std::string& program, const std::string& name, const Dialect& dialect) {
  const fs::path folder = path_of(program).parent_path();
  const std::vector<std::string>& patterns = dialect.syntax.subprogram_files;
  if (dialect.syntax.case_of_files) {
    for (const std::string& pattern : patterns) {
      const fs::path file = path_of(filled(pattern, name));
      if (fs::path path = folder / file; is_below(file.generic_string()) && is_file(path)) return path;
    }
    return {};
  }
  const std::vector<fs::path> there = files_in(folder.empty() ? fs::path(".") : folder);
  const bool one_alone = is_number(name) || dialect.syntax.statements == Statements::user_task;
  fs::path found;
  for (const std::string& pattern : patterns) {
    const std::string wanted = upper(filled(pattern, name));
    for (const fs::path& path : there) {
      if (path == found || upper(path.filename().generic_string()) != wanted || !is_file(path)) continue;
      if (found.empty()) found = path;
      if (!one_alone) return found;
      if (path != found) refuse_if_different(program, name, found, path);
    }
  }
  return found;
}

}  // namespace

bool is_below(const std::string& name) {
  const fs::path path = path_of(name);
  return path.is_relative() && std::find(path.begin(), path.end(), "..") == path.end();
}

fs::path subprogram_file(const std::string& program, const std::string& name, const Dialect& dialect) {
  fs::path path = looked_for(program, name, dialect);
  FilesBeside::note(program, name, path.generic_string());
  return path;
}

std::string subprogram_file_with_other_zeros(const std::string& program, const std::string& name,
                                             const Dialect& dialect) {
  const fs::path folder = path_of(program).parent_path();
  for (const fs::path& path : files_in(folder.empty() ? fs::path(".") : folder)) {
    const std::string stem = upper(path.stem().generic_string());
    if (stem == name || canonical_program(stem) != canonical_program(name)) continue;
    for (const std::string& pattern : dialect.syntax.subprogram_files) {
      if (upper(filled(pattern, stem)) == upper(path.filename().generic_string()))
        return path.filename().generic_string();
    }
  }
  return {};
}

std::string subprogram_file_name(const std::string& name, const Dialect& dialect) {
  const std::vector<std::string>& patterns = dialect.syntax.subprogram_files;
  return patterns.empty() ? name : upper(filled(patterns.front(), name));
}

}  // namespace plumbline::nc
