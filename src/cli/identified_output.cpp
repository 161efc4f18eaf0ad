#include "cli/identified_output.hpp"

#include <fmt/format.h>

#include "base/files.hpp"
#include "cli/command_files.hpp"
#include "cli/messages.hpp"

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
  JsonResult json_result(json);
  const jobs::IdentifiedModel identified = make();
  std::string words = jobs::identification_text(identified.found);
  if (output == kStandardStream) {
    say_note(words);
    words.clear();
  }
  json_result.give(words, jobs::identification_json(identified.found));
  if (!identified.found.converged()) {
    refuse("identify-not-converged", fmt::format("the fit did not converge: {} is not written", output),
           "give fewer unknowns by --free, or priors for them in [uncertainty]; check that the dataset belongs to "
           "this machine");
  }
  out.write(identified.text);
  out.commit();
  return kDone;
}

}  // namespace plumbline::cli
