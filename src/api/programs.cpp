// What is done with programs.
#include <plumbline/plumbline.hpp>

#include "api/files_of_call.hpp"
#include "api/given_options.hpp"
#include "api/guarded.hpp"
#include "api/inside.hpp"
#include "jobs/check.hpp"
#include "jobs/compensate/compensate_file.hpp"
#include "jobs/compensate/compensated_files.hpp"
#include "jobs/diff/diff.hpp"
#include "jobs/trace.hpp"
#include "nc/rewrite/output/undo.hpp"
#include "report/program/check_text.hpp"
#include "report/program/diff_text.hpp"
#include "report/program/summary_text.hpp"
#include "report/program/trace_text.hpp"

namespace plumbline::api {
namespace {

using Group = settings::OptionGroup;

constexpr double kEqual = 1e-4;  // mm and deg, as of the command

std::vector<Diagnostic> public_diagnostics(const std::vector<plumbline::Diagnostic>& all) {
  std::vector<Diagnostic> diagnostics;
  for (const plumbline::Diagnostic& one : all) diagnostics.push_back(public_diagnostic(one));
  return diagnostics;
}

// With the call's own destination of what was replaced.
Destination undo_of(const Output& output, const Output& undo, settings::Options& options) {
  if (!Inside::is_nothing(undo)) {
    options.undo = true;
    return Inside::destination(undo);
  }
  const Destination to = Inside::destination(output);
  if (options.undo && to.is_taken()) {
    wrong_usage("undo writes a file beside an output that is one", "say with the argument `undo` where it goes");
  }
  return options.undo ? Destination(jobs::undo_name(to.name())) : Destination();
}

}  // namespace

inline namespace v1 {

Result compensate(const Input& program, const Model& model, const Options& options, const Output& output,
                  const Output& undo, const Progress& progress) {
  return guarded([&] {
    const GivenOptions given(options, {Group::program, Group::step, Group::bound, Group::compensation});
    settings::Options how = given.machine_options(model);
    const Destination to = Inside::destination(output);
    const Destination undo_to = undo_of(output, undo, how);
    refuse_shared_files(files_read(program, how), files_written({to, undo_to}));
    jobs::Expectation expected;
    const compensate::Summary summary =
        jobs::compensate_file(Inside::source(program), to, how, progress, {}, undo_to, &expected);
    Inside::Found found;
    found.json = report::summary_json(summary, how, expected.error);
    found.words = report::summary_text(summary, how, expected.error);
    found.warnings = public_diagnostics(summary.warnings);
    if (expected.warning) found.warnings.push_back(public_diagnostic(*expected.warning));
    return Inside::result(std::move(found));
  });
}

Result check(const Input& program, const Model& model, const Options& options, const Progress& progress) {
  return guarded([&] {
    const GivenOptions given(options, {Group::program, Group::step, Group::bound});
    const jobs::CheckSummary summary =
        jobs::check_file(Inside::source(program), given.machine_options(model), progress);
    Inside::Found found;
    found.json = report::check_json(summary);
    found.words = report::check_text(summary);
    found.found = summary.violations > 0;
    if (summary.expected.warning) found.warnings.push_back(public_diagnostic(*summary.expected.warning));
    if (summary.refusal) {
      Diagnostic& warning = found.warnings.emplace_back(public_diagnostic(*summary.refusal));
      warning.severity = Severity::warning;
      warning.message = "compensate would refuse this: " + warning.message;
    }
    return Inside::result(std::move(found));
  });
}

Result diff(const Input& a, const Input& b, const Options& options, const Model& model, const Progress& progress) {
  return guarded([&] {
    const GivenOptions given(options, {Group::program}, {"tolerance-mm", "tolerance-deg"});
    const double tolerance_mm = given.number("tolerance-mm").value_or(kEqual);
    const double tolerance_deg = given.number("tolerance-deg").value_or(kEqual);
    const jobs::DiffSummary summary =
        jobs::diff_files(Inside::source(a), Inside::source(b), given.program_options(model), progress);
    Inside::Found found;
    found.json = report::diff_json(summary);
    found.words = report::diff_text(summary);
    found.found = !summary.equal_within(tolerance_mm, tolerance_deg);
    return Inside::result(std::move(found));
  });
}

void trace(const Input& program, const Options& options, const Output& output, const Model& model,
           const Progress& progress) {
  guarded([&] {
    const GivenOptions given(options, {Group::program});
    const settings::Options how = given.program_options(model);
    const Destination to = Inside::destination(output);
    refuse_shared_files(files_read(program, how), files_written({to}));
    OutputFile out(to);
    report::TraceWriter writer(out);
    jobs::trace_file(
        Inside::source(program), how, [&](const nc::Motion& motion) { writer.add(motion); }, progress);
    writer.flush();
    out.commit();
  });
}

void restore(const Input& program, const Input& undo, const Output& output) {
  guarded([&] {
    const Destination to = Inside::destination(output);
    const Source compensated = Inside::source(program);
    const Source log = Inside::source(undo);
    refuse_shared_files(file_names({compensated, log}), files_written({to}));
    OutputFile out(to);
    const auto [program_file, undo_file] = jobs::open_pair(compensated, log);
    nc::restore(program_file, undo_file, out);
    program_file.check_unchanged();
    undo_file.check_unchanged();
    out.commit();
  });
}

}  // namespace v1
}  // namespace plumbline::api
