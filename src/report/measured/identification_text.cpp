#include "report/measured/identification_text.hpp"

#include <cmath>
#include <map>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/units.hpp"
#include "identify/unknowns/geometry.hpp"
#include "report/measured/objection_text.hpp"
#include "report/measured/observability_text.hpp"
#include "report/text_table.hpp"

namespace plumbline::report {
namespace {

using identify::Fit;
using identify::Identification;
using identify::Stage;
using identify::Unknown;
using nlohmann::ordered_json;

double value_of(const Fit& fit, std::size_t i) { return fit.values[static_cast<Eigen::Index>(i)]; }

std::string values_text(const Fit& fit) {
  std::string text = fmt::format("{:<32}{:>12}{:>12}{:>12}{:>12}   unit\n", "", "before", "found", "+-", "known to");
  std::map<std::string, std::pair<int, double>> crowds;  // how many, and the largest of them
  for (std::size_t i = 0; i < fit.unknowns.size(); ++i) {
    const Unknown& u = fit.unknowns[i];
    const double si = u.unit.si;
    if (identify::is_geometry(u)) {
      auto& [count, largest] = crowds[u.effect];
      ++count;
      largest = std::max(largest, std::abs(value_of(fit, i) - u.start) / si);
      continue;
    }
    text += fmt::format("{:<32}{:>12.6g}{:>12.6g}{:>12.2g}{:>12}   {}\n", u.label, u.start / si, value_of(fit, i) / si,
                        fit.standard_error(i) / si, u.free() ? "-" : fmt::format("{:.2g}", u.sigma / si), u.unit.name);
  }
  for (const auto& [effect, crowd] : crowds) {
    text += fmt::format("{:<32}{}, moved by up to {:.2f} um\n", effect,
                        count_text(static_cast<std::uint64_t>(crowd.first), "number"), crowd.second);
  }
  return text;
}

// "  12.3 +- 0.8" for each number of a key, `each` in a line that begins with a name and its number.
std::string crowd_text(const Fit& fit, std::string_view effect, const char* key, std::string_view name, int each) {
  std::string text;
  for (int i = 0;; ++i) {
    const int place = fit.unknowns.find(effect, key, i);
    if (place < 0) return text;
    const auto u = static_cast<std::size_t>(place);
    const double si = fit.unknowns[u].unit.si;
    if (i % each == 0) text += fmt::format("{:<18}", fmt::format("{} {}", name, i / each + 1));
    text += fmt::format("{:>10.2f} +- {:<7.2g}{}", value_of(fit, u) / si, fit.standard_error(u) / si,
                        i % each == each - 1 ? "\n" : "");
  }
}

std::string geometry_text(const Fit& fit) {
  return "true minus believed, um:         x                   y                   z\n" +
         crowd_text(fit, physics::JointPosition::name, "base_um", "base joint", 3) +
         crowd_text(fit, physics::JointPosition::name, "platform_um", "platform joint", 3) +
         "longer than commanded, um:\n" + crowd_text(fit, physics::StrutOffset::name, "length_um", "strut", 1);
}

std::string noise_text(const identify::NoiseModel& noise) {
  std::string text;
  std::vector<std::string> torques;
  for (int c = 0; c < identify::kAllChannels; ++c) {
    const identify::ChannelNoise& channel = noise.channels[static_cast<std::size_t>(c)];
    if (channel.samples == 0) continue;
    if (c == identify::kRadial) {
      text += fmt::format("noise of the bar: {:.3f} um\n", channel.sigma / kUm);
    } else if (c == identify::kTracker) {
      text += fmt::format("noise of the tracker: {:.2f} um\n", channel.sigma / kUm);
    } else if (c == identify::kTrackerTilt) {
      text += fmt::format("noise of the tracker's angles: {:.2f} urad\n", channel.sigma / kUrad);
    } else {
      torques.push_back(fmt::format("{:.4f}", channel.sigma));
    }
  }
  if (!torques.empty()) text += fmt::format("noise of the torques: {} N m\n", fmt::join(torques, ", "));
  return text;
}

std::string stage_text(const Stage& stage) {
  const Fit& fit = stage.fit;
  std::string text =
      fmt::format("{} fit: {}, {}, {}\n", stage.name, count_text(static_cast<std::uint64_t>(fit.readings), "reading"),
                  count_text(fit.unknowns.size(), "unknown"),
                  fit.converged ? "converged" : "NOT CONVERGED: " + fit.stopped_because);
  text += values_text(fit);
  if (stage.name == "calibration") text += geometry_text(fit);
  text += noise_text(fit.noise);
  for (const std::string& sentence : observability_text(stage)) text += "note: " + sentence + "\n";
  return text;
}

ordered_json finite_or_null(double value) { return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr); }

ordered_json unknowns_json(const Fit& fit) {
  ordered_json all = ordered_json::array();
  for (std::size_t i = 0; i < fit.unknowns.size(); ++i) {
    const Unknown& u = fit.unknowns[i];
    ordered_json one{{"label", u.label}, {"effect", u.effect}, {"key", u.key}, {"unit", u.unit.name}};
    if (u.index >= 0) one["index"] = u.index;
    one["before"] = u.start / u.unit.si;
    one["value"] = value_of(fit, i) / u.unit.si;
    one["standard_error"] = finite_or_null(fit.standard_error(i) / u.unit.si);
    one["prior_sigma"] = u.free() ? ordered_json(nullptr) : ordered_json(u.sigma / u.unit.si);
    all.push_back(std::move(one));
  }
  return all;
}

// Poses left out in turn; null: there were too few, or nothing of that kind was read.
ordered_json predicted_json(const identify::Predicted& predicted, double unit) {
  if (predicted.readings == 0) return nullptr;
  return {{"before", predicted.before / unit}, {"after", predicted.after / unit}};
}

ordered_json gain_json(const identify::TipGain& gain) {
  return {{"moved_um", gain.moved / kUm},
          {"doubt_um", gain.doubt / kUm},
          {"gain_sigmas", gain.sigmas},
          {"chance_of_worse", gain.chance}};
}

// What of the change stays out, as it might make the tip worse; null: that was not asked.
ordered_json held_json(const std::optional<identify::Held>& held) {
  if (!held) return nullptr;
  return {{"share", held->share},
          {"back_um", held->back / kUm},
          {"tip", gain_json(held->whole)},
          {"tip_zero_touched_off", gain_json(held->off_the_part)}};
}

ordered_json stage_json(const Stage& stage) {
  const Fit& fit = stage.fit;
  ordered_json json{{"name", stage.name},       {"converged", fit.converged}, {"iterations", fit.iterations},
                    {"readings", fit.readings}, {"misfit", fit.misfit},       {"unknowns", unknowns_json(fit)}};
  ordered_json rows = ordered_json::array();
  for (std::size_t i = 0; i < fit.unknowns.size(); ++i) {
    ordered_json row = ordered_json::array();
    for (std::size_t k = 0; k < fit.unknowns.size(); ++k) row.push_back(finite_or_null(fit.correlation(i, k)));
    rows.push_back(std::move(row));
  }
  json["correlations"] = std::move(rows);
  const Eigen::VectorXd& singular = stage.observability.singular_values;
  json["singular_values"] = std::vector<double>(singular.begin(), singular.end());
  json["cannot_tell"] = observability_text(stage);
  json["objection"] = stage.objection ? ordered_json(objection_text(stage)) : ordered_json();
  json["strained"] = ordered_json::array();
  for (const identify::Strain& strain : stage.plausible.strained) {
    json["strained"].push_back({{"label", fit.unknowns[strain.unknown].label}, {"sigmas", strain.sigmas}});
  }
  json["borne_out"] = stage.borne_out;
  json["prior_chi2"] = {{"value", stage.plausible.chi2}, {"degrees", stage.plausible.degrees}};
  json["held"] = held_json(stage.held);
  json["left_out"] = {{"radial_rms_um", predicted_json(stage.plausible.radial, kUm)},
                      {"torque_rms_Nm", predicted_json(stage.plausible.torque, 1)}};
  for (int c = 0; c < identify::kAllChannels; ++c) {
    const identify::ChannelNoise& noise = fit.noise.channels[static_cast<std::size_t>(c)];
    if (noise.samples == 0) continue;
    const bool length = c == identify::kRadial || c == identify::kTracker;
    const bool angle = c == identify::kTrackerTilt;
    json["noise"][std::string(identify::channel_name(c))] = {{length  ? "sigma_um"
                                                              : angle ? "sigma_urad"
                                                                      : "sigma_Nm",
                                                              noise.sigma / (length  ? kUm
                                                                             : angle ? kUrad
                                                                                     : 1)},
                                                             {"memory", noise.memory},
                                                             {"white", noise.white}};
  }
  return json;
}

ordered_json gap_json(const identify::Misfit& misfit) {
  const bool bar = misfit.radial_readings > 0;
  const bool torques = misfit.torque_readings > 0;
  return {
      {"radial_rms_um", bar ? ordered_json(misfit.radial_rms / kUm) : ordered_json(nullptr)},
      {"torque_rms_Nm", torques ? ordered_json(misfit.torque_rms) : ordered_json(nullptr)},
      {"torque_mean_abs_Nm", torques ? ordered_json(misfit.torque_mean_abs) : ordered_json(nullptr)},
      {"tracker_rms_um", misfit.tracker_readings > 0 ? ordered_json(misfit.tracker_rms / kUm) : ordered_json(nullptr)},
      {"tracker_tilt_rms_urad",
       misfit.tilt_readings > 0 ? ordered_json(misfit.tilt_rms / kUrad) : ordered_json(nullptr)}};
}

}  // namespace

