// The files that a call names, for refuse_shared_files.
#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include "api/inside.hpp"
#include "base/files/own_files.hpp"
#include "settings/options.hpp"

namespace plumbline::api {

/// Of sources that are files.
inline std::vector<std::string> file_names(std::initializer_list<Source> sources) {
  std::vector<std::string> names;
  for (const Source& source : sources) {
    if (!source.is_held()) names.push_back(source.path());
  }
  return names;
}

inline std::vector<std::string> files_read(const Input& input, const settings::Options& options) {
  const settings::Paths& paths = options.paths;
  std::vector<std::string> names = file_names({Inside::source(input), paths.model, paths.tools, paths.variables});
  names.insert(names.end(), paths.settings_files.begin(), paths.settings_files.end());
  return names;
}

inline std::vector<std::string> files_written(std::initializer_list<Destination> destinations) {
  std::vector<std::string> names;
  for (const Destination& one : destinations) {
    if (!one.is_taken() && !one.empty()) names.push_back(one.name());
  }
  return names;
}

}  // namespace plumbline::api
