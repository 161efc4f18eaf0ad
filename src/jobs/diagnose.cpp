#include "jobs/diagnose.hpp"

#include <cmath>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/units.hpp"
#include "diagnose/verdict.hpp"
#include "identify/model_text.hpp"
#include "jobs/where_json.hpp"
#include "machine/model_file.hpp"
#include "measure/thinning.hpp"
#include "physics/generic_formula.hpp"

namespace plumbline::jobs {
namespace {

using diagnose::Diagnosis;
using diagnose::Gap;
using diagnose::NamedEffect;
using diagnose::NamedParameter;
using Json = nlohmann::ordered_json;

Json left_out_json(const std::optional<diagnose::LeftOut>& left_out) {
  if (!left_out) return nullptr;
  return {{"poses", rounded(left_out->poses)}, {"runs", rounded(left_out->runs)}};
}

Json numbers(const NamedParameter& parameter, const std::vector<double>& values) {
  if (parameter.single) return rounded(values.front());
  Json list = Json::array();
  for (std::size_t i = 0; i < values.size(); i += parameter.each) {
    if (parameter.each == 1) {
      list.push_back(rounded(values[i]));
      continue;
    }
    Json point = Json::array();
    for (std::size_t k = 0; k < parameter.each; ++k) point.push_back(rounded(values[i + k]));
    list.push_back(point);
  }
  return list;
}

Json effect_json(const NamedEffect& effect) {
  Json parameters = Json::object();
  Json errors = Json::object();
  for (const NamedParameter& parameter : effect.parameters) {
    parameters[parameter.key] = numbers(parameter, parameter.values);
    errors[parameter.key] = numbers(parameter, parameter.errors);
  }
  return {{"name", effect.name},
          {"alternatives", effect.alternatives},
          {"parameters", parameters},
          {"standard_errors", errors},
          {"log_odds", rounded(effect.log_odds)},
          {"left_out_nats", left_out_json(effect.left_out)}};
}

Json figure(const std::optional<double>& value, double unit) { return value ? rounded(*value / unit) : Json(nullptr); }

Json gap_json(const Gap& gap, bool runner_up) {
  const auto both = [&](const auto& of, double unit) {
    Json json{{"before", figure(of(gap.before), unit)}};
    if (runner_up) json["runner_up"] = figure(of(gap.runner_up), unit);
    json["after"] = figure(of(gap.after), unit);
    return json;
  };
  return {{"radial_rms_um", both([](const diagnose::Rms& r) { return r.radial; }, kUm)},
          {"torque_rms_Nm", both([](const diagnose::Rms& r) { return r.torque; }, 1)}};
}

// Null where nothing was measured.
Json noise_json(const identify::NoiseModel& noise) {
  Json json;
  const auto add = [&](const std::string& name, const std::string& unit_name, const identify::ChannelNoise& channel,
                       double unit) {
    const bool measured = channel.samples > 0;
    json[name + unit_name] = measured ? rounded(channel.sigma / unit) : Json();
    json[name + "_memory"] = measured ? rounded(channel.memory) : Json();
    json[name + "_white_share"] = measured ? rounded(channel.white) : Json();
  };
  add("radial", "_um", noise.channels[identify::kRadial], kUm);
  add("torque", "_Nm", noise.channels[1], 1);
  return json;
}

Json run_json(const diagnose::RunGap& run) {
  Json channels = Json::object();
  for (const diagnose::ChannelGap& gap : run.channels) {
    const bool radial = gap.channel == identify::kRadial;
    const double unit = radial ? kUm : 1;
    channels[std::string(identify::channel_name(gap.channel)) + (radial ? "_um" : "_Nm")] = {
        {"before", rounded(gap.before / unit)}, {"after", rounded(gap.after / unit)}};
  }
  Json json{{"id", run.id}, {"held_out", run.held_out}, {"rms", channels}, {"circularity_um", nullptr}};
  if (run.circularity) {
    json["circularity_um"] = {{"measured", rounded(run.circularity->measured / kUm)},
                              {"compensated_with_given", rounded(run.circularity->given / kUm)},
                              {"compensated_with_found", rounded(run.circularity->found / kUm)}};
  }
  return json;
}

Json test_json(const diagnose::Separation& separation) {
  Json json{{"from", separation.from}};
  if (!separation.test) {
    json["test"] = nullptr;
    return json;
  }
  const measure::Run& run = separation.test->run;
  const auto list = [](const Vector3<double>& v, double unit) {
    return Json{rounded(v.x() / unit), rounded(v.y() / unit), rounded(v.z() / unit)};
  };
  json["test"] = {{"centre_mm", list(run.centre_W, kMm)},
                  {"radius_mm", rounded(run.radius / kMm)},
                  {"tilt_deg", list(run.tilt, kDeg)},
                  {"direction", measure::to_text(run.direction)},
                  {"feed_mm_min", rounded(run.feed / kMmPerMin)},
                  {"payload_kg", rounded(run.payload_mass)}};
  json["separation_sigma"] = rounded(separation.test->separation);
  return json;
}

std::string test_text(const diagnose::Separation& separation) {
  if (!separation.test) {
    return fmt::format("no circular test separates it from {}\n", separation.from);
  }
  const measure::Run& run = separation.test->run;
  return fmt::format(
      "next test, to separate it from {} (by {:.0f} sigma): centre {:.0f}, {:.0f}, {:.0f} mm, A {:.1f} B {:.1f} "
      "deg, {}, F{:.0f}{}\n",
      separation.from, separation.test->separation, run.centre_W.x() / kMm, run.centre_W.y() / kMm,
      run.centre_W.z() / kMm, run.tilt.x() / kDeg, run.tilt.y() / kDeg, measure::to_text(run.direction),
      run.feed / kMmPerMin, run.payload_mass > 0 ? fmt::format(", {:.0f} kg at the tip", run.payload_mass) : "");
}

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

// "backlash 3.2 um": the smallest size that would have been named.
std::string smallest_text(const diagnose::Visible& visible) {
  return fmt::format("{} {:.2g}{}{}", visible.name, visible.smallest, visible.unit.empty() ? "" : " ", visible.unit);
}

std::string could_show_text(const std::vector<diagnose::Visible>& visible) {
  std::vector<std::string> never;
  std::vector<std::string> from;
  for (const diagnose::Visible& one : visible) {
    if (one.shows) {
      from.push_back(smallest_text(one));
    } else {
      never.push_back(one.name);
    }
  }
  std::string text;
  if (!never.empty()) text += fmt::format("these runs could not have shown, at any size: {}\n", list_of(never));
  if (!from.empty()) text += fmt::format("they would have shown, from this size on: {}\n", list_of(from));
  return text;
}

Json could_show_json(const std::vector<diagnose::Visible>& visible) {
  Json list = Json::array();
  for (const diagnose::Visible& one : visible) {
    Json json{{"name", one.name}, {"shows", one.shows}, {"key", nullptr}, {"smallest", nullptr}};
    if (!one.key.empty()) json["key"] = one.key;
    if (one.shows) json["smallest"] = rounded(one.smallest);
    list.push_back(std::move(json));
  }
  return list;
}

std::vector<std::string> notes_of(const Diagnosis& diagnosis) {
  std::vector<std::string> notes{fmt::format("diagnosis: {}", headline(diagnosis))};
  if (!diagnosis.withheld.empty()) notes.push_back("the numbers are those given: " + diagnosis.withheld);
  for (const NamedEffect& effect : diagnosis.effects) {
    notes.push_back(effect.alternatives.empty() ? effect.name
                                                : fmt::format("{}, which these data do not tell from {}", effect.name,
                                                              list_of(effect.alternatives)));
  }
  if (diagnosis.verdict == diagnose::Verdict::unknown) {
    notes.emplace_back("the effects named generic describe what was seen; they are no cause");
  }
  return notes;
}

}  // namespace

std::string headline(const Diagnosis& d) {
  if (d.verdict == diagnose::Verdict::unknown) return "unknown: there is a gap, and no effect of the catalogue is it";
  if (d.verdict == diagnose::Verdict::nothing_missing) return "nothing-missing, as far as these runs can show";
  return "named: " + diagnose::names_text(d);
}

std::string diagnosis_json(const Diagnosis& d) {
  Json json;
  json["plumbline"] = "diagnosis 1";
  json["verdict"] = to_text(d.verdict);
  json["headline"] = headline(d);
  json["effects"] = Json::array();
  for (const NamedEffect& effect : d.effects) json["effects"].push_back(effect_json(effect));
  json["confidence_set"] = d.confidence_set;
  const bool second = !d.runner_up.empty();
  json["gap"]["fit"] = gap_json(d.fit, second);
  json["gap"]["held_out"] = gap_json(d.held_out, second);
  if (second) json["runner_up"] = d.runner_up;
  if (!d.doubt.empty()) json["doubt"] = d.doubt;
  json["model_withheld"] = d.withheld.empty() ? Json() : Json(d.withheld);
  json["could_show"] = could_show_json(d.visible);
  if (d.remainder) {
    json["remainder"] = {{"snr", rounded(d.remainder->snr)}, {"description", d.remainder->text}};
  }
  json["next_tests"] = Json::array();
  for (const diagnose::Separation& separation : d.next) json["next_tests"].push_back(test_json(separation));
  json["threshold_nats"] = rounded(d.threshold);
  json["evidence_nats"] = Json::array();
  for (const diagnose::Evidence& e : d.evidence) {
    json["evidence_nats"].push_back(
        {{"name", e.name}, {"log_odds", rounded(e.log_odds)}, {"left_out_nats", left_out_json(e.left_out)}});
  }
  json["noise"] = noise_json(d.noise);
  json["circularity_um"] = circularity_json(circularity_of(d.runs));
  json["where"] = where_json(d.where);
  json["runs"] = Json::array();
  for (const diagnose::RunGap& run : d.runs) json["runs"].push_back(run_json(run));
  json["converged"] = d.converged;
  return json.dump(1) + "\n";
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
  if (d.verdict == diagnose::Verdict::nothing_missing) text += could_show_text(d.visible);
  if (d.confidence_set.size() > 1) text += fmt::format("not ruled out: {}\n", list_of(d.confidence_set));
  for (const diagnose::Separation& separation : d.next) text += test_text(separation);
  if (!d.doubt.empty()) text += d.doubt + '\n';
  if (d.remainder) {
    text += fmt::format("not explained by the catalogue (a description, not a cause; strength {:.0f}):\n{}\n",
                        d.remainder->snr, d.remainder->text);
  }
  text += rms_line("fitted", d.fit, d.noise);
  if (d.held_out.before.radial || d.held_out.before.torque) text += rms_line("held out", d.held_out, d.noise);
  text += circularity_line(d);
  if (!d.withheld.empty()) text += fmt::format("the model stays as it was given: {}\n", d.withheld);
  return text;
}

DiagnoseReport diagnose(const DiagnoseJob& job, const diagnose::Say& say) {
  const machine::MachineModel machine = machine::read_model(job.model);
  const measure::Dataset dataset = measure::read_dataset(job.dataset);
  diagnose::DiagnoseOptions options;
  options.candidates.without = job.without;
  options.search.threshold.seed = job.seed;
  const measure::Thinned thinned = measure::thinned(dataset.runs);
  Diagnosis diagnosis = diagnose::diagnose(machine, thinned.runs, options, say);
  std::string json = diagnosis_json(diagnosis);
  std::string text = diagnosis_text(diagnosis);
  std::string model = identify::model_text(
      machine,
      {diagnosis.forces, diagnosis.errors,
       diagnosis.withheld.empty() ? "with what diagnose found" : "as it was given to diagnose", notes_of(diagnosis)});
  std::string thinning = thinned.text();
  if (!thinning.empty()) text += thinning + '\n';
  return {std::move(diagnosis), machine.name, std::move(json), std::move(model), std::move(text), std::move(thinning)};
}

}  // namespace plumbline::jobs
