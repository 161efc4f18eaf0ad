#include "jobs/compensate/compensate_file.hpp"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "base/diagnostic.hpp"
#include "base/files/files.hpp"
#include "base/text/hash.hpp"
#include "compensate/stream.hpp"
#include "jobs/compensate/compensated_files.hpp"
#include "jobs/compensate/guard_block.hpp"
#include "jobs/compensate/stamp.hpp"
#include "jobs/program/open_program.hpp"
#include "jobs/program/survey_program.hpp"
#include "machine/model_file.hpp"

namespace plumbline::jobs {
namespace {

// Which files are called shows only when the program has run.
void refuse_overwriting_subprogram(const compensate::Summary& summary, const Destination& output) {
  if (output.is_taken()) return;
  for (const compensate::Summary::InlinedFile& file : summary.inlined_files) {
    if (!InputFile(file.name).is_same_as(output.name())) continue;
    refuse("file-overwrites-input", fmt::format("the output would overwrite the subprogram {}", file.name),
           "name another file for the output", Place{.file = output.name()});
  }
}

std::optional<Destination> undo_destination(const Destination& output, const Destination& undo,
                                            const settings::Options& options) {
  if (!options.undo) return std::nullopt;
  return undo.empty() ? Destination(undo_name(output.name())) : undo;
}

std::vector<std::string> names_of(const std::vector<ReportFile>& reports) {
  std::vector<std::string> names;
  for (const ReportFile& report : reports) names.push_back(report.path);
  return names;
}

std::string text_of(OutputFile& program, std::uint64_t begin, std::uint64_t end) {
  std::string text(end - begin, '\0');
  text.resize(program.read(begin, text.data(), text.size()));
  return text;
}

std::optional<compensate::DrawnPath> drawn(std::optional<compensate::PathRecord>& record,
                                           const machine::MachineModel& model, const compensate::Settings& settings,
                                           OutputFile& program) {
  if (!record) return std::nullopt;
  program.flush();
  return compensate::drawn_path(*record, model, settings,
                                [&](std::uint64_t begin, std::uint64_t end) { return text_of(program, begin, end); });
}

std::uint64_t content_hash(const InputFile& file) {
  std::string chunk(std::size_t{1} << 16U, '\0');
  std::uint64_t hash = fnv1a({});
  for (std::uint64_t at = 0;;) {
    const std::size_t got = file.read(at, chunk.data(), chunk.size());
    if (got == 0) return hash;
    hash = fnv1a({chunk.data(), got}, hash);
    at += got;
  }
}

compensate::MadeOf made_of(const OpenedProgram& program, const machine::MachineModel& model,
                           const settings::Options& options, const std::vector<nc::Tool>& tools) {
  compensate::MadeOf of{
      program.file.name(), 0, program.dialect.name, model.name, options.paths.model.name(), model.hash, {}, tools};
  for (std::size_t i = 0; i < program.settings.work_offsets.size(); ++i) {
    const auto& offset = program.settings.work_offsets[i];
    if (!offset) continue;
    of.offsets.push_back(
        {program.dialect.name_of_system(static_cast<int>(i) + 1), offset->origin, offset->rotation_deg});
  }
  return of;
}

}  // namespace

nc::EmitSettings emit_settings(const machine::ControlSettings& control, const nc::Dialect& dialect,
                               const settings::Options& options) {
  nc::EmitSettings emit = options.emit;
  emit.digits_mm = control.digits_mm;
  emit.digits_deg = control.digits_deg;
  emit.digits_inch = control.digits_inch;
  emit.increment_mm = control.increment_mm;
  emit.increment_deg = control.increment_deg;
  if (options.program.input_increment && dialect.behaviour.increment_mm > 0)
    emit.increment_ratio = *options.program.input_increment / dialect.behaviour.increment_mm;
  return emit;
}

compensate::Settings compensation_settings(const machine::ControlSettings& control, const nc::Dialect& dialect,
                                           const settings::Options& options) {
  compensate::Settings compensation = options.compensation;
  compensation.step.least_time_s = control.block_time;
  // A block may become shorter by the time tolerance.
  const double longer = 1 + 2 * options.emit.time_tolerance;
  compensate::BoundSettings& bound = compensation.bound;
  bound.least_time_s = (control.block_time > 0 ? control.block_time : bound.least_time_s) * longer;
  const double largest = nc::largest_inverse_feed(dialect.behaviour);
  if (largest > 0) {
    constexpr double kMinute = 60;
    bound.least_inverse_time_s = compensation.step.least_inverse_time_s = kMinute / largest * longer;
  }
  return compensation;
}

compensate::Summary compensate_file(const Source& program, const Destination& output, const settings::Options& options,
                                    const Progress& progress, const std::vector<ReportFile>& reports,
                                    const Destination& undo, Expectation* expected) {
  const machine::MachineModel model = machine::read_model(options.paths.model);
  return compensate_opened(open_program(options, program, model), model, output, options, progress, reports, undo,
                           expected);
}

compensate::Summary compensate_opened(const OpenedProgram& opened, const machine::MachineModel& model,
                                      const Destination& output, const settings::Options& options,
                                      const Progress& progress, const std::vector<ReportFile>& reports,
                                      const Destination& undo, Expectation* expected) {
  const auto& [source, dialect, settings] = opened;
  nc::EmitSettings emit = emit_settings(model.control, dialect, options);
  const compensate::ProgramSurvey survey = survey_program(opened);
  emit.stamp = stamp(options, settings, model, survey);
  if (options.guard) {
    refuse_guard_before_definitions(source, dialect);
    emit.guard = guard_block(settings, survey);
  }
  const compensate::Settings compensation = compensation_settings(model.control, dialect, options);

  const auto draws = [](const ReportFile& report) { return report.draws_path; };
  const bool tells_hash = !std::all_of(reports.begin(), reports.end(), draws);
  CompensatedFiles files(output, undo_destination(output, undo, options), names_of(reports), tells_hash);
  compensate::Stream stream(source, survey, settings, model, compensation, std::move(emit), files.program());
  if (nc::UndoLog* const log = files.undo_log()) stream.record(*log);
  std::optional<compensate::PathRecord> record;
  if (std::any_of(reports.begin(), reports.end(), draws)) stream.record(record.emplace(model, compensation));
  ExpectedAlong along(model, compensation, expected != nullptr);
  if (along.asks()) stream.sample(along.samples());
  compensate::Summary summary = stream.run(progress);
  refuse_overwriting_subprogram(summary, output);
  summary.bytes_after = files.program().size();
  summary.made_of = made_of(opened, model, options, survey.tools);
  if (files.keeps_hash()) {
    summary.hash_after = files.program().hash();
    summary.made_of.program_hash = content_hash(source);
  }
  const std::optional<compensate::DrawnPath> path = drawn(record, model, compensation, files.program());
  const Expectation expectation = along.take(path ? &*path : nullptr);
  if (expected != nullptr) *expected = expectation;
  for (auto file = files.reports().begin(); const ReportFile& report : reports) {
    report.write({summary, model, expectation, path ? &*path : nullptr}, *file++);
  }
  files.commit(source);
  return summary;
}

std::optional<Diagnostic> refusal_of_writing(const OpenedProgram& opened, const compensate::ProgramSurvey& survey,
                                             const machine::MachineModel& model, const settings::Options& options) {
  compensate::Settings compensation = compensation_settings(model.control, opened.dialect, options);
  compensation.read_back = false;
  OutputFile nowhere("/dev/null");
  compensate::Stream stream(opened.file, survey, opened.settings, model, compensation,
                            emit_settings(model.control, opened.dialect, options), nowhere);
  try {
    stream.run();
  } catch (const Refusal& refusal) {
    return refusal.diagnostic();
  }
  return std::nullopt;
}

}  // namespace plumbline::jobs
