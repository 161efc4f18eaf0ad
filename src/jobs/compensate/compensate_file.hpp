// A program file compensated into another one.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostic.hpp"
#include "base/files/destination.hpp"
#include "base/files/source.hpp"
#include "base/progress.hpp"
#include "compensate/program_survey.hpp"
#include "compensate/recorded/drawn_path.hpp"
#include "compensate/settings.hpp"
#include "compensate/summary.hpp"
#include "jobs/expected/expected_error.hpp"
#include "jobs/program/open_program.hpp"
#include "machine/model.hpp"
#include "settings/options.hpp"

namespace plumbline::jobs {

/// What is known of a compensation at its end.
struct Compensation {
  const compensate::Summary& summary;
  const machine::MachineModel& model;
  const Expectation& expected;
  const compensate::DrawnPath* path = nullptr;  // where a report asks for it
};

/// A file that tells of it, which appears together with the program.
struct ReportFile {
  std::string path;
  std::function<void(const Compensation&, OutputFile&)> write;
  bool draws_path = false;  // a page, which tells no hash
};

/// How a program is compensated for a control: the options, and the time that the model says a block takes.
compensate::Settings compensation_settings(const machine::ControlSettings& control, const nc::Dialect& dialect,
                                           const settings::Options& options);

/// How its words are written for it.
nc::EmitSettings emit_settings(const machine::ControlSettings& control, const nc::Dialect& dialect,
                               const settings::Options& options);

/// Compensates `program` into `output` ("-": standard input and output) as `options` say, which name the model; what
/// the output replaced, where they ask for it, into `undo` (empty: beside the output). `expected`, where it is not
/// null, gets what is expected to be left at the tip. Nothing is written unless all of it succeeds. Refuses what the
/// readers, the interpreter and the compensation refuse.
compensate::Summary compensate_file(const Source& program, const Destination& output, const settings::Options& options,
                                    const Progress& progress = {}, const std::vector<ReportFile>& reports = {},
                                    const Destination& undo = {}, Expectation* expected = nullptr);

/// The same of a program that is open, on a model that was read before: once for many.
compensate::Summary compensate_opened(const OpenedProgram& opened, const machine::MachineModel& model,
                                      const Destination& output, const settings::Options& options,
                                      const Progress& progress = {}, const std::vector<ReportFile>& reports = {},
                                      const Destination& undo = {}, Expectation* expected = nullptr);

/// What compensate_file would refuse, if anything; nothing is written. Its guard and its read-back are left out.
std::optional<Diagnostic> refusal_of_writing(const OpenedProgram& opened, const compensate::ProgramSurvey& survey,
                                             const machine::MachineModel& model, const settings::Options& options);

}  // namespace plumbline::jobs
