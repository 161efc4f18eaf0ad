#include "api/plumbline.hpp"

#include <stdexcept>

#include <fmt/format.h>

#include "base/files/files.hpp"
#include "base/version.hpp"
#include "jobs/compensate/compensate_file.hpp"
#include "jobs/trace.hpp"
#include "machine/model_file.hpp"
#include "report/program/error_text.hpp"
#include "report/program/trace_text.hpp"
#include "settings/contradiction.hpp"

namespace plumbline::api {
namespace {

void require_model(const Options& options) {
  if (options.paths.model.empty()) throw std::invalid_argument("model: expected the path of a machine model");
}

void refuse_contradiction(const Options& options) {
  if (const std::optional<std::string> why = settings::contradiction(options)) throw std::invalid_argument(*why);
}

}  // namespace

std::string_view version() { return plumbline::version(); }

void set_option(Options& options, std::string_view name, std::string_view text) {
  const settings::OptionRow* const row = settings::find_option(name);
  if (row == nullptr) throw std::invalid_argument(fmt::format("there is no option {}", name));
  try {
    settings::set_option(options, *row, text);
  } catch (const settings::OptionError& error) {
    throw std::invalid_argument(fmt::format("{}: {}", name, error.what()));
  }
}

CompensationSummary compensate(const std::string& program, const std::string& output, const Options& options,
                               const Progress& progress) {
  require_model(options);
  refuse_contradiction(options);
  return jobs::compensate_file(program, output, options, progress);
}

ErrorSummary error(const std::string& poses, const std::string& model, const std::string& output) {
  const machine::MachineModel machine = machine::read_model(model);
  const std::vector<jobs::PoseRow> rows = jobs::read_poses(poses);
  OutputFile out(output);
  report::ErrorTable table(out);
  const ErrorSummary summary =
      jobs::error_table(machine, rows, [&](const jobs::PoseError& error) { table.add(error); });
  out.commit();
  return summary;
}

void trace(const std::string& program, const std::string& output, const Options& options, const Progress& progress) {
  OutputFile out(output);
  report::TraceWriter writer(out);
  jobs::trace_file(
      program, options, [&](const nc::Motion& motion) { writer.add(motion); }, progress);
  writer.flush();
  out.commit();
}

CheckSummary check(const std::string& program, const Options& options, const Progress& progress) {
  require_model(options);
  refuse_contradiction(options);
  return jobs::check_file(program, options, progress);
}

}  // namespace plumbline::api
