#include "batch/watch.hpp"

#include <algorithm>
#include <map>
#include <optional>
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

}  // namespace

void watch(const Request& request, const FolderWatch::Settings& settings, const Watcher& watcher) {
  FolderWatch folder(request.programs, settings);
  std::map<std::string, std::string> refused;
  Observer observer;
  observer.item = [&](const jobs::BatchItem& item) {
    if (item.state != jobs::BatchItem::State::failed) {
      refused.erase(item.program);
    } else if (std::exchange(refused[item.program], words_of(item)) == words_of(item)) {
      return;
    }
    watcher.item(item);
  };
  while (true) {
    Request round = request;
    round.programs.leave_out = folder.busy();
    const Result result = run(round, observer);
    watcher.round(result);
    do {
      if (watcher.goes_on && !watcher.goes_on()) return;
    } while (!folder.wait(kLook) && is_as_it_was(result.tables_read));
  }
}

}  // namespace plumbline::batch
