#include "report/measured/compare_text.hpp"

#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace plumbline::report {
namespace {

std::string figure(const std::optional<double>& value, int decimals) {
  return value ? fmt::format("{:.{}f}", *value, decimals) : "-";
}

nlohmann::ordered_json number(const std::optional<double>& value) {
  return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json(nullptr);
}

nlohmann::ordered_json json_of(const jobs::Comparison& comparison) {
  nlohmann::ordered_json json;
  json["radial_rms_um"] = number(comparison.radial_rms_um);
  json["torque_rms_Nm"] = number(comparison.torque_rms_Nm);
  json["torque_mean_abs_Nm"] = comparison.torque_mean_abs_Nm;
  json["runs"] = nlohmann::ordered_json::array();
  for (const jobs::RunComparison& run : comparison.runs) {
    json["runs"].push_back({{"id", run.id},
                            {"radial_rms_um", number(run.radial_rms_um)},
                            {"torque_rms_Nm", number(run.torque_rms_Nm)},
                            {"torque_mean_abs_Nm", run.torque_mean_abs_Nm},
                            {"setup", {{"ball_um", run.ball_um}, {"bar_um", run.bar_um}}}});
  }
  return json;
}

}  // namespace

std::string compare_text(const jobs::Comparison& comparison) {
  std::string text =
      fmt::format("{:<24}{:>14}{:>14}   ball off by x, y, z and bar (um)\n", "run", "radial rms um", "torque rms Nm");
  for (const jobs::RunComparison& run : comparison.runs) {
    text += fmt::format("{:<24}{:>14}{:>14}", run.id, figure(run.radial_rms_um, 3), figure(run.torque_rms_Nm, 4));
    if (run.radial_rms_um) {
      text +=
          fmt::format("   {:.1f}, {:.1f}, {:.1f}, {:.1f}", run.ball_um[0], run.ball_um[1], run.ball_um[2], run.bar_um);
    }
    text += '\n';
  }
  text += fmt::format("{:<24}{:>14}{:>14}\n", "all", figure(comparison.radial_rms_um, 3),
                      figure(comparison.torque_rms_Nm, 4));
  if (comparison.torque_rms_Nm) {
    text += fmt::format("mean absolute torque error per strut (N m): {:.4f}\n",
                        fmt::join(comparison.torque_mean_abs_Nm, ", "));
  }
  return text;
}

std::string compare_json(const jobs::Comparison& comparison) { return json_of(comparison).dump(1) + "\n"; }

std::string compare_json(const jobs::Comparison& comparison, const jobs::Comparison& beside, const std::string& model) {
  nlohmann::ordered_json json = json_of(comparison);
  nlohmann::ordered_json other{{"model", model}};
  other.update(json_of(beside));
  json["beside"] = other;
  return json.dump(1) + "\n";
}

}  // namespace plumbline::report
