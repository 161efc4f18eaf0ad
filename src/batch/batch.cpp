#include "batch/batch.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "base/diagnostic.hpp"
#include "base/files/files.hpp"
#include "base/files/path_of.hpp"
#include "base/files/temporary_file.hpp"
#include "base/parallel.hpp"
#include "base/text/characters.hpp"
#include "batch/committer.hpp"
#include "batch/freshness.hpp"
#include "batch/in_order.hpp"
#include "batch/outputs.hpp"
#include "batch/record.hpp"
#include "batch/settings_by_folder.hpp"
#include "batch/work.hpp"
#include "settings/output_name.hpp"

namespace plumbline::batch {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSameName = "{folder}/{name}{ext}";

struct Planned {
  Task task;
  const FolderSettings* settings = nullptr;  // null: refused
  std::optional<Diagnostic> refusal;
};

void refuse_same_folder(const ProgramRequest& programs) {
  std::error_code none;
  if (fs::weakly_canonical(path_of(programs.folder), none) != fs::weakly_canonical(path_of(programs.output), none))
    return;
  Place place;
  place.file = programs.output;
  refuse("file-overwrites-input", "the outputs would stand among the programs", "give another folder with -o", place);
}

std::string place_of_output(const std::string& place, const settings::Options& options) {
  const std::string& pattern = options.output_pattern.empty() ? std::string(kSameName) : options.output_pattern;
  // The pattern says how a file is called, and -o where it lies.
  try {
    const fs::path name = path_of(settings::output_name(pattern, place, options.machine)).filename();
    return (path_of(place).parent_path() / name).generic_string();
  } catch (const settings::OptionError& error) {
    refuse("settings-value", fmt::format("output_name: {}", error.what()), "name the machine with --machine");
  }
}

Diagnostic same_output(const Task& task, const std::string& other) {
  Place place;
  place.file = task.program;
  return {"file-written-twice", fmt::format("has the same output as {}: {}", other, task.output),
          "keep {ext} in --output-name, or rename one of them", place, Severity::error};
}

// Whether a file that is there is found by its name in other letters, too.
bool ignores_case(const std::string& file) {
  const fs::path path = path_of(file);
  const std::string name = path.filename().generic_string();
  std::error_code none;
  return upper(name) != name && fs::equivalent(path, path.parent_path() / path_of(upper(name)), none);
}

// Two folders with programs of one name would take turns.
void refuse_other_source(const Entry& known, const Task& task) {
  std::error_code none;
  if (known.source == whole_path(task.program) || !fs::is_regular_file(path_of(known.source), none)) return;
  if (fs::equivalent(path_of(known.source), path_of(task.program), none)) return;
  if (!fs::is_regular_file(path_of(task.output), none)) return;
  Place place;
  place.file = task.program;
  refuse("batch-other-source", fmt::format("{} was made of {}, which is there still", task.output, known.source),
         "give another folder with -o; or remove that output, if it is no longer wanted", place);
}

// A pipe would be waited for.
void refuse_no_file(const std::string& program) {
  std::error_code none;
  const fs::file_status there = fs::status(path_of(program), none);
  if (!fs::exists(there) || fs::is_regular_file(there) || fs::is_directory(there)) return;
  Place place;
  place.file = program;
  refuse("batch-no-file", "is no file", "name files in the list", place);
}

// Of a program that holds corrections already.
void tell_expected(jobs::BatchItem& item, bool is_expected) {
  if (is_expected) return item.diagnostics.clear();
  Diagnostic& why = item.diagnostics.front();
  why.severity = Severity::warning;
  why.help = "it is passed over: put the program that it was made of into the folder";
}

class Run {
 public:
  Run(const Request& request, const Observer& observer)
      : request_(request), settings_(request.settings), list_(list_programs(request.programs)) {
    plan();
    told_.emplace(observer, planned_.size());
  }

  Result go() {
    const auto begin = std::chrono::steady_clock::now();
    NewFolder folder(request_.programs.output);
    Record record(record_path(request_));
    folder.keep();
    sweep_folders();
    if (ignores_case(record_path(request_))) refuse_alike();
    do_all(record);
    told_->finish(called_);
    Result result;
    result.summary = told_->summary();
    result.summary.passed_over = list_.passed_over;
    if (request_.programs.list.empty()) {
      result.summary.vanished = vanished_outputs(request_.programs.output, places_, record);
      if (list_.holds_outputs) {
        result.summary.among_outputs = programs_among_outputs(request_.programs, places_, record);
      }
    }
    result.files_read = files_read();
    result.tables_read = settings_.files();
    const std::chrono::duration<double> since = std::chrono::steady_clock::now() - begin;
    result.summary.seconds = since.count();
    return result;
  }

 private:
  void plan() {
    for (const std::string& program : list_.programs) {
      Planned one;
      one.task.program = program;
      try {
        one.task.place = place_in_folder(request_.programs.folder, program);
        one.task.output = output_at(one.task.place);
        if (!request_.programs.list.empty()) refuse_no_file(program);
        one.settings = &settings_.of(program);
        one.task.place = place_of_output(one.task.place, one.settings->options);
        one.task.output = output_at(one.task.place);
        if (is_named_twice(one.task)) continue;
        beside_.insert(settings::output_name(program, one.settings->options));
      } catch (const Refusal& refusal) {
        one.settings = nullptr;
        one.refusal = refusal.diagnostic();
      }
      one.task.number = planned_.size();
      planned_.push_back(std::move(one));
    }
    for (const Diagnostic& shut : list_.shut) {
      Planned one;
      one.task = {
          planned_.size(), shut.place.file, {}, output_at(place_in_folder(request_.programs.folder, shut.place.file))};
      one.refusal = shut;
      planned_.push_back(std::move(one));
    }
  }

