#include <memory>

#include "cli/command.hpp"
#include "cli/messages.hpp"
#include "report/explain.hpp"

namespace plumbline::cli {

void add_explain(CLI::App& app, Run& run) {
  CLI::App* const command =
      app.add_subcommand("explain",
                         "Say what the code of a message means, as in nc-unknown-code, and what to do; without a code "
                         "list them all");
  const auto code = std::make_shared<std::string>();
  command->add_option("CODE", *code, "the code, as it stands in brackets after a message")->type_name("TEXT");
  command->callback([code, &run] {
    run = [code] {
      print_result(code->empty() ? report::explain_list() : report::explain_text(*code));
      return kDone;
    };
  });
}

}  // namespace plumbline::cli
