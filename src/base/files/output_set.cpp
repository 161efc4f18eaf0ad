#include "base/files/output_set.hpp"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <set>
#include <system_error>

#include <fmt/format.h>

#include "base/diagnostic.hpp"
#include "base/files/path_of.hpp"
#include "base/platform/platform.hpp"

namespace plumbline {
namespace {

namespace fs = std::filesystem;

// Both names are in one folder. Where renaming fails, removing and linking may not.
bool put_back(const std::string& before, const std::string& name) {
  if (platform::rename(before, name)) {
    platform::remove_file(before);  // both named the same file: then renaming does nothing
    return true;
  }
  return (platform::remove_file(name) || errno == ENOENT) && platform::link(before, name);
}

}  // namespace

NewFolder::NewFolder(const std::string& path) {
  std::vector<fs::path> missing;
  std::error_code problem;
  for (fs::path folder = path_of(path); !folder.empty() && !fs::exists(folder, problem) && !problem;
       folder = folder.parent_path()) {
    if (folder.has_filename()) missing.push_back(folder);
  }
  for (auto folder = missing.rbegin(); folder != missing.rend() && !problem; ++folder) {
    PassingName name(folder->string());
    if (fs::create_directory(*folder, problem) && !problem) {
      made_.insert(made_.begin(), std::move(name));
    } else {
      name.let_go();
    }
  }
  if (!problem && !fs::is_directory(path_of(path), problem)) problem = std::make_error_code(std::errc::not_a_directory);
  if (!problem) return;
  Place place;
  place.file = path;
  refuse("file-unwritable", fmt::format("cannot be made a folder: {}", problem.message()),
         "name a folder that can be written with -o", place);
}

void NewFolder::keep() {
  for (PassingName& name : made_) name.let_go();
}

// In one order for all, so that two never wait for each other.
void OutputSet::lock(const std::vector<const OutputFile*>& files) {
  std::set<std::string> folders;
  for (const OutputFile* const file : files) {
    if (file == nullptr || file->target_.kind != OutputTarget::Kind::file) continue;
    std::error_code gone;
    const fs::path folder = fs::canonical(path_of(file->target_.folder()), gone);
    if (!gone) folders.insert(folder.generic_string());
  }
  for (const std::string& folder : folders) locks_.emplace_back(folder, FolderLock::Kind::exclusive);
}

void OutputSet::commit() {
  for (OutputFile* const file : files_) file->finish();
  for (OutputFile* const file : files_) {
    if (!file->temporary_) file->send();
  }
  if (locks_.empty()) lock({files_.begin(), files_.end()});
  const SignalsWait wait;
  if (clears_last_first_) clear_last();
  for (OutputFile* const file : files_) {
    if (!file->temporary_ || appear(*file)) continue;
    const int error = errno;
    file->refuse_write(error, take_back());
  }
  for (const FolderLock& folder : locks_) {
    if (folder.sync()) continue;
    const int error = errno;
    files_.back()->refuse_write(error, take_back());
  }
  changed_.clear();
}

void OutputSet::clear_last() {
  const OutputTarget& target = files_.back()->target_;
  std::error_code ignored;
  if (target.kind != OutputTarget::Kind::file || !fs::is_regular_file(path_of(target.path), ignored)) return;
  Changed one{target.path, PassingName(passing_name_in(target.folder())), true};
  if (platform::rename(target.path, one.before->path())) {
    changed_.push_back(std::move(one));
  } else if (errno != ENOENT) {
    files_.back()->refuse_write(errno);
  }
}

bool OutputSet::appear(OutputFile& file) {
  const std::string& path = file.target_.path;
  Changed one{path, PassingName(passing_name_in(file.target_.folder())), true};
  if (!platform::link(path, one.before->path())) {
    one.was_there = errno != ENOENT;
    one.before.reset();  // nothing stood there, or there are no links here
  }
  if (!platform::rename(file.temporary_->path(), path)) return false;
  file.temporary_->let_go();
  file.descriptor_.close();  // Windows replaces no file that is open: another of these, or what stood there, may follow
  changed_.push_back(std::move(one));
  return true;
}

// Says what could not be taken back.
std::string OutputSet::take_back() {
  std::string left;
  for (; !changed_.empty(); changed_.pop_back()) {
    Changed& one = changed_.back();
    const std::string& path = one.path;
    const bool done = one.was_there ? one.before && put_back(one.before->path(), path) : platform::remove_file(path);
    if (done) continue;
    left += fmt::format("; {} is new already and does not belong to what stands beside it", path);
    if (!one.before) continue;
    left += fmt::format(", what stood there is {}", one.before->path());
    one.before->let_go();
  }
  return left;
}

}  // namespace plumbline
