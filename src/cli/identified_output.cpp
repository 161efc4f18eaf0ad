#include "cli/identified_output.hpp"

#include <cstdio>
#include <optional>

#include <fmt/format.h>

#include "base/files.hpp"
#include "cli/command_files.hpp"

namespace plumbline::cli {

void add_identified_output(CLI::App& command, std::string& output, std::string& json) {
  command
      .add_option("-o,--output", output,
                  "the model with what was found: the same text, comments and all, but for the numbers")
      ->type_name("MODEL2")
      ->required();
  command.add_option("--json", json, "write values, errors, correlations and the gap as JSON, too")->type_name("FILE");
}

int write_identified(const std::vector<std::string>& inputs, const std::string& output, const std::string& json,
                     const std::function<jobs::IdentifiedModel()>& make) {
  check_outputs(inputs, {output, json});
  OutputFile out(output);
  std::optional<OutputFile> json_out;
  if (!json.empty()) json_out.emplace(json);
  const jobs::IdentifiedModel identified = make();
  const bool standard_taken = output == kStandardStream || json == kStandardStream;
  fmt::print(standard_taken ? stderr : stdout, "{}", jobs::identification_text(identified.found));
  if (json_out) {
    json_out->write(jobs::identification_json(identified.found));
    json_out->commit();
  }
  if (!identified.found.converged()) {
    fmt::print(stderr, "not converged: {} is not written\n", output);
    return kFailed;
  }
  out.write(identified.text);
  out.commit();
  return kDone;
}

}  // namespace plumbline::cli
