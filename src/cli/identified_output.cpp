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
  const std::string numbers = jobs::identification_json(identified.found);
  if (!identified.found.converged()) {
    json_result.give(words, numbers);
    refuse("identify-not-converged", fmt::format("the fit did not converge: {} is not written", output),
           "give fewer unknowns by --free, or priors for them in [uncertainty]; check that the dataset belongs to "
           "this machine");
  }
  OutputSet files;
  json_result.add_to(files, numbers);
  out.write(identified.text);
  files.add(out);
  files.commit();
  if (!json_result.takes_standard_output()) print_result(words);
  return kDone;
}

}  // namespace plumbline::cli
