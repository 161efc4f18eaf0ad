#include "base/files/files_beside.hpp"

#include <map>
#include <mutex>
#include <set>
#include <utility>

namespace plumbline {
namespace {

using Found = std::set<std::pair<std::string, std::string>>;  // path, name

struct Programs {
  std::mutex guard;
  std::map<std::string, Found> found;
};

Programs& programs() {
  static Programs all;
  return all;
}

}  // namespace

FilesBeside::FilesBeside(std::string program) : program_(std::move(program)) {
  const std::scoped_lock lock(programs().guard);
  programs().found[program_].clear();
}

FilesBeside::~FilesBeside() {
  const std::scoped_lock lock(programs().guard);
  programs().found.erase(program_);
}

std::vector<FilesBeside::Sought> FilesBeside::files() const {
  const std::scoped_lock lock(programs().guard);
  std::vector<Sought> files;
  for (const auto& [path, name] : programs().found[program_]) files.push_back({name, path});
  return files;
}

void FilesBeside::note(const std::string& program, const std::string& name, const std::string& path) {
  const std::scoped_lock lock(programs().guard);
  const auto one = programs().found.find(program);
  if (one != programs().found.end()) one->second.emplace(path, name);
}

}  // namespace plumbline
