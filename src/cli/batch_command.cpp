#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "base/files/files.hpp"
#include "base/files/path_of.hpp"
#include "base/text/characters.hpp"
#include "base/units.hpp"
#include "batch/batch.hpp"
#include "batch/watch.hpp"
#include "cli/command.hpp"
#include "cli/command_files.hpp"
#include "cli/messages.hpp"
#include "cli/options/number_check.hpp"
#include "cli/progress_line.hpp"
#include "cli/shared_options.hpp"
#include "report/depfile.hpp"
#include "report/program/batch_text.hpp"

namespace plumbline::cli {
namespace {

using State = jobs::BatchItem::State;

struct BatchArguments {
  std::string json, depfile;
  bool watch = false;
  double poll_s = 0;  // 0: the system tells
  batch::Request request;
  SharedOptions shared;
};

// What is told while it goes on.
class Telling {
 public:
  /// Lines of JSON go into the file, or to standard output as they come, in place of the table.
  Telling(OutputFile* json, bool says_json) : json_(json), says_json_(says_json) {}

  batch::Observer observer() {
    return {[this](const jobs::BatchItem& item) { tell(item); }, line_.progress()};
  }
  void clear() { line_.clear(); }
  /// What was said is said anew.
  void forget() { said_.clear(); }

  void tell(const jobs::BatchItem& item) {
    if (json_ != nullptr) json_->write(report::batch_json_line(item));
    if (item.state == State::subprogram) {
      say_step(fmt::format("{}: others call it, it is no program of its own", item.program));
      return;
    }
    const bool is_verbose = loudness() == Loudness::verbose;
    const bool is_shown = item.state == State::done || item.state == State::failed || is_verbose;
    if (is_shown || !item.diagnostics.empty()) line_.clear();
    for (const Diagnostic& one : item.diagnostics) {
      if (said_.insert(to_text(one)).second) say(one);  // settings may be refused for many programs alike
    }
    if (says_json_ && json_ == nullptr) print_result(report::batch_json_line(item));
    if (!is_shown || says_json_) return;
    print_result((has_heading_ ? "" : report::batch_heading()) + report::batch_line(item));
    has_heading_ = true;
  }

