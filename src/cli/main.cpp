// plumbline: the command line. Exit codes: 0 done, 1 the work failed, 2 wrong usage, 3 done and something was found.
#include <cstdio>
#include <new>
#include <optional>
#include <span>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "base/check.hpp"
#include "base/diagnostic.hpp"
#include "base/files/ending_signals.hpp"
#include "base/platform/platform.hpp"
#include "base/version.hpp"
#include "cli/application/application.hpp"
#include "cli/application/description.hpp"
#include "cli/application/given_values.hpp"
#include "cli/application/suggest.hpp"
#include "cli/messages.hpp"

namespace plumbline::cli {
namespace {

int wrong_usage(const CLI::App& app, const std::string& message) {
  const std::vector<CLI::App*> asked = const_cast<CLI::App&>(app).get_subcommands();
  const std::string command = asked.empty() ? "" : " " + asked.front()->get_name();
  if (says_json()) {
    say({"usage-wrong", message, fmt::format("plumbline{} --help says more", command), {}, Severity::error});
    return kWrongUsage;
  }
  put_message(fmt::format("plumbline{}: {}\nplumbline{} --help says more\n", command, message, command));
  return kWrongUsage;
}

int broken(const char* what) {
  constexpr const char* kHelp = "please report it with the command, the program and the model";
  const std::string message = fmt::format("this is a bug in plumbline {}: {}", plumbline::version(), what);
  if (says_json()) {
    say({"internal-error", message, kHelp, {}, Severity::error});
  } else {
    put_message(fmt::format("plumbline: {}\n{}\n", message, kHelp));
  }
  return kFailed;
}

int refused(const Diagnostic& diagnostic) {
  say(diagnostic);
  if (!says_json() && diagnostic.code != "explain-unknown-code")
    put_message(fmt::format("plumbline explain {} says more\n", diagnostic.code));
  return kFailed;
}

// Looked for beforehand: even what is wrong with the command line is said in the form that was asked for.
bool asks_for_json(std::span<const char* const> arguments) {
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string_view argument = arguments[i];
    if (argument == "--") return false;
    if (argument == "--diagnostics=json") return true;
    if (argument == "--diagnostics" && i + 1 < arguments.size() && std::string_view(arguments[i + 1]) == "json") {
      return true;
    }
  }
  return false;
}

// The help and the version are results, too: they may not fit where standard output goes.
int answer(const CLI::App& app, const CLI::ParseError& asked) {
  std::ostringstream text;
  std::ostringstream none;
  const int code = app.exit(asked, text, none);
  print_result(text.str());
  return code;
}

// Of an option that is known and stands where it may.
bool is_value(const CLI::ParseError& error) {
  return dynamic_cast<const CLI::ValidationError*>(&error) != nullptr ||
         dynamic_cast<const CLI::ConversionError*>(&error) != nullptr;
}

int parse_and_run(CLI::App& app, Run& run, std::span<const char* const> arguments) {
  try {
    app.parse(static_cast<int>(arguments.size()), arguments.data());
    refuse_odd_values(app);
    refuse_strange_results(app);
    return run();
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return answer(app, error);  // --help, --version
    return wrong_usage(app, is_value(error) ? error.what() : what_is_wrong(app, arguments).value_or(error.what()));
  } catch (const UsageError& error) {
    return wrong_usage(app, error.what());
  }
}

int out_of_memory() {
  return refused({"out-of-memory",
                  "there is not enough memory for this",
                  "give it less at once: a shorter program, fewer runs or samples; or let it have more (ulimit -v)",
                  {},
                  Severity::error});
}

int out_of_resources(const std::system_error& error) {
  return refused({"system-refused",
                  fmt::format("the system does not let it go on: {}", error.what()),
                  "look at the limits of processes, threads and open files (ulimit -a)",
                  {},
                  Severity::error});
}

// Nothing: the command line could not be read, and the whole application says why.
std::optional<int> run_one(std::span<const char* const> arguments) {
  const std::optional<std::string> command = command_named(arguments);
  if (!command) return std::nullopt;
  Application application(*command);
  try {
    application.app.parse(static_cast<int>(arguments.size()), arguments.data());
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return answer(application.app, error);  // --help
    return std::nullopt;
  }
  try {
    refuse_odd_values(application.app);
    refuse_strange_results(application.app);
    return application.run();
  } catch (const UsageError& error) {
    return wrong_usage(application.app, error.what());
  }
}

int main_of(const std::vector<std::string>& words) {
  std::vector<const char*> arguments;
  for (const std::string& word : words) arguments.push_back(word.c_str());
  say_as_json(asks_for_json(arguments));
  try {
    if (const std::optional<int> code = run_one(arguments)) return *code;
    Application application;
    if (words.size() == 2 && words[1] == "--description") {  // for those who make manual pages of it
      print_result(description_json(application.app));
      return kDone;
    }
    return parse_and_run(application.app, application.run, arguments);
  } catch (const Refusal& refusal) {
    return refused(refusal.diagnostic());
  } catch (const std::bad_alloc&) {
    return out_of_memory();
  } catch (const std::length_error&) {  // more than any memory
    return out_of_memory();
  } catch (const std::system_error& error) {
    return out_of_resources(error);
  } catch (const std::exception& error) {
    return broken(error.what());
  }
}

}  // namespace
}  // namespace plumbline::cli

int main(int argc, char** argv) {
  try {
    plumbline::platform::prepare_standard_streams();
    plumbline::remove_names_on_signals();
    const std::vector<std::string> arguments = plumbline::platform::arguments_of(argc, argv);
    return plumbline::cli::main_of(arguments);
  } catch (...) {  // while saying what is wrong: standard error is gone
    return plumbline::cli::kFailed;
  }
}
