#include "drawn/interpreter.hpp"

#include <cstdlib>
#include <sstream>

#include <fmt/format.h>

#include "base/diagnostic.hpp"
#include "base/files/files.hpp"
#include "base/units.hpp"
#include "nc/canon.hpp"
#include "nc/sequence/program.hpp"

namespace plumbline::drawn {
namespace {

constexpr double kTolerance = 1e-4;  // of the program's unit: what four decimals hold

// From whatever the program before left to where this one begins.
std::string begun(const DrawnProgram& program) {
  std::string text = "G49\nG21 G90 G94 G17 G40 G80 G99 G64 G54 G91.1 G97\nM5 M9 M48\nG92.1\n";
  for (std::size_t i = 0; i < 9; ++i) {
    const nc::WorkOffset offset = program.options.program.work_offsets[i].value_or(nc::WorkOffset{kBox, 0});
    text += fmt::format("G10 L2 P{} R{}", i + 1, offset.rotation_deg);
    for (const Axis axis : kAllAxes) text += fmt::format(" {}{:.6f}", letter(axis), offset.origin[axis]);
    text += "\n";
  }
  text += "G53 G0";
  for (const Axis axis : kAllAxes) text += fmt::format(" {}{:.6f}", letter(axis), program.start[axis]);
  return text + "\nG80\n";
}

// Without the words that end it, its guard with labels of its own.
std::string continued(const std::string& text, std::uint64_t nth) {
  constexpr std::string_view kLabel = "o<plumbline_";
  std::istringstream in(text);
  std::string out;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with(kLabel)) line.insert(kLabel.size(), std::to_string(nth));
    if (line != "M2" && line != "M30") out += line + "\n";
  }
  return out;
}

// The line after "executing", without the numbers in it.
std::string reason(const std::string& said) {
  std::istringstream in(said);
  std::string line;
  while (std::getline(in, line)) {
    if (line.find("executing") == std::string::npos && !line.empty()) break;
  }
  std::erase_if(line, [](char c) { return c >= '0' && c <= '9'; });
  return line;
}

}  // namespace

Interpreter::Interpreter(const Scene& scene) : scene_(scene) {
  std::string table;
  for (std::size_t i = 0; i < kTools; ++i)
    table += fmt::format("T{} P{} Z{:.6f} D0.5\n", i + 1, i + 1, kToolLengths[i] / kMmPerInch);
  scratch_.file("tools.tbl", table);
}

std::optional<Finding> Interpreter::compare(const std::string& text, bool block_delete) {
  scratch_.file("all.ngc", text);
  scratch_.file("variables.var", "");
  const std::string folder = scratch_.folder().string();
  const std::string command = fmt::format(
      "cd '{0}' && rm -f all.canon && ulimit -t 60 && HOME='{0}' timeout 600 rs274 -g -n 2 {1} -t tools.tbl -v "
      "variables.var all.ngc all.canon </dev/null >said 2>&1",
      folder, block_delete ? "-b" : "");
  if (std::system(command.c_str()) != 0)
    return Finding{"rs274 refuses: " + reason(scratch_.text("said")), scratch_.text("said")};
  nc::ProgramSettings settings;
  settings.as_with_empty_tables = true;
  settings.position_may_be_read = true;
  settings.tools = nc::read_tool_table(scene_.tools);
  settings.block_delete = block_delete;
  std::vector<nc::Motion> motions;
  try {
    const InputFile file(scratch_ / "all.ngc");
    nc::Program program(file, nc::dialect("linuxcnc"), settings);
    while (const nc::Step* step = program.next())
      motions.insert(motions.end(), step->motions.begin(), step->motions.end());
  } catch (const Refusal& refusal) {
    return Finding{"rs274 takes what is refused", to_text(refusal.diagnostic())};
  }
  const std::string difference =
      nc::tests::first_difference(motions, nc::tests::read_canon(scratch_ / "all.canon"), kTolerance);
  if (difference.empty()) return std::nullopt;
  return Finding{"rs274 differs", difference};
}

std::optional<Finding> Interpreter::check(const Pair& pair) {
  const bool block_delete = pair.program.options.program.block_delete.value_or(false);
  if (auto found = compare(begun(pair.program) + pair.program.text(), block_delete)) return found;
  if (pair.output.empty()) return std::nullopt;
  if (auto found = compare(begun(pair.program) + pair.output, block_delete))
    return Finding{found->kind + " (output)", found->text};
  return std::nullopt;
}

std::vector<std::pair<std::size_t, Finding>> Interpreter::check(const std::vector<Pair>& pairs, Tally& tally) {
  std::vector<std::pair<std::size_t, Finding>> findings;
  for (const bool block_delete : {false, true}) {
    std::string all;
    for (const Pair& pair : pairs) {
      if (pair.program.options.program.block_delete.value_or(false) != block_delete) continue;
      all += begun(pair.program) + continued(pair.program.text(), tally.interpreted);
      ++tally.interpreted;
      if (pair.output.empty()) continue;
      all += begun(pair.program) + continued(pair.output, tally.interpreted);
      ++tally.interpreted;
    }
    const std::optional<Finding> together = all.empty() ? std::nullopt : compare(all + "M2\n", block_delete);
    if (!together) continue;
    const std::size_t before = findings.size();
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      if (pairs[i].program.options.program.block_delete.value_or(false) != block_delete) continue;
      if (auto found = check(pairs[i])) findings.emplace_back(i, std::move(*found));
    }
    if (findings.size() == before)
      findings.emplace_back(0, Finding{"rs274 joined", together->text + "\nno program alone differs"});
  }
  return findings;
}

}  // namespace plumbline::drawn
