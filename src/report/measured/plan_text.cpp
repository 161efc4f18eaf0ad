#include "report/measured/plan_text.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/axes.hpp"
#include "base/units.hpp"
#include "identify/unknowns/geometry.hpp"
#include "report/measured/could_show_text.hpp"
#include "report/measured/observability_text.hpp"
#include "report/text_table.hpp"

namespace plumbline::report {
namespace {

using identify::Fit;
using identify::Unknown;
using nlohmann::ordered_json;

std::string runs_text(const jobs::PlannedTests& plan) {
  std::string text = fmt::format("{:<9}{:>24}{:>9}{:>18}{:>6}{:>9}{:>10}{:>12}\n", "run", "centre, mm", "radius",
                                 "A, B, deg", "", "mm/min", "payload", "criterion");
  for (std::size_t i = 0; i < plan.dataset.runs.size(); ++i) {
    const measure::Run& run = plan.dataset.runs[i];
    const Vector3<double> c = run.centre_W / kMm;
    text += fmt::format("{:<9}{:>24}{:>9.6g}{:>18}{:>6}{:>9.6g}{:>10}{:>12.2f}\n", run.id,
                        fmt::format("{:.6g}, {:.6g}, {:.6g}", c.x(), c.y(), c.z()), run.radius / kMm,
                        fmt::format("{:.6g}, {:.6g}", run.tilt.x() / kDeg, run.tilt.y() / kDeg), to_text(run.direction),
                        run.feed / kMmPerMin, run.payload_mass > 0 ? fmt::format("{:.6g} kg", run.payload_mass) : "-",
                        plan.criterion[i]);
  }
  return text;
}

std::string error_text(const Fit& fit, std::size_t i) {
  const double error = fit.standard_error(i);
  return std::isfinite(error) ? fmt::format("{:.3g}", error / fit.unknowns[i].unit.si) : "-";
}

// Many numbers of one key: their median and the largest.
struct Crowd {
  std::vector<double> before, after;
  std::string_view unit;
};

std::string crowd_line(const std::string& name, Crowd& crowd) {
  const auto median = [](std::vector<double>& values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
  };
  const double before = median(crowd.before);
  const double after = median(crowd.after);
  return fmt::format("{:<34}{:>12.3g}{:>12.3g}   {}, median of {}; largest {:.3g}\n", name, before, after, crowd.unit,
                     crowd.after.size(), crowd.after.back());
}

std::string errors_text(const jobs::PlannedTests& plan) {
  std::string text = fmt::format("{:<34}{:>12}{:>12}   unit\n", "standard error", "before", "after");
  std::map<std::string, Crowd> crowds;
  for (const std::size_t i : plan.asked) {
    const Unknown& u = plan.after.unknowns[i];
    if (identify::is_geometry(u)) {
      Crowd& crowd = crowds[fmt::format("{} {}", u.effect, u.key)];
      crowd.unit = u.unit.name;
      crowd.before.push_back(plan.before.standard_error(i) / u.unit.si);
      crowd.after.push_back(plan.after.standard_error(i) / u.unit.si);
      continue;
    }
    text += fmt::format("{:<34}{:>12}{:>12}   {}\n", u.label, error_text(plan.before, i), error_text(plan.after, i),
                        u.unit.name);
  }
  for (auto& [name, crowd] : crowds) text += crowd_line(name, crowd);
  return text;
}

std::string tip_text(const jobs::PlannedTip& tip) {
  std::string text = fmt::format("the tip over {}, 1 sigma\n", box_text(tip));
  const auto line = [&](const char* name, double before, double after) {
    text += fmt::format("{:<34}{:>12.3g}{:>12.3g}   um\n", name, before / kUm, after / kUm);
  };
  const jobs::TipOverBox& after = tip.after.back();
  line("as it stands, rms", tip.before.stands.rms, after.stands.rms);
  line("as it stands, worst", tip.before.stands.worst, after.stands.worst);
  line("zero touched off, rms", tip.before.touched_off.rms, after.touched_off.rms);
  line("zero touched off, worst", tip.before.touched_off.worst, after.touched_off.worst);
  return text;
}

ordered_json figures_json(const jobs::TipFigures& figures) {
  ordered_json at;
  for (const Axis axis : kAllAxes) {
    const bool turns = index(axis) >= index(Axis::A);
    at[fmt::format("{}_{}", static_cast<char>(std::tolower(letter(axis))), turns ? "deg" : "mm")] =
        figures.worst_at[axis];
  }
  return {{"rms_um", figures.rms / kUm}, {"worst_um", figures.worst / kUm}, {"worst_at", std::move(at)}};
}

ordered_json over_box_json(const jobs::TipOverBox& over) {
  return {{"stands", figures_json(over.stands)}, {"touched_off", figures_json(over.touched_off)}};
}

ordered_json tip_json(const jobs::PlannedTip& tip) {
  ordered_json json{{"box_mm", ordered_json::array()}, {"tilts_deg", ordered_json::array()}};
  for (const machine::Range& side : tip.box) json["box_mm"].push_back({side.lower / kMm, side.upper / kMm});
  for (const double tilt : tip.tilts) json["tilts_deg"].push_back(tilt / kDeg);
  json["poses"] = tip.poses;
  json["reached"] = tip.reached;
  json["before"] = over_box_json(tip.before);
  json["after"] = ordered_json::array();
  for (const jobs::TipOverBox& after : tip.after) json["after"].push_back(over_box_json(after));
  return json;
}

// null: nothing tells it.
ordered_json error_json(double value) { return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr); }

ordered_json planned_run_json(const measure::Run& run, double criterion) {
  const Vector3<double> c = run.centre_W / kMm;
  const Vector3<double> t = run.tilt / kDeg;
  return {{"id", run.id},
          {"centre_mm", {c.x(), c.y(), c.z()}},
          {"radius_mm", run.radius / kMm},
          {"bar_mm", run.bar ? ordered_json(*run.bar / kMm) : ordered_json(nullptr)},
          {"tilt_deg", {t.x(), t.y(), t.z()}},
          {"direction", to_text(run.direction)},
          {"feed_mm_min", run.feed / kMmPerMin},
          {"start_s", run.start},
          {"payload_kg", run.payload_mass},
          {"criterion", criterion}};
}

}  // namespace

