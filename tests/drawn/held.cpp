#include "drawn/held.hpp"

#include <cmath>
#include <filesystem>
#include <regex>

#include <fmt/format.h>

#include "base/diagnostic.hpp"
#include "base/files/files.hpp"
#include "drawn/drawn_program.hpp"
#include "jobs/check.hpp"
#include "jobs/compensate/compensate_file.hpp"
#include "jobs/compensate/compensated_files.hpp"
#include "jobs/diff/diff.hpp"
#include "nc/rewrite/output/undo.hpp"
#include "nc/sequence/program.hpp"
#include "report/program/check_text.hpp"
#include "report/program/diff_text.hpp"
#include "settings/options.hpp"
#include "settings/program_settings.hpp"

namespace plumbline::drawn {
namespace {

constexpr double kSamePlace = 2e-6;  // mm and deg: sums of numbers with six decimals

std::string tool_text() {
  std::string text = "plumbline = \"tools 1\"\n";
  for (std::size_t i = 0; i < kTools; ++i) {
    text +=
        fmt::format("[[tool]]\nnumber = {}\nlength_mm = {}\ndiameter_mm = 10\nmass_kg = {}\ncentre_of_mass_mm = 20\n",
                    i + 1, kToolLengths[i], 0.5 + static_cast<double>(i));
  }
  return text;
}

// The machine without any error: a compensation has nothing to do.
std::string without_errors(std::string model) {
  model = std::regex_replace(model, std::regex("\ncompliance_per_length_um_N_m = [^\n]*"),
                             "\ncompliance_per_length_um_N_m = 0");
  model = std::regex_replace(model, std::regex("\ncompliance_um_N = [^\n]*"), "\ncompliance_um_N = 0");
  return std::regex_replace(model, std::regex("\ncoulomb_friction_N = \\[[^\n]*"),
                            "\ncoulomb_friction_N = [0, 0, 0, 0, 0, 0]");
}

/// Runs `work`; the refusal, if there is one.
template <class Work>
std::optional<Diagnostic> refusal(const Work& work) {
  try {
    work();
  } catch (const Refusal& refusal) {
    return refusal.diagnostic();
  }
  return std::nullopt;
}

template <class Work>
std::optional<Finding> without_exception(std::string_view what, const Work& work) {
  try {
    return work();
  } catch (const Refusal& refusal) {
    return Finding{fmt::format("{} refused {}", what, refusal.diagnostic().code), to_text(refusal.diagnostic())};
  } catch (const std::exception& error) {
    return Finding{fmt::format("{} bug", what), error.what()};
  }
}

}  // namespace

void Tally::add(const Tally& other) {
  drawn += other.drawn;
  changed += other.changed;
  unrolled += other.unrolled;
  checks += other.checks;
  interpreted += other.interpreted;
  for (const auto& [code, count] : other.refused) refused[code] += count;
  for (const auto& [code, text] : other.example) example.emplace(code, text);
}

Held::Held() {
  const std::string model = read_text(PLUMBLINE_SOURCE_DIR "/models/pm600-like.toml");
  scene_.model = scratch_.file("model.toml", model);
  scene_.zero_model = scratch_.file("zero.toml", without_errors(model));
  scene_.tools = scratch_.file("tools.toml", tool_text());
}

std::optional<Finding> Held::check(const DrawnProgram& program, Tally& tally, std::string* output) {
  ++tally.drawn;
  scratch_.file("program.nc", program.text());
  compensate::Summary summary;
  std::optional<Diagnostic> refused;
  try {
    refused = refusal(
        [&] { summary = jobs::compensate_file(scratch_ / "program.nc", scratch_ / "out.nc", program.options); });
  } catch (const std::exception& error) {
    return Finding{fmt::format("bug {}", std::string(error.what()).substr(0, 40)), error.what()};
  }
  if (refused) {
    ++tally.refused[refused->code];
    tally.example.emplace(refused->code,
                          fmt::format("seed {}: {}: {}", program.seed, refused->place.text, refused->message));
    if (refused->code == "compensate-read-back") return Finding{"read-back", to_text(*refused)};
    if (refused->code.starts_with("limit-") || refused->code == "compensate-unreachable")
      return check_refused(program, refused->code);
    return std::nullopt;
  }
  ++tally.checks;
  if (!summary.identical) ++tally.changed;
  if (summary.unrolled) ++tally.unrolled;
  if (auto found = without_exception("trace", [&] { return check_ends(program); })) return found;
  // Along a move the two are compared at the same share of the way, which corrections stretch.
  const double mm = 1.5 * summary.correction_mm.value + summary.rounding_mm.value + 5e-3;
  const double deg = 1.5 * summary.correction_deg.value + 5e-3;
  if (output != nullptr && !summary.identical) *output = scratch_.text("out.nc");
  if (auto found =
          without_exception("diff", [&] { return check_output(program, mm, deg, summary.time_change.value + 1e-3); }))
    return found;
  if (auto found = without_exception("zero", [&] { return check_zero(program); })) return found;
  return std::nullopt;
}

// The generator's own reading of what it wrote.
std::optional<Finding> Held::check_ends(const DrawnProgram& program) const {
  std::map<std::size_t, const DrawnBlock*> wanted;
  std::size_t line = 0;
  for (const DrawnBlock& block : program.blocks) {
    line += 1 + static_cast<std::size_t>(std::count(block.text.begin(), block.text.end(), '\n'));
    if (block.ends) wanted[line] = &block;
  }
  const InputFile source(scratch_ / "program.nc");
  nc::ProgramSettings settings = settings::program_settings(program.options);
  settings.position_may_be_read = true;
  nc::Program read(source, nc::dialect(program.dialect), settings);
  while (const nc::Step* step = read.next()) {
    const auto found = wanted.find(step->block->line);
    if (found == wanted.end()) continue;
    for (const Axis axis : kAllAxes) {
      if (!step->known.contains(axis)) continue;
      const double off = step->position[axis] - (*found->second->ends)[axis];
      if (std::abs(off) > kSamePlace)
        return Finding{"ends", fmt::format("line {}: {} stands at {:.6f}, drawn was {:.6f}", found->first, letter(axis),
                                           step->position[axis], (*found->second->ends)[axis])};
    }
  }
  return std::nullopt;
}

std::optional<Finding> Held::check_refused(const DrawnProgram& program, const std::string& code) const {
  jobs::CheckSummary found;
  try {
    found = jobs::check_file(scratch_ / "program.nc", program.options);
  } catch (const Refusal&) {
    return std::nullopt;  // of something further down: it reads to the end
  }
  if (found.violations > 0) return std::nullopt;
  return Finding{"check misses " + code, fmt::format("compensate refuses with {}, check finds nothing", code)};
}

std::optional<Finding> Held::check_output(const DrawnProgram& program, double shift_mm, double shift_deg,
                                          double time_change) const {
  const std::string original = scratch_ / "program.nc";
  const std::string output = scratch_ / "out.nc";
  const jobs::CheckSummary checked = jobs::check_file(original, program.options);
  if (checked.violations > 0) {
    return Finding{"check finds " + checked.kinds.begin()->first,
                   "check finds what compensate passes\n" + report::check_text(checked)};
  }
  if (with_diff) {
    if (auto found = check_diff(program, shift_mm, shift_deg, time_change)) return found;
  }
  if (program.options.undo) {
    OutputFile back(scratch_ / "back.nc");
    nc::restore(InputFile(output), InputFile(jobs::undo_name(output)), back);
    back.commit();
    if (scratch_.text("back.nc") != program.text()) return Finding{"restore", "the original does not come back"};
  }
  return std::nullopt;
}

std::optional<Finding> Held::check_diff(const DrawnProgram& program, double shift_mm, double shift_deg,
                                        double time_change) const {
  const jobs::DiffSummary diff = jobs::diff_files(scratch_ / "program.nc", scratch_ / "out.nc", program.options);
  if (diff.out_of_line_a > 0 || diff.out_of_line_b > 0) return Finding{"diff out of line", report::diff_text(diff)};
  for (const Axis axis : kAllAxes) {
    if (diff.shift[index(axis)].largest > (is_rotary(axis) ? shift_deg : shift_mm))
      return Finding{"diff shift",
                     fmt::format("at most {} mm {} deg were meant\n", shift_mm, shift_deg) + report::diff_text(diff)};
  }
  if (diff.time_change.value > std::max(time_change, 2e-3)) return Finding{"diff time", report::diff_text(diff)};
  return std::nullopt;
}

std::optional<Finding> Held::check_zero(const DrawnProgram& program) const {
  settings::Options options = program.options;
  options.paths.model = scene_.zero_model;
  options.undo = false;
  options.guard = false;
  compensate::Summary summary;
  const std::optional<Diagnostic> refused =
      refusal([&] { summary = jobs::compensate_file(scratch_ / "program.nc", scratch_ / "zero.nc", options); });
  // A limit may be kept by what the corrections move alone.
  if (refused && refused->code.starts_with("limit-")) return std::nullopt;
  if (refused) throw Refusal(*refused);
  if (summary.identical && scratch_.text("zero.nc") == program.text()) return std::nullopt;
  // Words of A, B and C may follow G43.5 in the output, which is said before it is known whether they do.
  if (summary.changed_blocks == 0 && program.text().find("G43.5") != std::string::npos) return std::nullopt;
  return Finding{"zero", "a machine without errors: the program changes\n" + scratch_.text("zero.nc")};
}

}  // namespace plumbline::drawn
