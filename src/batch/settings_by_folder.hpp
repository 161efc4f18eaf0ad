// What holds for the programs of a folder, read once.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "base/diagnostic.hpp"
#include "base/files/file_state.hpp"
#include "machine/model.hpp"
#include "nc/control/state/program_settings.hpp"
#include "settings/resolved.hpp"

namespace plumbline::batch {

/// The settings, the machine and the tables that programs are compensated with. The texts of all files are those that
/// the fingerprint was made of.
struct FolderSettings {
  settings::Options options;
  std::shared_ptr<const machine::MachineModel> model;
  nc::ProgramSettings program;
  std::uint64_t hash = 0;  // of all that an output depends on besides its program, the version of plumbline too
};

/// Thread-safe.
class SettingsByFolder {
 public:
  /// What the command line says of every program; `request.program` is left open.
  explicit SettingsByFolder(settings::SettingsRequest request) : request_(std::move(request)) {}

  /// Of the folder of a program. Refuses, each time, as resolve_settings and the readers of models and tables do, and
  /// with settings-no-model where none is named.
  const FolderSettings& of(const std::string& program);
  /// All files that were read so far, as they were just before.
  std::map<std::string, std::optional<FileState>> files() const;

 private:
  struct Entry {
    FolderSettings settings;
    std::optional<Diagnostic> refusal;
  };
  FolderSettings read(const std::string& program);
  void note(const std::string& file);
  std::shared_ptr<const machine::MachineModel> model(const std::string& path);

  settings::SettingsRequest request_;
  mutable std::mutex guard_;
  std::map<std::string, Entry> folders_;
  std::map<std::string, std::optional<FileState>> files_;
  std::map<std::string, std::shared_ptr<const machine::MachineModel>> models_;
};

}  // namespace plumbline::batch
