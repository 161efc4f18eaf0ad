// What plumbline does, as functions: paths and options in, summaries out. "-" as a path is standard input or output.
// Every function throws plumbline::Refusal (base/diagnostic.hpp) at input that it will not take, with file, line,
// column and the way out, and writes nothing then. An InternalError (base/check.hpp) is a bug of plumbline. No function
// prints, keeps state or depends on the locale; different files may be handled by different threads.
#pragma once

#include <string>
#include <string_view>

#include "base/check.hpp"
#include "base/diagnostic.hpp"
#include "base/progress.hpp"
#include "compensate/summary.hpp"
#include "jobs/check.hpp"
#include "jobs/error_table.hpp"
#include "settings/options.hpp"

namespace plumbline::api {

using CheckSummary = jobs::CheckSummary;
using CompensationSummary = compensate::Summary;
using ErrorSummary = jobs::ErrorTableSummary;
/// What the program's text does not say, the model's path and how to compensate: settings/options.hpp. Set the fields,
/// or set_option() by name and text as on the command line.
using Options = settings::Options;

/// "0.1.0"
std::string_view version();

/// Sets one option by its long name ("work-offset") from the text that the command line takes
/// ("G54=0,0,-1008,0,0,0", mm and deg; "on" for a switch). Throws std::invalid_argument that says what is expected.
void set_option(Options& options, std::string_view name, std::string_view text);

/// Corrects a program for the machine `options.paths.model`, and writes the corrected one, with options.undo
/// OUTPUT.undo too. The summary is in mm, deg and s; its lines are those of `program`. Throws std::invalid_argument if
/// no model is named, and if options contradict each other (settings::contradiction).
CompensationSummary compensate(const std::string& program, const std::string& output, const Options& options,
                               const Progress& progress = {});

/// Tabulates strut lengths (mm), nut tensions (N), stretches (um) and the error of the tool tip (um, urad; in W) at the
/// poses of a CSV file (x_mm,y_mm,z_mm,a_deg,b_deg,c_deg: the tool tip in W), the machine at rest, into a CSV file.
/// Refuses with error-unreachable a pose where the machine cannot stand.
ErrorSummary error(const std::string& poses, const std::string& model, const std::string& output);

/// Writes the interpreted motion of a program, one JSON object a line (mm, deg; `to` in the active work system,
/// `machine` the control's display) [docs/formats.md]. What nobody gave is zero; no model is needed.
void trace(const std::string& program, const std::string& output, const Options& options,
           const Progress& progress = {});

/// Finds all places where a program, compensated, breaks limits of the machine `options.paths.model`; writes nothing.
/// That there are some is no error: the summary counts them. Throws as compensate().
CheckSummary check(const std::string& program, const Options& options, const Progress& progress = {});

}  // namespace plumbline::api
