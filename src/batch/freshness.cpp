#include "batch/freshness.hpp"

#include <algorithm>
#include <filesystem>

#include "base/diagnostic.hpp"
#include "base/files/path_of.hpp"
#include "nc/language/dialect.hpp"
#include "nc/sequence/subprogram_file.hpp"

namespace plumbline::batch {
namespace {

constexpr std::int64_t kCoarsestClock_ns = 2'000'000'000;  // FAT counts in 2 s

// Nobody's time: such a file is read.
constexpr std::int64_t kUnknown = 0;

bool is_settled(std::int64_t changed_ns, std::int64_t now) { return changed_ns + kCoarsestClock_ns < now; }

// Brings `known` up to date where only the looks of a file have changed.
bool is_same(KnownFile& known, const std::string& path, bool& looks_new) {
  const std::int64_t now = now_ns();
  const std::optional<FileState> state = file_state(path);
  if (!state) return false;
  if (*state == known.state) return true;
  if (state->size != known.state.size || file_hash(path) != known.hash) return false;
  known = known_file(*state, known.hash, now);
  looks_new = true;
  return true;
}

bool calls_same(Entry& entry, const std::string& program, bool& looks_new) {
  if (entry.called.empty()) return true;
  const std::filesystem::path folder = path_of(program).parent_path();
  const std::int64_t changed_ns = folder_change(program);
  if (changed_ns == kUnknown || changed_ns != entry.folder_changed_ns) {
    const nc::Dialect& dialect = nc::dialect(entry.dialect);
    for (const CalledFile& one : entry.called) {
      const std::filesystem::path then = one.path.empty() ? std::filesystem::path() : folder / path_of(one.path);
      if (!one.name.empty() && nc::subprogram_file(program, one.name, dialect) != then) return false;
    }
    looks_new = true;
    entry.folder_changed_ns = changed_ns;
  }
  return std::all_of(entry.called.begin(), entry.called.end(), [&](CalledFile& one) {
    return one.path.empty() || is_same(one.file, (folder / path_of(one.path)).generic_string(), looks_new);
  });
}

}  // namespace

KnownFile known_file(const FileState& state, std::uint64_t hash, std::int64_t read_ns) {
  KnownFile known{state, hash};
  if (!is_settled(state.changed_ns, read_ns)) known.state.changed_ns = kUnknown;
  return known;
}

std::int64_t folder_change(const std::string& program) {
  const std::string folder = path_of(program).parent_path().generic_string();
  const std::int64_t now = now_ns();
  const std::optional<FileState> state = folder_state(folder.empty() ? "." : folder);
  return state && is_settled(state->changed_ns, now) ? state->changed_ns : kUnknown;
}

Freshness freshness(Entry& entry, const std::string& program, const std::string& output,
                    const FolderSettings& settings) {
  Freshness found;
  if (entry.settings != settings.hash || entry.has_undo != settings.options.undo) return found;
  try {
    found.is_fresh = is_same(entry.program, program, found.looks_new) && calls_same(entry, program, found.looks_new) &&
                     is_same(entry.output, output, found.looks_new);
  } catch (const Refusal&) {  // a file that cannot be read: making the output says so
    found.is_fresh = false;
  }
  if (found.is_fresh && entry.has_undo) {
    std::error_code none;
    found.is_fresh = std::filesystem::is_regular_file(path_of(output + ".undo"), none);
  }
  return found;
}

}  // namespace plumbline::batch
