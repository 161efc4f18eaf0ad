#include "report/page/where_sections.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "base/angle.hpp"
#include "base/units.hpp"
#include "report/page/measured_sections.hpp"
#include "report/page/sections.hpp"

namespace plumbline::report {
namespace {

using diagnose::Diagnosis;
using diagnose::RunGap;

constexpr int kArcDeg = 360 / diagnose::kArcs;
constexpr std::pair<double, double> kTimesNoise{1, 10};  // the colours: the noise and less, ten times that and more
constexpr const char* kTimesWords =
    "In units of the noise: 1 is noise alone; the colours end at 10 times the noise and more.";
const std::string kTimesUnit = "times the noise";

double noise_of(const Diagnosis& d, int channel) { return d.noise.channels[static_cast<std::size_t>(channel)].sigma; }

double times(double rms, double noise) { return noise > 0 ? rms / noise : std::nan(""); }

// The motors' noise is of one kind: the mean over those that were measured.
double torque_noise(const Diagnosis& d) {
  double squares = 0;
  int motors = 0;
  for (int channel = 1; channel < identify::kChannels; ++channel) {
    const identify::ChannelNoise& of = d.noise.channels[static_cast<std::size_t>(channel)];
    if (of.samples == 0) continue;
    squares += of.sigma * of.sigma;
    ++motors;
  }
  return motors > 0 ? std::sqrt(squares / motors) : 0;
}

// Of what was not measured null.
Json times_json(double rms, double noise) { return noise > 0 ? Json(rms / noise) : Json(nullptr); }

double bar_noise(const Diagnosis& d) {
  return d.noise.channels[identify::kRadial].samples > 0 ? noise_of(d, identify::kRadial) : 0;
}

HeatFigure gap_figure(const Diagnosis& d, std::string name, double diagnose::ChannelGap::*which) {
  HeatPlane plane{""};
  for (const RunGap& run : d.runs) {
    std::vector<double> row(identify::kChannels, std::nan(""));
    for (const diagnose::ChannelGap& gap : run.channels) {
      row[static_cast<std::size_t>(gap.channel)] = times(gap.*which, noise_of(d, gap.channel));
    }
    for (const double value : row) {
      plane.values.push_back(value);
      plane.reasons.push_back(std::isfinite(value) ? -1 : 0);
    }
  }
  return {std::move(name), kTimesUnit, 2, {std::move(plane)}, kTimesNoise, true};
}

std::string group_name(const diagnose::RunGroup& group) {
  if (group.by == diagnose::Grouping::tilt) return fmt::format("tilt {:.0f} to {:.0f} deg", group.from, group.to);
  if (group.by == diagnose::Grouping::feed) return fmt::format("feed {:.0f} mm/min", group.from);
  if (group.by == diagnose::Grouping::payload) return fmt::format("payload {:.4g} kg", group.from);
  return fmt::format("begun {:.1f} to {:.1f} h", group.from, group.to);
}

Json contrast_section(const Diagnosis& d) {
  std::vector<Json> rows;
  for (const diagnose::Contrast& c : d.gap_map.contrasts) {
    rows.push_back({to_text(c.by), c.pairs, times_json(c.common.radial, bar_noise(d)),
                    times_json(c.common.torque, torque_noise(d)), times_json(c.differs.radial, bar_noise(d)),
                    times_json(c.differs.torque, torque_noise(d)), c.radial.correlation, c.torque.correlation});
  }
  return table_section("Pairs of runs at one pose, before",
                       {{"alike but for"},
                        {"pairs", "", 0},
                        {"bar: alike in both", "", 2},
                        {"torque: alike in both", "", 2},
                        {"bar: differs", "", 2},
                        {"torque: differs", "", 2},
                        {"bar: correlation", "", 2},
                        {"torque: correlation", "", 2}},
                       std::move(rows),
                       "Rms in times the noise: 1 is noise alone. What differs with direction is odd in it: friction, "
                       "backlash, lag. The "
                       "correlation is that of the waves of both runs: of noise it is none.");
}

Json group_section(const Diagnosis& d) {
  std::vector<Json> rows;
  for (const diagnose::RunGroup& group : d.gap_map.groups) {
    rows.push_back({group_name(group), group.runs, times_json(group.rms.radial, bar_noise(d)),
                    times_json(group.rms.torque, torque_noise(d))});
  }
  return table_section("Groups of runs, before", {{"runs"}, {"how many", "", 0}, {"bar", "", 2}, {"torque", "", 2}},
                       std::move(rows), "Rms in times the noise: 1 is noise alone.");
}

Bar step_bar(double value, double error, double unit) {
  if (error <= 0) return {{}, {}, {}, 1, "not measured"};
  const bool clear = std::abs(value) > 3 * error;
  return {value / unit, (value - 2 * error) / unit, (value + 2 * error) / unit, clear ? 2 : 1};
}

Json reversal_section(const Diagnosis& d, std::string title, bool length) {
  BarChart chart{length ? "um" : "N m", length ? 2 : 3, {{"step", 1}}};
  for (const diagnose::Reversal& r : d.gap_map.reversals) {
    const Bar bar = length ? step_bar(r.length, r.length_error, kUm) : step_bar(r.torque, r.torque_error, 1);
    chart.rows.push_back({fmt::format("strut {}", r.strut + 1), {bar}});
  }
  chart.words =
      "In the direction of growing strut speed; whiskers: two standard errors. Orange: more than three of them.";
  return bars_section(std::move(title), chart);
}

}  // namespace

std::string channel_words(int channel) {
  return channel == identify::kRadial ? std::string("bar") : fmt::format("motor {}", channel);
}

std::string run_words(const RunGap& run) { return run.id + (run.held_out ? " (left out)" : ""); }

Json gap_map_section(const Diagnosis& d) {
  HeatMap map;
  map.rows = {"Run"};
  map.columns = {"Channel"};
  map.reasons = {"not measured"};
  map.words = kTimesWords;
  for (const RunGap& run : d.runs) map.rows.labels.push_back(run_words(run));
  for (int c = 0; c < identify::kChannels; ++c) map.columns.labels.push_back(channel_words(c));
  map.figures.push_back(gap_figure(d, "before", &diagnose::ChannelGap::before));
  map.figures.push_back(gap_figure(d, "after", &diagnose::ChannelGap::after));
  if (!d.runner_up.empty()) {
    map.figures.push_back(gap_figure(d, "with " + d.runner_up, &diagnose::ChannelGap::runner_up));
  }
  return heat_section("Where the gap is: run by channel", map);
}

std::vector<Json> around_circle_sections(const Diagnosis& d) {
  if (d.gap_map.channels.empty()) return {};
  HeatMap waves;
  HeatMap arcs;
  waves.rows = arcs.rows = {"Channel"};
  waves.columns = {"Order of the wave"};
  arcs.columns = {"Arc from", "deg"};
  waves.words = arcs.words = kTimesWords;
  waves.reasons = arcs.reasons = {"not measured"};
  for (int k = 1; k <= diagnose::kWaves; ++k) waves.columns.labels.push_back(std::to_string(k));
  for (int a = 0; a < diagnose::kArcs; ++a) arcs.columns.values.push_back(a * kArcDeg);
  HeatPlane of_waves{""};
  HeatPlane of_arcs{""};
  for (const diagnose::ChannelResiduals& channel : d.gap_map.channels) {
    waves.rows.labels.push_back(channel_words(channel.channel));
    for (std::size_t k = 0; k < channel.waves.size(); ++k) {
      of_waves.values.push_back(times(channel.waves.at(k), channel.wave_noise.at(k)));
    }
    for (const double rms : channel.arcs) of_arcs.values.push_back(times(rms, noise_of(d, channel.channel)));
  }
  arcs.rows.labels = waves.rows.labels;
  waves.figures.push_back({"before", kTimesUnit, 2, {std::move(of_waves)}, kTimesNoise, true});
  arcs.figures.push_back({"before", kTimesUnit, 2, {std::move(of_arcs)}, kTimesNoise, true});
  return {heat_section("Waves around the circle, before", waves), heat_section("Place on the circle, before", arcs)};
}

std::vector<Json> run_contrast_sections(const Diagnosis& d) {
  std::vector<Json> sections;
  if (!d.gap_map.contrasts.empty()) sections.push_back(contrast_section(d));
  if (!d.gap_map.groups.empty()) sections.push_back(group_section(d));
  const auto any = [&](double diagnose::Reversal::*error) {
    return std::any_of(d.gap_map.reversals.begin(), d.gap_map.reversals.end(),
                       [&](const diagnose::Reversal& r) { return r.*error > 0; });
  };
  if (any(&diagnose::Reversal::length_error)) {
    sections.push_back(reversal_section(d, "Steps where struts turn around, before: as a length", true));
  }
  if (any(&diagnose::Reversal::torque_error)) {
    sections.push_back(reversal_section(d, "Steps where struts turn around, before: as a torque", false));
  }
  return sections;
}

Json residual_circles_section(const Diagnosis& d, const std::vector<measure::Run>& runs) {
  std::vector<PolarGroup> groups;
  for (const RunGap& run : d.runs) {
    if (run.radial_before.size() == 0) continue;
    std::vector<Eigen::Index> order(static_cast<std::size_t>(run.angle.size()));
    std::iota(order.begin(), order.end(), Eigen::Index{0});
    const auto angle = [&](Eigen::Index i) { return within_turn(run.angle[i]) / kDeg; };
    std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return angle(a) < angle(b); });
    PolarCurve before{"before", 2, 2};
    PolarCurve after{"after", 1, 1};
    for (const Eigen::Index i : order) {
      before.angle_deg.push_back(angle(i));
      before.deviation_um.push_back(run.radial_before[i] / kUm);
      after.deviation_um.push_back(run.radial_after[i] / kUm);
    }
    after.angle_deg = before.angle_deg;
    PolarGroup group{run_words(run), 0, {std::move(before), std::move(after)}};
    const auto design = std::find_if(runs.begin(), runs.end(), [&](const auto& one) { return one.id == run.id; });
    if (design != runs.end()) group.radius_mm = design->radius / kMm;
    for (const diagnose::ChannelGap& gap : run.channels) {
      if (gap.channel != identify::kRadial) continue;
      group.figures = {{"before, rms", gap.before / kUm}, {"after, rms", gap.after / kUm}};
    }
    groups.push_back(std::move(group));
  }
  if (groups.empty()) return nullptr;
  return polar_section("The gap around the circle, before and after", groups,
                       "Readings of the bar minus what the model says of them, the set-up of each run fitted.");
}

Json circularity_section(const Diagnosis& d) {
  BarChart chart{
      "um",
      1,
      {{"as measured", 6}, {"compensated with the model as given", 2}, {"compensated with what was found", 1}}};
  for (const RunGap& run : d.runs) {
    if (!run.circularity) continue;
    chart.rows.push_back({run_words(run),
                          {{run.circularity->measured / kUm, {}, {}, 6},
                           {run.circularity->given / kUm, {}, {}, 2},
                           {run.circularity->found / kUm, {}, {}, 1}}});
  }
  if (chart.rows.empty()) return nullptr;
  chart.words =
      "Circularity of each circle (max - min about the least-squares circle), noise included: as measured, and "
      "predicted if its program is compensated.";
  return bars_section("What it is good for", chart);
}

}  // namespace plumbline::report
