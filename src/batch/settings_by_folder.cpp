#include "batch/settings_by_folder.hpp"

#include <filesystem>

#include "base/files/files.hpp"
#include "base/files/path_of.hpp"
#include "base/text/hash.hpp"
#include "base/version.hpp"
#include "machine/model_file.hpp"
#include "settings/program_settings.hpp"

namespace plumbline::batch {
namespace {

class Fingerprint {
 public:
  void add(std::string_view text) {
    hash_ = fnv1a(text, hash_);
    hash_ = fnv1a(std::string_view("\0", 1), hash_);
  }
  std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = fnv1a({});
};

// What is hashed is what is read.
void hold(Source& source, Fingerprint& fingerprint) {
  if (source.empty()) return;
  std::string text = read_text(source);
  fingerprint.add(text);
  source = Source::held(source.path(), std::move(text));
}

}  // namespace

const FolderSettings& SettingsByFolder::of(const std::string& program) {
  const std::scoped_lock lock(guard_);
  const std::string folder = path_of(program).parent_path().generic_string();
  auto found = folders_.find(folder);
  if (found == folders_.end()) {
    found = folders_.emplace(folder, Entry()).first;
    try {
      found->second.settings = read(program);
    } catch (const Refusal& refusal) {
      found->second.refusal = refusal.diagnostic();
    }
  }
  if (found->second.refusal) throw Refusal(*found->second.refusal);
  return found->second.settings;
}

FolderSettings SettingsByFolder::read(const std::string& program) {
  settings::SettingsRequest request = request_;
  request.program = program;
  if (!request.without_files) {
    for (const std::string& file : settings::settings_files(program, request.file)) note(file);
  }
  const settings::ResolvedSettings resolved = settings::resolve_settings(request);
  FolderSettings settings;
  settings.options = resolved.options;
  settings::Paths& paths = settings.options.paths;
  if (paths.model.empty()) {
    const std::string choice = settings::choice_of_machine(settings.options);
    refuse("settings-no-model", "no model of the machine is named for this program",
           choice.empty() ? "name it with -m, or in a settings file" : choice, {program, 0});
  }
  for (const Source& source : {paths.model, paths.tools, paths.variables}) {
    if (!source.empty()) note(source.path());
  }

  Fingerprint fingerprint;
  fingerprint.add(version());
  fingerprint.add(settings.options.machine);
  for (const std::string& file : paths.settings_files) fingerprint.add(file);  // the output names them
  for (const settings::StatedOption& stated : resolved.stated) {
    if (stated.row->name == "output-name") continue;
    fingerprint.add(stated.row->name);
    // What stands in the file counts, not by which name it was reached: the output names the variables alone.
    if (!stated.row->is_path || stated.row->name == "variables") fingerprint.add(stated.text);
  }
  settings.model = model(paths.model.path());
  fingerprint.add(to_hex(settings.model->hash));
  hold(paths.tools, fingerprint);
  hold(paths.variables, fingerprint);
  settings.program = settings::program_settings(settings.options, *settings.model);
  settings.hash = fingerprint.value();
  return settings;
}

std::shared_ptr<const machine::MachineModel> SettingsByFolder::model(const std::string& path) {
  std::shared_ptr<const machine::MachineModel>& known = models_[path];
  if (!known) known = std::make_shared<const machine::MachineModel>(machine::read_model(path));
  return known;
}

void SettingsByFolder::note(const std::string& file) { files_.emplace(file, file_state(file)); }

std::map<std::string, std::optional<FileState>> SettingsByFolder::files() const {
  const std::scoped_lock lock(guard_);
  return files_;
}

}  // namespace plumbline::batch
