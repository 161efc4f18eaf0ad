#include <optional>

#include <nlohmann/json.hpp>

#include "base/units.hpp"
#include "report/measured/could_show_text.hpp"
#include "report/measured/datasets_text.hpp"
#include "report/measured/diagnosis_text.hpp"
#include "report/measured/functions_text.hpp"
#include "report/measured/objection_text.hpp"
#include "report/measured/where_json.hpp"

namespace plumbline::report {
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

Json exponent_json(const diagnose::LearntFunction& function) {
  if (!function.law) return nullptr;
  return {function.law->exponent, function.law->least, function.law->most};
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

}  // namespace

std::string diagnosis_json(const Diagnosis& d, const std::vector<jobs::MeasuredFile>& measured) {
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
  if (d.doubt) json["doubt"] = doubt_text(*d.doubt);
  json["model_withheld"] = d.withheld ? Json(objection_text(*d.withheld)) : Json();
  json["could_show"] = could_show_json(d.visible);
  if (d.remainder) {
    json["remainder"] = {{"snr", rounded(d.remainder->snr)}, {"description", remainder_text(*d.remainder)}};
  }
  for (const diagnose::LearntFunction& function : d.functions) {
    json["functions"].push_back({{"says", function_text(function, d.forces.machine)},
                                 {"log_odds", rounded(function.log_odds)},
                                 {"left_out_nats", rounded(function.left_out)},
                                 {"exponent", exponent_json(function)}});
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
  json["where"] = where_json(d.gap_map);
  json["runs"] = Json::array();
  for (const diagnose::RunGap& run : d.runs) json["runs"].push_back(run_json(run));
  json["datasets"] = datasets_json(measured);
  json["converged"] = d.converged;
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace plumbline::report
