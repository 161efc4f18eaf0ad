#include "jobs/compensate/compensated_files.hpp"

#include <filesystem>

#include "base/diagnostic.hpp"
#include "base/files/path_of.hpp"

namespace plumbline::jobs {

std::string undo_name(const std::string& output) { return output + ".undo"; }

CompensatedFiles::CompensatedFiles(const Destination& output, const std::optional<Destination>& undo,
                                   const std::vector<std::string>& reports, bool tells_hash)
    : program_(output), keeps_hash_(undo || tells_hash || output.is_taken()) {
  if (keeps_hash_) program_.keep_hash();
  if (undo) undo_.emplace(*undo);
  for (const std::string& report : reports) reports_.emplace_back(report);
}

std::pair<InputFile, InputFile> open_pair(const Source& program, const Source& undo) {
  std::optional<FolderLock> lock;
  if (!program.is_held() && !program.is_standard_input()) {
    const std::string folder = path_of(program.path()).parent_path().generic_string();
    lock.emplace(folder.empty() ? "." : folder, FolderLock::Kind::shared);
  }
  InputFile first(program);
  return {std::move(first), InputFile(undo)};
}

// The undo file of the program that will be replaced, after the new one; false if there is none that fits it.
bool CompensatedFiles::join_old_undo(OutputFile& both) const {
  const std::string undo = undo_name(program_.name());
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path_of(program_.name()), ignored)) return false;
  if (!std::filesystem::is_regular_file(path_of(undo), ignored)) return false;
  try {
    return nc::copy_undo(InputFile(program_.name()), InputFile(undo), both);
  } catch (const Refusal&) {
    return false;  // none of ours, or not to be read
  }
}

void CompensatedFiles::commit(const InputFile& original) {
  OutputSet set;
  std::optional<OutputFile> both;
  bool replaces_pair = false;
  std::vector<const OutputFile*> together;
  for (OutputFile& report : reports_) {
    set.add(report);
    together.push_back(&report);
  }
  if (undo_) {
    undo_->log.finish(original, program_.size(), program_.hash());
    together.insert(together.end(), {&undo_->file, &program_});
    set.lock(together);
    if (program_.is_file()) {
      both.emplace(undo_->file.name());
      undo_->file.copy_to(*both);
      replaces_pair = join_old_undo(*both);
    }
    set.add(replaces_pair ? *both : undo_->file);
  }
  set.add(program_);
  if (replaces_pair) set.add(undo_->file);
  original.check_unchanged();
  set.commit();
}

}  // namespace plumbline::jobs
