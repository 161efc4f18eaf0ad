// Draws programs, compensates them, and holds against each other all that reads them: scripts/drawn.
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "drawn/held.hpp"
#include "drawn/interpreter.hpp"
#include "drawn/shrink.hpp"
#include "support/skip.hpp"

using namespace plumbline;
using namespace plumbline::drawn;

namespace {

struct Arguments {
  std::string dialect = "linuxcnc";
  std::uint64_t first = 1, count = 300;
  bool show = false;
  std::string keep;  // a folder
  bool with_rs274 = true;
  bool with_diff = true;
  std::size_t most_of_a_kind = 2;
};

constexpr std::size_t kTogether = 40;  // programs in one run of rs274

class Run {
 public:
  explicit Run(const Arguments& arguments) : arguments_(arguments), interpreter_(held_.scene()) {}

  int all() {
    held_.with_diff = arguments_.with_diff;
    const bool interprets = arguments_.with_rs274 && arguments_.dialect == "linuxcnc" && testing::has_rs274_or_skips();
    for (std::uint64_t seed = arguments_.first; seed < arguments_.first + arguments_.count; ++seed) {
      Pair pair{draw(arguments_.dialect, seed, held_.scene()), ""};
      Tally of_one;
      const std::optional<Finding> found = held_.check(pair.program, of_one, &pair.output);
      tally_.add(of_one);
      if (!arguments_.keep.empty()) keep(pair);
      if (found) note(*found, pair.program, [&](const DrawnProgram& less) { return held_.check(less, of_one); });
      if (!interprets) continue;
      const bool wraps = pair.program.options.program.rotary[2] != nc::RotaryRule::linear;  // an INI file would say so
      const bool calls = pair.program.text().find("M98") != std::string::npos;  // whose programs stand after the end
      if (of_one.refused.empty() && !wraps && !calls) pairs_.push_back(std::move(pair));
      if (pairs_.size() >= kTogether) interpret();
    }
    interpret();
    return finish();
  }

 private:
  void interpret() {
    for (const auto& [i, finding] : interpreter_.check(pairs_, tally_)) {
      note(finding, pairs_[i].program, [&](const DrawnProgram& less) {
        Pair pair{less, ""};
        Tally ignored;
        held_.check(less, ignored, &pair.output);
        return interpreter_.check(pair);
      });
    }
    pairs_.clear();
  }

  void keep(const Pair& pair) const {
    const std::string name = fmt::format("{}/{}-{}", arguments_.keep, arguments_.dialect, pair.program.seed);
    std::ofstream(name + ".nc") << pair.program.text();
    std::ofstream(name + ".out.nc") << pair.output;
  }

  template <class Check>
  void note(const Finding& finding, const DrawnProgram& program, const Check& check) {
    ++findings_;
    if (++kinds_[finding.kind] > arguments_.most_of_a_kind) return;
    const auto still = [&](const DrawnProgram& less) {
      const std::optional<Finding> found = check(less);
      return found && found->kind == finding.kind;
    };
    const DrawnProgram small = finding.kind == "ends" ? program : shrunk(program, still);
    const std::optional<Finding> again = check(small);
    fmt::print("--- {} {}: {}\n{}\n{}", program.dialect, program.seed, finding.kind, again ? again->text : finding.text,
               small.text());
    std::cout.flush();
  }

  int finish() const {
    std::uint64_t refused = 0;
    for (const auto& [code, count] : tally_.refused) refused += count;
    fmt::print("{} drawn, {} refused, {} changed, {} unrolled, {} compared by diff and check, {} by rs274\n",
               tally_.drawn, refused, tally_.changed, tally_.unrolled, tally_.checks, tally_.interpreted);
    for (const auto& [code, count] : tally_.refused)
      fmt::print("  {:7} {}: {}\n", count, code, tally_.example.at(code));
    for (const auto& [kind, count] : kinds_) fmt::print("  finding {:4} {}\n", count, kind);
    return findings_ == 0 ? 0 : 1;
  }

  const Arguments& arguments_;
  Held held_;
  Interpreter interpreter_;
  std::vector<Pair> pairs_;
  Tally tally_;
  std::size_t findings_ = 0;
  std::map<std::string, std::uint64_t> kinds_;
};

int show(const Arguments& arguments) {
  const Held held;
  for (std::uint64_t seed = arguments.first; seed < arguments.first + arguments.count; ++seed)
    fmt::print("{}", draw(arguments.dialect, seed, held.scene()).text());
  return 0;
}

int draw_and_hold(int argc, char** argv) {
  Arguments arguments;
  CLI::App app("Drawn programs, compensated, read back, and read by others");
  app.add_option("--dialect", arguments.dialect, "linuxcnc, fanuc, okuma, siemens");
  app.add_option("--first", arguments.first, "first seed (default 1)");
  app.add_option("--count", arguments.count, "how many (default 300)");
  app.add_option("--most-of-a-kind", arguments.most_of_a_kind, "findings that are shrunk and shown (default 2)");
  app.add_option("--keep", arguments.keep, "a folder for the programs and their outputs");
  app.add_flag("--show", arguments.show, "print the programs, and do nothing else");
  app.add_flag("!--no-rs274", arguments.with_rs274, "leave LinuxCNC's interpreter out");
  app.add_flag("!--no-diff", arguments.with_diff, "leave diff out");
  CLI11_PARSE(app, argc, argv);
  return arguments.show ? show(arguments) : Run(arguments).all();
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return draw_and_hold(argc, argv);
  } catch (const std::exception& problem) {
    std::fputs(problem.what(), stderr);
    std::fputc('\n', stderr);
    return 1;
  }
}
