#include "report/measured/diagnosis_text.hpp"

#include <algorithm>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "base/units.hpp"
#include "report/measured/could_show_text.hpp"
#include "report/measured/functions_text.hpp"
#include "report/measured/next_test_text.hpp"
#include "report/measured/objection_text.hpp"
#include "report/measured/where_json.hpp"

namespace plumbline::report {
namespace {

using diagnose::Diagnosis;
using diagnose::Gap;
using diagnose::NamedEffect;
using diagnose::NamedParameter;

std::string list_of(const std::vector<std::string>& names) { return fmt::format("{}", fmt::join(names, ", ")); }

// "bar 3.10 -> 0.60 um (noise 0.50)"
std::string change_text(const char* what, const std::optional<double>& before, const std::optional<double>& after,
                        const identify::ChannelNoise& noise, double unit, int decimals, const char* unit_name) {
  if (!before || !after) return fmt::format("{} not measured", what);
  return fmt::format("{} {:.{}f} -> {:.{}f} {} (noise {:.{}f})", what, *before / unit, decimals, *after / unit,
                     decimals, unit_name, noise.sigma / unit, decimals);
}

std::string rms_line(const char* what, const Gap& gap, const identify::NoiseModel& noise) {
  return fmt::format(
      "{:<10} {}, {}\n", what,
      change_text("bar", gap.before.radial, gap.after.radial, noise.channels[identify::kRadial], kUm, 2, "um"),
      change_text("torque", gap.before.torque, gap.after.torque, noise.channels[1], 1, 3, "N m"));
}

std::string parameter_text(const NamedParameter& parameter) {
  std::vector<std::string> values;
  for (std::size_t i = 0; i < parameter.values.size(); ++i) {
    values.push_back(parameter.errors[i] > 0 ? fmt::format("{:.3g} +- {:.2g}", parameter.values[i], parameter.errors[i])
                                             : fmt::format("{:.3g}", parameter.values[i]));
  }
  return fmt::format("    {} = {}\n", parameter.key, fmt::join(values, ", "));
}

// "circles    as measured 41.2 um, compensated with the model as given 9.0, with what was found 3.9 (means of 26)"
std::string circularity_line(const Diagnosis& d) {
  const CircularityOfRuns all = circularity_of(d.runs);
  if (all.runs == 0) return {};
  return fmt::format(
      "circles    as measured {:.1f} um, compensated with the model as given {:.1f}, with what was found {:.1f} (means "
      "of {})\n",
      all.mean.measured / kUm, all.mean.given / kUm, all.mean.found / kUm, all.runs);
}

}  // namespace

std::string names_text(const Diagnosis& d) {
  const std::vector<std::string>& set = d.confidence_set;
  std::size_t of_set = 0;
  std::string beside;
  for (const NamedEffect& effect : d.effects) {
    if (std::find(set.begin(), set.end(), effect.name) != set.end()) {
      ++of_set;
    } else {
      beside += "; and " + effect.name;
    }
  }
  const std::string_view several = set.size() == of_set ? "" : of_set == 1 ? "one of " : "two of ";
  return fmt::format("{}{}{}", several, fmt::join(set, ", "), beside);
}

std::string headline(const Diagnosis& d) {
  if (d.verdict == diagnose::Verdict::unknown) return "unknown: there is a gap, and no effect of the catalogue is it";
  if (d.verdict == diagnose::Verdict::nothing_missing) return "nothing-missing, as far as these runs can show";
  return "named: " + names_text(d);
}

std::string diagnosis_text(const Diagnosis& d) {
  std::string text = headline(d) + '\n';
  for (const NamedEffect& effect : d.effects) {
    text += fmt::format("  {} ({:.0f} nats, threshold {:.1f})\n", effect.name, effect.log_odds, d.threshold);
    if (!effect.alternatives.empty()) {
      text += fmt::format("    these data do not tell it from {}\n", list_of(effect.alternatives));
    }
    for (const NamedParameter& parameter : effect.parameters) text += parameter_text(parameter);
  }
  if (!d.effects.empty()) text += fmt::format("({})\n", kNats);
  if (d.verdict == diagnose::Verdict::nothing_missing) text += could_show_text(d.visible, d.runs.size());
  if (d.confidence_set.size() > 1) text += fmt::format("not ruled out: {}\n", list_of(d.confidence_set));
  for (const diagnose::Separation& separation : d.next) text += next_test_text(separation) + '\n';
  if (d.doubt) text += doubt_text(*d.doubt) + '\n';
  if (d.remainder) {
    text += fmt::format("not explained by the catalogue (a description, not a cause; strength {:.0f}):\n{}\n",
                        d.remainder->snr, remainder_text(*d.remainder));
  }
  if (!d.functions.empty()) {
    text += fmt::format("corrected all the same, as poses left out confirm it, and no further than was measured:\n{}\n",
                        fmt::join(function_lines(d), "\n"));
  }
  text += rms_line("fitted", d.fit, d.noise);
  if (d.held_out.before.radial || d.held_out.before.torque) text += rms_line("held out", d.held_out, d.noise);
  text += circularity_line(d);
  if (d.withheld) text += fmt::format("the model stays as it was given: {}\n", objection_text(*d.withheld));
  return text;
}

}  // namespace plumbline::report