std::string identification_text(const Identification& found) {
  std::string text;
  for (const Stage& stage : found.stages) text += stage_text(stage) + "\n";
  const identify::Misfit& a = found.before;
  const identify::Misfit& b = found.after;
  if (a.radial_readings > 0) {
    text += fmt::format("bar readings: rms {:.3f} -> {:.3f} um\n", a.radial_rms / kUm, b.radial_rms / kUm);
  }
  if (a.torque_readings > 0) {
    text += fmt::format("torques: rms {:.4f} -> {:.4f} N m, mean error {:.4f} -> {:.4f} N m\n", a.torque_rms,
                        b.torque_rms, a.torque_mean_abs, b.torque_mean_abs);
  }
  if (a.tracker_readings > 0) {
    text += fmt::format("tracker: rms {:.2f} -> {:.2f} um", a.tracker_rms / kUm, b.tracker_rms / kUm);
    if (a.tilt_readings > 0) text += fmt::format(", {:.2f} -> {:.2f} urad", a.tilt_rms / kUrad, b.tilt_rms / kUrad);
    text += "\n";
  }
  return text;
}

std::string identification_json(const Identification& found) {
  ordered_json json{{"plumbline", "identification 1"}, {"converged", found.converged()}};
  json["stages"] = ordered_json::array();
  for (const Stage& stage : found.stages) json["stages"].push_back(stage_json(stage));
  json["gap"] = {{"before", gap_json(found.before)}, {"after", gap_json(found.after)}};
  return json.dump(1) + "\n";
}

}  // namespace plumbline::report
