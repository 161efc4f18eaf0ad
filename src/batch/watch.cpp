#include "batch/watch.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <utility>

#include "base/diagnostic.hpp"
#include "base/files/file_state.hpp"

namespace plumbline::batch {
namespace {

constexpr std::chrono::milliseconds kLook{1000};  // at models, tables and settings

bool is_as_it_was(const std::map<std::string, std::optional<FileState>>& files) {
  return std::all_of(files.begin(), files.end(),
                     [](const auto& file) { return file_state(file.first) == file.second; });
}

std::string words_of(const jobs::BatchItem& item) {
  std::string words;
  for (const Diagnostic& one : item.diagnostics) words += to_text(one);
  return words;
}

enum class Ended : std::uint8_t { asked, folder_gone };

class Rounds {
 public:
  Rounds(const Request& request, const FolderWatch::Settings& settings, const Watcher& watcher)
      : request_(request), settings_(settings), watcher_(watcher) {
    observer_.item = [this](const jobs::BatchItem& item) { tell(item); };
  }

  // Until the folder is another one than it was, or is none.
  Ended go() {
    const std::optional<FileState> began = folder_state(request_.programs.folder);
    const auto is_gone = [&] {
      const std::optional<FileState> now = folder_state(request_.programs.folder);
      return began && (!now || now->number != began->number);
    };
    try {
      FolderWatch folder(request_.programs, settings_);
      while (true) {
        const Result result = look_through(folder.busy());
        do {
          if (is_to_end()) return Ended::asked;
          if (is_gone()) return Ended::folder_gone;
        } while (!folder.wait(kLook) && is_as_it_was(result.tables_read));
      }
    } catch (const Refusal&) {
      if (!is_gone()) throw;
      return Ended::folder_gone;
    }
  }

  // False: it is to end.
  bool wait_for_folder() const {
    if (!folder_state(request_.programs.folder)) {
      Place place;
      place.file = request_.programs.folder;
      if (watcher_.warning)
        watcher_.warning({"batch-folder-gone", "the folder that is watched is gone",
                          "bring it back: it is looked for every second", place, Severity::warning});
    }
    while (!folder_state(request_.programs.folder)) {
      if (is_to_end()) return false;
      std::this_thread::sleep_for(kLook);
    }
    return true;
  }

 private:
  bool is_to_end() const { return watcher_.goes_on && !watcher_.goes_on(); }

  Result look_through(std::set<std::string> busy) {
    Request round = request_;
    round.programs.leave_out = std::move(busy);
    Result result = run(round, observer_);
    watcher_.round(result);
    return result;
  }

  void tell(const jobs::BatchItem& item) {
    using State = jobs::BatchItem::State;
    if (item.state == State::done || item.state == State::unchanged) {
      passed_over_.erase(item.program);
    } else {
      auto why = std::pair(item.state, words_of(item));
      const auto [known, is_new] = passed_over_.try_emplace(item.program);
      if (!is_new && known->second == why) return;
      known->second = std::move(why);
    }
    watcher_.item(item);
  }

  const Request& request_;
  const FolderWatch::Settings& settings_;
  const Watcher& watcher_;
  Observer observer_;
  std::map<std::string, std::pair<jobs::BatchItem::State, std::string>> passed_over_;  // programs, and why
};

}  // namespace

void watch(const Request& request, const FolderWatch::Settings& settings, const Watcher& watcher) {
  Rounds rounds(request, settings, watcher);
  while (rounds.go() == Ended::folder_gone && rounds.wait_for_folder()) {
  }
}

}  // namespace plumbline::batch
