#include "nc/sequence/program_files.hpp"

#include <filesystem>
#include <utility>

#include "base/files/path_of.hpp"
#include "nc/sequence/subprogram_file.hpp"

namespace plumbline::nc {

ProgramFiles::ProgramFiles(const InputFile& program, const Dialect& dialect) : dialect_(dialect) {
  files_.push_back(std::make_unique<File>(File{nullptr, &program, LineSource(program, dialect.syntax.goes_on)}));
}

void ProgramFiles::go_to(const FilePlace& place) {
  current_ = place.file;
  seek(place.line);
}

std::optional<std::size_t> ProgramFiles::open_beside(const std::string& subprogram) {
  return open(subprogram_file(files_.front()->file->name(), subprogram, dialect_));
}

std::optional<std::size_t> ProgramFiles::beside(const std::string& subprogram) {
  const std::filesystem::path path = subprogram_file(files_.front()->file->name(), subprogram, dialect_);
  for (std::size_t file = 0; file < files_.size() && !path.empty(); ++file) {
    std::error_code error;  // standard input is no file
    if (std::filesystem::equivalent(path_of(files_[file]->file->name()), path, error)) return file;
  }
  return open(path);
}

std::optional<std::size_t> ProgramFiles::open(const std::filesystem::path& path) {
  if (path.empty()) return std::nullopt;
  auto opened = std::make_unique<InputFile>(path.generic_string());
  const InputFile& file = *opened;
  files_.push_back(std::make_unique<File>(File{std::move(opened), &file, LineSource(file, dialect_.syntax.goes_on)}));
  return files_.size() - 1;
}

void ProgramFiles::check_unchanged() const {
  for (const auto& one : files_) one->file->check_unchanged();
}

}  // namespace plumbline::nc