 private:
  OutputFile* json_;
  bool says_json_;
  bool has_heading_ = false;
  std::set<std::string> said_;
  ProgressLine line_{"batch"};
};

void say_vanished(const std::string& output) {
  Place place;
  place.file = output;
  say({"batch-vanished", "the program that it was made of is gone", "remove it too, if the program is no more", place,
       Severity::warning});
}

void say_what_is_left(const jobs::BatchSummary& summary) {
  for (const std::string& file : summary.passed_over) say_step(fmt::format("{}: no program, passed over", file));
  for (const std::string& output : summary.vanished) say_vanished(output);
  for (const std::string& program : summary.among_outputs) {
    Place place;
    place.file = program;
    say({"batch-among-outputs", "lies among the outputs and is none: it was not corrected",
         "put it where the other programs are, or give another folder with -o", place, Severity::warning});
  }
}

// What does not fit together. Outputs of the command itself; those of the programs are looked at one by one.
batch::Request checked_request(const BatchArguments& arguments) {
  batch::Request request = arguments.request;
  batch::ProgramRequest& programs = request.programs;
  if (programs.folder.empty() && programs.list.empty()) throw UsageError("FOLDER is required, or --list FILE");
  if (programs.folder.empty()) programs.folder = ".";
  std::error_code none;
  if (std::filesystem::is_regular_file(path_of(programs.folder), none)) {
    throw UsageError(
        fmt::format("{} is a file: --list reads the names of programs from a file, and compensate takes a "
                    "program",
                    programs.folder));
  }
  if (arguments.watch && !programs.list.empty()) throw UsageError("--watch looks at a folder, not at a --list");
  if (arguments.watch && !arguments.depfile.empty())
    throw UsageError("--watch has no end at which --depfile is written");
  if (arguments.watch && !arguments.json.empty() && arguments.json != kStandardStream)
    throw UsageError("--watch has no end at which a file is whole: --json - writes each line to standard output");
  if (arguments.poll_s > 0 && !arguments.watch) throw UsageError("--poll says how --watch looks: give that, too");
  check_outputs({programs.list}, {arguments.json, arguments.depfile, batch::record_path(request)});
  for (std::string& ending : programs.endings) {
    ending.erase(0, ending.find_first_not_of('.'));
    for (char& c : ending) c = lower(c);
  }
  request.settings = arguments.shared.request();
  const std::filesystem::path folder = path_of(arguments.shared.given().output_pattern).parent_path();
  if (!folder.empty() && folder != path_of("{folder}")) {
    throw UsageError(fmt::format(
        "--output-name {}: here it says how a file is called, as {{name}}_x{{ext}}, and -o in which folder it lies",
        arguments.shared.given().output_pattern));
  }
  return request;
}

int watch_folder(const BatchArguments& arguments, const batch::Request& request) {
  batch::FolderWatch::Settings how;
  if (arguments.poll_s > 0) {
    how.every = std::chrono::milliseconds(static_cast<std::int64_t>(arguments.poll_s / kMs));
    how.rest = *how.every;
  }
  Telling telling(nullptr, !arguments.json.empty());
  batch::Watcher watcher;
  watcher.item = [&](const jobs::BatchItem& item) {
    if (item.state != State::unchanged) telling.tell(item);
  };
  bool is_first = true;
  std::set<std::string> vanished;
  watcher.round = [&](const batch::Result& result) {
    telling.forget();
    std::set<std::string> now(result.summary.vanished.begin(), result.summary.vanished.end());
    for (const std::string& output : now) {
      if (!vanished.contains(output)) say_vanished(output);
    }
    vanished = std::move(now);
    if (is_first) say_note(report::batch_total(result.summary) + "waiting for programs\n");
    is_first = false;
  };
  watcher.warning = [](const Diagnostic& diagnostic) { say(diagnostic); };
  batch::watch(request, how, watcher);
  return kDone;
}

// Which files are read and made shows only when all programs have been.
void check_reports(const BatchArguments& arguments, std::vector<std::string> files,
                   const std::vector<std::string>& made) {
  std::vector<std::string> there;
  std::error_code none;
  for (const std::string& report : {arguments.json, arguments.depfile}) {
    if (report != kStandardStream && std::filesystem::exists(path_of(report), none)) there.push_back(report);
  }
  if (there.empty()) return;
  files.insert(files.end(), made.begin(), made.end());
  check_outputs(files, there);
}

int run_batch(const BatchArguments& arguments) {
  const batch::Request request = checked_request(arguments);
  if (arguments.watch) return watch_folder(arguments, request);
  NewFolder folder(request.programs.output);  // the files below may lie in it
  std::optional<OutputFile> json;
  if (!arguments.json.empty()) json.emplace(arguments.json);
  std::optional<OutputFile> depfile;
  if (!arguments.depfile.empty()) depfile.emplace(arguments.depfile);
  Telling telling(json ? &*json : nullptr, arguments.json == kStandardStream);
  batch::Observer observer = telling.observer();
  std::vector<std::string> outputs;
  observer.item = [&](const jobs::BatchItem& item) {
    outputs.push_back(item.output);
    telling.tell(item);
  };
  const batch::Result result = batch::run(request, observer);
  folder.keep();
  telling.clear();
  say_what_is_left(result.summary);
  check_reports(arguments, result.files_read, outputs);
  OutputSet files;
  if (depfile) {
    depfile->write(report::depfile_text(json ? arguments.json : batch::record_path(request), result.files_read));
    files.add(*depfile);
  }
  if (json) {
    json->write(report::batch_json_total(result.summary));
    files.add(*json);
  }
  files.commit();
  say_note(report::batch_total(result.summary));
  return result.summary.failed > 0 ? kFailed : kDone;
}

void add_own_options(CLI::App& command, BatchArguments& arguments) {
  batch::ProgramRequest& programs = arguments.request.programs;
  command.add_option("FOLDER", programs.folder, "the folder of the programs, with those in it")->type_name("FOLDER");
  command
      .add_option("--list", programs.list,
                  "compensate the programs that this file names, a line each; - for standard input")
      ->type_name("FILE");
  command.add_option("-o,--output", programs.output, "folder of the corrected programs, where each has the same place")
      ->type_name("FOLDER")
      ->required();
  command.add_option("--jobs", arguments.request.jobs, "programs at a time (default: one for each processor)")
      ->type_name("N")
      ->check(CLI::Range(1U, 1024U));
  command
      .add_option("--endings", programs.endings,
                  "what names of programs end with (default: nc, tap, cnc, eia, and what the controls call theirs)")
      ->type_name("NC,...")
      ->delimiter(',');
  command
      .add_option("--record", arguments.request.record,
                  fmt::format("where it is kept what was done (default: {} in the folder of -o)", batch::kRecordName))
      ->type_name("FILE");
  command.add_option("--json", arguments.json, "write a line of JSON for each program, its summary among it")
      ->type_name("FILE");
  command.add_flag("--watch", arguments.watch,
                   "go on, and take each program that comes into the folder once it is closed or has rested");
  command
      .add_option("--poll", arguments.poll_s,
                  "with --watch: look through the folder that often, for folders that other machines write into")
      ->type_name("SECONDS")
      ->check(number_between(0.1, 86400));
  command
      .add_option("--depfile", arguments.depfile,
                  "write which files were read, as a rule for make and ninja whose target is the file of --json, else "
                  "that of --record")
      ->type_name("FILE");
}

}  // namespace

void add_batch(CLI::App& app, Run& run) {
  CLI::App* const command = app.add_subcommand(
      "batch", "Correct all programs of a folder, several at a time, and of those done before only what has changed");
  const auto arguments = std::make_shared<BatchArguments>();
  add_own_options(*command, *arguments);
  using Group = settings::OptionGroup;
  arguments->shared.add_to(*command, {Group::model, Group::program, Group::step, Group::bound, Group::compensation});
  command->callback([arguments, &run] { run = [arguments] { return run_batch(*arguments); }; });
}

}  // namespace plumbline::cli
