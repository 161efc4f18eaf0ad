#include "batch/work.hpp"

#include <filesystem>
#include <new>
#include <set>
#include <system_error>

#include <fmt/format.h>

#include "base/files/files.hpp"
#include "base/files/files_beside.hpp"
#include "base/files/path_of.hpp"
#include "base/text/hash.hpp"
#include "base/version.hpp"
#include "batch/freshness.hpp"
#include "batch/program_list.hpp"
#include "compensate/stamp_mark.hpp"
#include "jobs/compensate/compensate_file.hpp"
#include "jobs/compensate/compensated_files.hpp"
#include "report/program/summary_text.hpp"

namespace plumbline::batch {
namespace {

namespace fs = std::filesystem;

void refuse_strange_output(const std::string& output) {
  std::error_code none;
  if (!fs::is_regular_file(path_of(output), none) || compensate::is_compensated(InputFile(output))) return;
  Place place;
  place.file = output;
  refuse("file-exists", fmt::format("{} stands there already, and is no compensated program", output),
         "move it away, or give another folder with -o", place);
}

// Of the program itself, not of a file that it calls.
bool is_about_stamp(const jobs::BatchItem& item) {
  const Diagnostic& why = item.diagnostics.front();
  return why.code == "compensate-stamped" && why.place.file == item.program;
}

std::vector<CalledFile> called_files(const FilesBeside& beside, const std::string& program) {
  const fs::path folder = path_of(program).parent_path();
  std::vector<CalledFile> called;
  for (const FilesBeside::Sought& one : beside.files()) {
    CalledFile file{one.name, {}, {}};
    if (!one.path.empty()) {
      const std::int64_t now = now_ns();
      const std::optional<FileState> state = file_state(one.path);
      file.path = folder.empty() ? one.path : path_of(one.path).lexically_relative(folder).generic_string();
      if (state) file.file = known_file(*state, file_hash(one.path), now);
    }
    called.push_back(std::move(file));
  }
  return called;
}

void compensate_into(Work& work, const FolderSettings& settings, const FilesBeside& beside) {
  const Task& task = work.task;
  const std::int64_t begin = now_ns();
  // Before anything is read: what is written to from here on looks changed next time.
  const std::optional<FileState> state = file_state(task.program);
  const std::int64_t folder_changed_ns = folder_change(task.program);
  const jobs::OpenedProgram opened = jobs::open_program(settings.options, task.program, settings.program);
  work.output = std::make_unique<WaitingOutput>(task.output);
  Destination undo;
  if (settings.options.undo) {
    work.undo = std::make_unique<WaitingOutput>(jobs::undo_name(task.output));
    undo = work.undo->destination();
  }
  const compensate::Summary summary =
      jobs::compensate_opened(opened, *settings.model, work.output->destination(), settings.options, {}, {}, undo);
  work.item.diagnostics = summary.warnings;
  work.item.summary = report::summary_json_line(summary, settings.options);
  Entry& entry = work.entry;
  entry.place = task.place;
  entry.source = whole_path(task.program);
  entry.settings = settings.hash;
  entry.dialect = opened.dialect.name;
  entry.called = called_files(beside, task.program);
  for (const FilesBeside::Sought& one : beside.files()) work.called.push_back(one.path);
  entry.folder_changed_ns = folder_changed_ns;
  entry.has_undo = settings.options.undo;
  entry.summary = work.item.summary;
  if (state) entry.program = known_file(*state, summary.made_of.program_hash, begin);
  opened.file.check_unchanged();
}

}  // namespace

Diagnostic current_problem(const std::string& program) {
  Place place;
  place.file = program;
  try {
    throw;
  } catch (const Refusal& refusal) {
    return refusal.diagnostic();
  } catch (const std::bad_alloc&) {
    return {"out-of-memory", "there is not enough memory for this", "let fewer programs be done at a time with --jobs",
            place};
  } catch (const std::system_error& error) {
    return {"system-refused", fmt::format("the system does not let it go on: {}", error.what()),
            "look at the limits of processes, threads and open files (ulimit -a)", place};
  } catch (const std::exception& error) {
    return {"internal-error", fmt::format("this is a bug in plumbline {}: {}", version(), error.what()),
            "please report it with the command, the program and the model", place};
  }
}

Work failed(const Task& task, const Diagnostic& why, bool stays) {
  Work work;
  work.task = task;
  work.item.program = task.program;
  work.item.output = task.output;
  work.item.state = jobs::BatchItem::State::failed;
  work.item.diagnostics.push_back(why);
  if (stays) {
    Place place;
    place.file = task.output;
    work.item.diagnostics.push_back({"batch-old-output", "was made in an earlier run, from other input than today's",
                                     "do not run it: it is replaced once its program can be compensated", place,
                                     Severity::warning});
  }
  return work;
}

Work compensate_one(const Task& task, const FolderSettings& settings, const std::optional<Entry>& known) {
  const FilesBeside beside(task.program);
  try {
    if (!known) refuse_strange_output(task.output);
    Work work;
    work.task = task;
    work.item.program = task.program;
    work.item.output = task.output;
    compensate_into(work, settings, beside);
    return work;
  } catch (...) {
    std::error_code none;
    const bool stays = known && fs::exists(path_of(task.output), none);
    Work work = failed(task, current_problem(task.program), stays);
    if (!stays && is_about_stamp(work.item)) work.item.state = jobs::BatchItem::State::compensated;
    for (const FilesBeside::Sought& one : beside.files()) work.called.push_back(one.path);
    return work;
  }
}

}  // namespace plumbline::batch