std::string box_text(const jobs::PlannedTip& tip) {
  std::vector<std::string> sides, tilts;
  for (std::size_t a = 0; a < tip.box.size(); ++a) {
    sides.push_back(
        fmt::format("{} {:.6g} to {:.6g}", kAxisLetters[a], tip.box[a].lower / kMm, tip.box[a].upper / kMm));
  }
  for (const double tilt : tip.tilts) tilts.push_back(fmt::format("{:.6g}", tilt / kDeg));
  return fmt::format("{} mm, tilted by {} deg ({} of {} in reach)", fmt::join(sides, ", "), fmt::join(tilts, ", "),
                     tip.reached, count_text(tip.poses, "pose"));
}

std::vector<std::string> unseen_text(const jobs::PlannedTests& plan) {
  std::vector<std::string> sentences = observability_text(plan.after, plan.unseen);
  if (!plan.geometry) return sentences;
  for (std::string& sentence : shown_geometry_text(*plan.geometry)) sentences.push_back(std::move(sentence));
  return sentences;
}

std::string plan_text(const jobs::PlannedTests& plan) {
  std::string text =
      fmt::format("{} of {}\n", count_text(plan.dataset.runs.size(), "run"), count_text(plan.candidates, "candidate"));
  text += runs_text(plan) + "\n" + errors_text(plan);
  if (plan.tip) text += tip_text(*plan.tip);
  if (!plan.apart.empty()) {
    text += fmt::format(
        "distance of the weakest number of each from the other effect: {:.3g} and {:.3g} sigma for a "
        "hundredth of its range\n",
        plan.apart[0], plan.apart[1]);
  }
  text += could_show_text(plan.could_name, plan.named_by, true);
  for (const std::string& sentence : unseen_text(plan)) text += "note: " + sentence + "\n";
  return text;
}

std::string plan_json(const jobs::PlannedTests& plan) {
  ordered_json json{{"plumbline", "plan 1"}, {"candidates", plan.candidates}};
  json["runs"] = ordered_json::array();
  for (std::size_t i = 0; i < plan.dataset.runs.size(); ++i) {
    json["runs"].push_back(planned_run_json(plan.dataset.runs[i], plan.criterion[i]));
  }
  json["unknowns"] = ordered_json::array();
  for (const std::size_t i : plan.asked) {
    const Unknown& u = plan.after.unknowns[i];
    ordered_json one{{"label", u.label}, {"effect", u.effect}, {"key", u.key}, {"unit", u.unit.name}};
    if (u.index >= 0) one["index"] = u.index;
    one["before"] = error_json(plan.before.standard_error(i) / u.unit.si);
    one["after"] = error_json(plan.after.standard_error(i) / u.unit.si);
    json["unknowns"].push_back(std::move(one));
  }
  if (plan.tip) json["tip"] = tip_json(*plan.tip);
  if (!plan.apart.empty()) json["apart_sigma"] = plan.apart;
  json["cannot_tell"] = unseen_text(plan);
  json["could_name"] = could_show_json(plan.could_name);
  return json.dump(1) + "\n";
}

}  // namespace plumbline::report
