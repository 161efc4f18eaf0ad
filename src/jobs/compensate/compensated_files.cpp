#include "jobs/compensate/compensated_files.hpp"

#include <filesystem>

#include "base/diagnostic.hpp"

namespace plumbline::jobs {

std::string undo_name(const std::string& output) { return output + ".undo"; }

CompensatedFiles::CompensatedFiles(const std::string& output, bool with_undo, const std::string& json)
    : program_(output) {
  program_.keep_hash();
  if (with_undo) undo_.emplace(undo_name(output));
  if (!json.empty()) json_.emplace(json);
}

std::pair<InputFile, InputFile> open_pair(const std::string& program, const std::string& undo) {
  std::optional<FolderLock> lock;
  if (program != kStandardStream) {
    const std::string folder = std::filesystem::path(program).parent_path().string();
    lock.emplace(folder.empty() ? "." : folder, FolderLock::Kind::shared);
  }
  InputFile first(program);
  return {std::move(first), InputFile(undo)};
}

// The undo file of the program that will be replaced, after the new one; false if there is none that fits it.
bool CompensatedFiles::join_old_undo(OutputFile& both) const {
  const std::string undo = undo_name(program_.name());
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(program_.name(), ignored)) return false;
  if (!std::filesystem::is_regular_file(undo, ignored)) return false;
  try {
    return nc::copy_undo(InputFile(program_.name()), InputFile(undo), both);
  } catch (const Refusal&) {
    return false;  // none of ours, or not to be read
  }
}

void CompensatedFiles::commit(const InputFile& original, const std::string& summary) {
  OutputSet set;
  std::optional<OutputFile> both;
  bool replaces_pair = false;
  if (json_) {
    json_->write(summary);
    set.add(*json_);
  }
  if (undo_) {
    undo_->log.finish(original, program_.size(), program_.hash());
    set.lock({json_ ? &*json_ : nullptr, &undo_->file, &program_});
    both.emplace(undo_->file.name());
    undo_->file.copy_to(*both);
    replaces_pair = join_old_undo(*both);
    set.add(replaces_pair ? *both : undo_->file);
  }
  set.add(program_);
  if (replaces_pair) set.add(undo_->file);
  original.check_unchanged();
  set.commit();
}

}  // namespace plumbline::jobs
