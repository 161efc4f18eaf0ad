#include "api/plumbline.hpp"

#include <stdexcept>

#include <fmt/format.h>

#include "base/files.hpp"
#include "jobs/compensate_file.hpp"
#include "jobs/program_dialect.hpp"
#include "jobs/trace.hpp"
#include "jobs/version.hpp"
#include "machine/model_file.hpp"

namespace plumbline::api {
namespace {

void require_model(const Options& options) {
  if (options.model.empty()) throw std::invalid_argument("model: expected the path of a machine model");
}

}  // namespace

std::string_view version() { return jobs::version(); }

void set_option(Options& options, std::string_view name, std::string_view text) {
  const jobs::OptionRow* const row = jobs::find_option(name);
  if (row == nullptr) throw std::invalid_argument(fmt::format("there is no option {}", name));
  try {
    jobs::set_option(options, *row, text);
  } catch (const jobs::OptionError& error) {
    throw std::invalid_argument(fmt::format("{}: {}", name, error.what()));
  }
}

CompensationSummary compensate(const std::string& program, const std::string& output, const Options& options,
                               const Progress& progress) {
  require_model(options);
  return jobs::compensate_file(program, output, options, progress);
}

ErrorSummary error(const std::string& poses, const std::string& model, const std::string& output) {
  const machine::MachineModel machine = machine::read_model(model);
  const std::vector<jobs::PoseRow> rows = jobs::read_poses(poses);
  OutputFile out(output);
  const ErrorSummary summary = jobs::write_error_table(machine, rows, out);
  out.commit();
  return summary;
}

void trace(const std::string& program, const std::string& output, const Options& options, const Progress& progress) {
  nc::ProgramSettings settings = jobs::program_settings(options);
  settings.as_with_empty_tables = true;
  const InputFile source(program);
  OutputFile out(output);
  plumbline::trace(source, jobs::dialect_of(options, source), std::move(settings), out, progress);
  out.commit();
}

CheckSummary check(const std::string& program, const Options& options, const Progress& progress) {
  require_model(options);
  return jobs::check_file(program, options, progress);
}

}  // namespace plumbline::api