  // Where "Part.nc" and "part.nc" are one file.
  void refuse_alike() {
    std::map<std::string, std::string> places;
    for (Planned& one : planned_) {
      if (one.refusal) continue;
      const auto [there, is_new] = places.emplace(upper(one.task.place), one.task.program);
      if (!is_new) one.refusal = same_output(one.task, there->second);
    }
  }

  std::string output_at(const std::string& place) const {
    return (path_of(request_.programs.output) / path_of(place)).generic_string();
  }

  // A list may name a program twice; two programs may not have one output.
  bool is_named_twice(const Task& task) {
    const auto [there, is_new] = places_.emplace(task.place, task.program);
    if (is_new) return false;
    if (whole_path(there->second) == whole_path(task.program)) return true;
    throw Refusal(same_output(task, there->second));
  }

  void do_all(Record& record) {
    const unsigned all = processors();
    const std::size_t wanted = request_.jobs > 0 ? request_.jobs : all;
    const auto jobs = static_cast<unsigned>(std::clamp<std::size_t>(planned_.size(), 1, wanted));
    const HeldProcessors held(std::max(1U, all / jobs));  // those of one program
    Committer committer(record, [&](Work&& work) { settle(std::move(work)); });
    for_each_index(
        planned_.size(), [&](std::size_t i) { do_one(planned_[i], record, committer); }, jobs);
    committer.finish();
  }

  void do_one(const Planned& planned, Record& record, Committer& committer) {
    if (stopped_) return;
    const Task& task = planned.task;
    std::optional<Entry> known;
    try {
      known = record.find(task.place);  // of refused settings: where it would be without a name of their own
      if (planned.refusal) throw Refusal(*planned.refusal);
      if (known) refuse_other_source(*known, task);
      if (std::optional<Work> work = unchanged(known, planned)) return hand_on(std::move(*work), committer);
      make_folder(path_of(task.output).parent_path().generic_string());
    } catch (...) {
      const Diagnostic why = current_problem(task.program);
      settle(
          failed(task, why, known.has_value() && why.code != "file-written-twice" && why.code != "batch-other-source"));
      return;
    }
    Work work = compensate_one(task, *planned.settings, known);
    if (work.item.state == jobs::BatchItem::State::compensated) {
      tell_expected(work.item, beside_.contains(path_of(task.program).lexically_normal().generic_string()));
    }
    hand_on(std::move(work), committer);
  }

  void hand_on(Work&& work, Committer& committer) {
    if (!work.output && !work.is_known_anew) return settle(std::move(work));
    if (!committer.take(std::move(work))) stopped_ = true;
  }

  static std::optional<Work> unchanged(const std::optional<Entry>& known, const Planned& planned) {
    const Task& task = planned.task;
    if (!known) return std::nullopt;
    Work work;
    work.entry = *known;
    const Freshness found = freshness(work.entry, task.program, task.output, *planned.settings);
    if (!found.is_fresh) return std::nullopt;
    work.entry.source = whole_path(task.program);
    work.is_known_anew = found.looks_new || work.entry.source != known->source;
    work.task = task;
    work.item = {task.program, task.output, jobs::BatchItem::State::unchanged, known->summary, {}};
    const fs::path folder = path_of(task.program).parent_path();
    for (const CalledFile& one : known->called) {
      if (!one.path.empty()) work.called.push_back((folder / path_of(one.path)).generic_string());
    }
    return work;
  }

  // What killed runs left under passing names goes.
  void sweep_folders() const {
    std::set<fs::path> folders;
    for (const Planned& one : planned_) folders.insert(path_of(one.task.output).parent_path());
    for (const fs::path& folder : folders) sweep_temporary_files(folder.generic_string());
  }

  void make_folder(const std::string& folder) {
    const std::scoped_lock lock(guard_);
    if (made_.insert(folder).second) NewFolder(folder).keep();
  }

  void settle(Work&& work) {
    const std::scoped_lock lock(guard_);
    for (const std::string& file : work.called) {
      if (!file.empty()) called_.insert(whole_path(file));
    }
    told_->take(work.task.number, std::move(work.item));
  }

  std::vector<std::string> files_read() const {
    std::set<std::string> files(called_);
    for (const auto& [file, state] : settings_.files()) files.insert(file);
    files.insert(list_.programs.begin(), list_.programs.end());
    files.insert(list_.folders.begin(), list_.folders.end());
    if (!request_.programs.list.empty() && request_.programs.list != kStandardStream) {
      files.insert(request_.programs.list);
    }
    return {files.begin(), files.end()};
  }

  const Request& request_;
  SettingsByFolder settings_;
  ProgramList list_;
  std::vector<Planned> planned_;
  OutputPlaces places_;
  std::atomic<bool> stopped_ = false;
  std::mutex guard_;
  std::set<std::string> made_;    // folders
  std::set<std::string> called_;  // files that programs call
  std::set<std::string> beside_;  // outputs that `compensate` would make of the programs, mostly beside them
  std::optional<InOrder> told_;
};

}  // namespace

std::string record_path(const Request& request) {
  if (!request.record.empty()) return request.record;
  return (path_of(request.programs.output) / kRecordName).generic_string();
}

Result run(const Request& request, const Observer& observer) {
  refuse_same_folder(request.programs);
  return Run(request, observer).go();
}

}  // namespace plumbline::batch
