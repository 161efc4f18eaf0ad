#include "batch/folder_watch.hpp"

#include <algorithm>
#include <filesystem>
#include <thread>
#include <utility>

#include "base/diagnostic.hpp"
#include "base/files/path_of.hpp"
#include "settings/settings_file.hpp"

namespace plumbline::batch {
namespace {

constexpr std::chrono::milliseconds kQuiet{100};  // several files mostly come together
constexpr std::chrono::milliseconds kStep{50};    // of waiting for files that rest
constexpr std::chrono::milliseconds kUsualEvery{2000};

}  // namespace

FolderWatch::FolderWatch(const ProgramRequest& programs, const Settings& settings)
    : programs_(programs), settings_(settings), looked_(Clock::now()) {
  if (!settings_.every) events_ = FolderEvents::open();
  const ProgramList list = list_programs(programs);
  for (const std::string& folder : list.folders) {
    if (events_ && !events_->add(folder)) events_.reset();  // no more of them: it is looked through
  }
  // What was written to a moment ago may be being written.
  const std::int64_t now = now_ns();
  const std::int64_t rest = std::chrono::nanoseconds(settings_.rest).count();
  for (const std::string& program : list.programs) {
    const std::optional<FileState> state = file_state(program);
    if (!state) continue;
    known_[program] = *state;
    if (state->changed_ns + rest > now) note_busy(program);
  }
}

std::set<std::string> FolderWatch::busy() const {
  std::set<std::string> programs;
  for (const auto& [program, seen] : busy_) programs.insert(program);
  return programs;
}

bool FolderWatch::wait(Milliseconds most) {
  const Clock::time_point end = Clock::now() + most;
  Clock::time_point heard = Clock::now();
  while (Clock::now() < end) {
    if (events_) {
      const auto left = std::chrono::duration_cast<Milliseconds>(end - Clock::now());
      const auto events = events_->wait(busy_.empty() && !changed_ ? std::max(left, Milliseconds{1}) : kStep);
      for (const FolderEvent& event : events) note(event);
      if (!events.empty()) heard = Clock::now();
    } else {
      std::this_thread::sleep_for(std::min<Milliseconds>(kStep, settings_.every.value_or(kUsualEvery)));
      if (Clock::now() - looked_ >= settings_.every.value_or(kUsualEvery)) look_through();
    }
    release_rested();
    if (changed_ && Clock::now() - heard >= kQuiet) break;
  }
  return std::exchange(changed_, false);
}

void FolderWatch::note(const FolderEvent& event) {
  using Kind = FolderEvent::Kind;
  if (event.kind == Kind::folder) return add_folder(event.path);
  if (event.kind == Kind::lost) {
    changed_ = true;
    return look_through();
  }
  const bool is_settings = path_of(event.path).filename() == settings::kSettingsFileName;
  if (!is_settings && !is_program_name(event.path, programs_.endings)) return;
  if (event.kind == Kind::begun) return note_busy(event.path);
  busy_.erase(event.path);
  changed_ = true;
}

// Files may have come into it before it was watched.
void FolderWatch::add_folder(const std::string& folder) {
  ProgramRequest inner = programs_;
  inner.folder = folder;
  try {
    const ProgramList list = list_programs(inner);
    for (const std::string& one : list.folders) {
      if (!events_->add(one)) changed_ = true;
    }
    for (const std::string& program : list.programs) note_busy(program);
  } catch (const Refusal&) {  // it has gone again
    changed_ = true;
  }
}

void FolderWatch::note_busy(const std::string& program) {
  busy_[program] = {file_state(program).value_or(FileState()), Clock::now()};
}

void FolderWatch::look_through() {
  looked_ = Clock::now();
  std::map<std::string, FileState> found;
  for (const std::string& program : list_programs(programs_).programs) {
    const std::optional<FileState> state = file_state(program);
    if (!state) continue;
    found[program] = *state;
    const auto known = known_.find(program);
    if (known == known_.end() || known->second != *state) note_busy(program);
  }
  for (const auto& [program, state] : known_) changed_ = changed_ || !found.contains(program);
  known_ = std::move(found);
}

void FolderWatch::release_rested() {
  const Clock::time_point now = Clock::now();
  for (auto one = busy_.begin(); one != busy_.end();) {
    const FileState state = file_state(one->first).value_or(FileState());
    if (state != one->second.state) one->second = {state, now};
    if (now - one->second.since < settings_.rest) {
      ++one;
    } else {
      one = busy_.erase(one);
      changed_ = true;
    }
  }
}

}  // namespace plumbline::batch
