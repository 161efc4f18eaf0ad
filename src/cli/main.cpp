// plumbline: the command line. Exit codes: 0 done, 1 the work failed, 2 wrong usage, 3 done and something was found.
#include <cstdio>
#include <new>
#include <span>
#include <sstream>
#include <stdexcept>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include "base/check.hpp"
#include "base/diagnostic.hpp"
#include "base/files/ending_signals.hpp"
#include "base/version.hpp"
#include "cli/command.hpp"
#include "cli/messages.hpp"
#include "cli/suggest.hpp"

namespace plumbline::cli {
namespace {

// A shell can start a program with a stream closed (2>&-). The first file that is opened would take its place, and
// messages would go into it.
void occupy_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(stream, F_GETFD) != -1) continue;
    open("/dev/null", stream == STDERR_FILENO ? O_RDWR : stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
  }
}

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

// Before the command and after it.
void add_diagnostics(CLI::App& app) {
  static std::string form;
  std::vector<CLI::App*> all = app.get_subcommands([](const CLI::App*) { return true; });
  all.push_back(&app);
  for (CLI::App* const one : all) {
    one->add_option("--diagnostics", form, "form of the messages on standard error: text, or json, an object a line")
        ->type_name("FORM")
        ->check(CLI::IsMember({"text", "json"}));
  }
}

// Before the command and after it.
void add_loudness(CLI::App& app) {
  const auto add = [](CLI::App& to, const char* names, Loudness loudness, const char* what) {
    return to
        .add_flag_callback(
            names, [loudness] { say_as_much_as(loudness); }, what)
        ->trigger_on_parse();
  };
  std::vector<CLI::App*> all = app.get_subcommands([](const CLI::App*) { return true; });
  all.push_back(&app);
  for (CLI::App* const one : all) {
    CLI::Option* const quiet =
        add(*one, "-q,--quiet", Loudness::quiet, "say errors, warnings and results, and nothing else");
    add(*one, "-v,--verbose", Loudness::verbose, "say the steps of the work, too")->excludes(quiet);
  }
}

// What a script meant to put there was not set.
void refuse_empty_values(const CLI::App& app) {
  for (const CLI::App* const command : app.get_subcommands()) {
    for (const CLI::Option* const option : command->get_options()) {
      for (const std::string& value : option->results()) {
        if (value.empty())
          throw UsageError(fmt::format("{}: expected {}", option->get_name(), option->get_type_name()));
      }
    }
  }
}

void describe(CLI::App& app) {
  app.description(
      "plumbline straightens NC programs for hexapod machine tools: it moves the tool tip to where the "
      "program meant it to go, against gravity, friction and elasticity of the machine.");
  app.name("plumbline");
  app.set_version_flag("--version", fmt::format("plumbline {}", plumbline::version()));
  app.require_subcommand(1);
  app.get_formatter()->column_width(36);
  app.footer(
      "Lengths are in mm, angles in deg, masses in kg; - stands for standard input or output.\n"
      "Exit codes: 0 done, 1 the work failed, 2 wrong usage, 3 done and something was found (check, diff "
      "--expect-equal,\n"
      "compare --max-radial-um).");
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
    refuse_empty_values(app);
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

int main_of(int argc, const char* const* argv) {
  CLI::App app;
  Run run;
  const std::span arguments(argv, static_cast<std::size_t>(argc));
  describe(app);
#define PLUMBLINE_ADD(NAME) add_##NAME(app, run);
  PLUMBLINE_COMMANDS(PLUMBLINE_ADD)
#undef PLUMBLINE_ADD
  add_diagnostics(app);
  add_loudness(app);
  say_as_json(asks_for_json(arguments));
  try {
    return parse_and_run(app, run, arguments);
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
    plumbline::cli::occupy_standard_streams();
    plumbline::remove_names_on_signals();
    return plumbline::cli::main_of(argc, argv);
  } catch (...) {  // while saying what is wrong: standard error is gone
    return plumbline::cli::kFailed;
  }
}
