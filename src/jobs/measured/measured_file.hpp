// A file of measurements that something was learnt from.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace plumbline::jobs {

struct MeasuredFile {
  enum class Kind { runs, poses };
  std::string path;
  std::uint64_t hash = 0;  // FNV-1a, of a dataset and the tables that it names
  std::size_t count = 0;
  Kind kind = Kind::runs;
  /// Runs that are called otherwise here than in the file, and how.
  std::vector<std::pair<std::string, std::string>> renamed = {};
};

}  // namespace plumbline::jobs
