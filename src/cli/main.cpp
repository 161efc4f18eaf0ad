// plumbline: the command line. Exit codes: 0 done, 1 the work failed, 2 wrong usage.
#include <cstdio>

#include <fmt/format.h>

#include "base/check.hpp"
#include "base/diagnostic.hpp"
#include "cli/command.hpp"
#include "jobs/version.hpp"

namespace plumbline::cli {
namespace {

int wrong_usage(const CLI::App& app, const char* message) {
  const std::vector<CLI::App*> asked = const_cast<CLI::App&>(app).get_subcommands();
  const std::string command = asked.empty() ? "" : " " + asked.front()->get_name();
  fmt::print(stderr, "plumbline{}: {}\nplumbline{} --help says more\n", command, message, command);
  return kWrongUsage;
}

int broken(const char* what) {
  fmt::print(stderr,
             "plumbline: this is a bug in plumbline {}: {}\n"
             "please report it with the command, the program and the model\n",
             jobs::version(), what);
  return kFailed;
}

void describe(CLI::App& app) {
  app.description(
      "plumbline straightens NC programs for hexapod machine tools: it moves the tool tip to where the "
      "program meant it to go, against gravity, friction and elasticity of the machine.");
  app.name("plumbline");
  app.set_version_flag("--version", fmt::format("plumbline {}", jobs::version()));
  app.require_subcommand(1);
  app.get_formatter()->column_width(36);
  app.footer(
      "Lengths are in mm, angles in deg, masses in kg; - stands for standard input or output.\n"
      "Exit codes: 0 done, 1 the work failed, 2 wrong usage.");
}

int main_of(int argc, const char* const* argv) {
  CLI::App app;
  Run run;
  describe(app);
  for (const auto add : {add_compensate, add_restore, add_error, add_trace, add_check, add_simulate, add_diff,
                         add_compare, add_circularity})
    add(app, run);
  try {
    app.parse(argc, argv);
    return run();
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help, --version
    return wrong_usage(app, error.what());
  } catch (const UsageError& error) {
    return wrong_usage(app, error.what());
  } catch (const Refusal& refusal) {
    fmt::print(stderr, "{}", to_text(refusal.diagnostic()));
    return kFailed;
  } catch (const std::exception& error) {
    return broken(error.what());
  }
}

}  // namespace
}  // namespace plumbline::cli

int main(int argc, char** argv) {
  try {
    return plumbline::cli::main_of(argc, argv);
  } catch (...) {  // while saying what is wrong: standard error is gone
    return plumbline::cli::kFailed;
  }
}
