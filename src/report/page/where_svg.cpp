#include "report/page/where_svg.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/units.hpp"
#include "report/page/svg.hpp"

namespace plumbline::report {
namespace {

using diagnose::Diagnosis;

constexpr int kMapLeft = 60;  // px
constexpr int kArcDeg = 360 / diagnose::kArcs;

double noise_of(const Diagnosis& d, int channel) { return d.noise.channels[static_cast<std::size_t>(channel)].sigma; }

double times(double rms, double noise) { return noise > 0 ? rms / noise : 0; }

std::string text_at(double x, double y, const std::string& text, const char* anchor = "start") {
  return fmt::format(R"(<text x="{:.0f}" y="{:.0f}" text-anchor="{}">{}</text>)", x, y, anchor, text);
}

std::string opened(int width, int height) {
  return fmt::format(R"(<svg viewBox="0 0 {0} {1}" width="{0}" role="img">)", width, height);
}

std::string times_cell(double times_noise) {
  return fmt::format(R"(<td style="background:{}">{:.2f}</td>)", heat(times_noise), times_noise);
}

std::string two_cells(const Diagnosis& d, const diagnose::BarAndTorque& rms) {
  // the motors' noise is of one kind: the mean over those that were measured
  double torque = 0;
  int motors = 0;
  for (int channel = 1; channel < identify::kChannels; ++channel) {
    const identify::ChannelNoise& of = d.noise.channels[static_cast<std::size_t>(channel)];
    if (of.samples == 0) continue;
    torque += of.sigma * of.sigma;
    ++motors;
  }
  const bool bar = d.noise.channels[identify::kRadial].samples > 0;
  return (bar ? times_cell(times(rms.radial, noise_of(d, identify::kRadial))) : std::string("<td>-</td>")) +
         (motors > 0 ? times_cell(times(rms.torque, std::sqrt(torque / motors))) : std::string("<td>-</td>"));
}

std::string group_name(const diagnose::RunGroup& group) {
  if (group.by == diagnose::Grouping::tilt) return fmt::format("tilt {:.0f} to {:.0f} deg", group.from, group.to);
  if (group.by == diagnose::Grouping::feed) return fmt::format("feed F{:.0f}", group.from);
  if (group.by == diagnose::Grouping::payload) return fmt::format("payload {:.4g} kg", group.from);
  return fmt::format("begun {:.1f} to {:.1f} h", group.from, group.to);
}

// A bar from nil, with a whisker of twice its standard error; `scale` px per unit.
std::string signed_bar(double middle, double y, double value, double error, double scale) {
  const double end = middle + value * scale;
  const bool clear = std::abs(value) > 3 * error;
  std::string svg = fmt::format(R"(<rect x="{:.1f}" y="{:.0f}" width="{:.1f}" height="10" fill="{}"/>)",
                                std::min(middle, end), y, std::abs(end - middle), clear ? "#c0392b" : "#b9c4d0");
  return svg + fmt::format(R"(<path d="M{:.1f} {:.0f}H{:.1f}" stroke="#333"/>)", end - 2 * error * scale, y + 5,
                           end + 2 * error * scale);
}

double longest(const std::vector<diagnose::Reversal>& all, bool length) {
  double most = 0;
  for (const diagnose::Reversal& r : all) {
    most = std::max(most, length ? std::abs(r.length) + 2 * r.length_error : std::abs(r.torque) + 2 * r.torque_error);
  }
  return most;
}

}  // namespace

std::string circle_map(const Diagnosis& d) {
  const int second = kMapLeft + diagnose::kWaves * kMapCell + 30;
  const int width = second + diagnose::kArcs * kMapCell + 10;
  std::string svg = opened(width, 40 + kMapRow * static_cast<int>(d.gap_map.channels.size()));
  svg +=
      text_at(kMapLeft, 12, "waves around the circle, by order") + text_at(second, 12, "arcs of the circle, from deg");
  for (int k = 0; k < diagnose::kWaves; ++k) {
    svg += text_at(kMapLeft + k * kMapCell + kMapCell / 2.0, 30, std::to_string(k + 1), "middle");
  }
  for (int a = 0; a < diagnose::kArcs; ++a) {
    svg += text_at(second + a * kMapCell + kMapCell / 2.0, 30, std::to_string(a * kArcDeg), "middle");
  }
  int y = 36;
  for (const diagnose::ChannelResiduals& channel : d.gap_map.channels) {
    const std::string name = short_name(channel.channel);
    svg += text_at(kMapLeft - 6, y + 13, name, "end");
    for (int k = 0; k < diagnose::kWaves; ++k) {
      const auto i = static_cast<std::size_t>(k);
      svg += map_square(kMapLeft + k * kMapCell, y, times(channel.waves.at(i), channel.wave_noise.at(i)),
                        fmt::format("{}, order {}", name, k + 1));
    }
    for (int a = 0; a < diagnose::kArcs; ++a) {
      svg += map_square(second + a * kMapCell, y,
                        times(channel.arcs.at(static_cast<std::size_t>(a)), noise_of(d, channel.channel)),
                        fmt::format("{}, {} to {} deg", name, a * kArcDeg, (a + 1) * kArcDeg));
    }
    y += kMapRow;
  }
  return svg + "</svg>";
}

std::string contrast_table(const Diagnosis& d) {
  std::string html =
      "<table><tr><th>pairs of runs alike but for</th><th>pairs</th><th>bar: alike in both</th><th>torque</th><th>bar: "
      "differs</th><th>torque</th><th>bar: correlation</th><th>torque</th></tr>";
  for (const diagnose::Contrast& c : d.gap_map.contrasts) {
    html += fmt::format("<tr><td>{}</td><td>{}</td>{}{}<td>{:.2f}</td><td>{:.2f}</td></tr>", to_text(c.by), c.pairs,
                        two_cells(d, c.common), two_cells(d, c.differs), c.radial.correlation, c.torque.correlation);
  }
  return html + "</table>";
}

std::string group_table(const Diagnosis& d) {
  std::string html = "<table><tr><th>runs</th><th>how many</th><th>bar</th><th>torque</th></tr>";
  for (const diagnose::RunGroup& group : d.gap_map.groups) {
    html += fmt::format("<tr><td>{}</td><td>{}</td>{}</tr>", group_name(group), group.runs, two_cells(d, group.rms));
  }
  return html + "</table>";
}

std::string reversal_bars(const Diagnosis& d) {
  constexpr double kHalf = 110;  // px
  const double length = longest(d.gap_map.reversals, true);
  const double torque = longest(d.gap_map.reversals, false);
  std::string svg = opened(620, 40 + kMapRow * static_cast<int>(d.gap_map.reversals.size()));
  svg += text_at(kMapLeft, 12, fmt::format("as a length; the widest reaches {:.2f} um", length / kUm));
  svg += text_at(kMapLeft + 290, 12, fmt::format("as a torque; the widest reaches {:.3f} N m", torque));
  double y = 26;
  for (const diagnose::Reversal& r : d.gap_map.reversals) {
    svg += text_at(kMapLeft - 6, y + 10, fmt::format("strut {}", r.strut + 1), "end");
    if (r.length_error > 0) svg += signed_bar(kMapLeft + kHalf, y, r.length, r.length_error, kHalf / length);
    if (r.torque_error > 0) svg += signed_bar(kMapLeft + 290 + kHalf, y, r.torque, r.torque_error, kHalf / torque);
    y += kMapRow;
  }
  return svg + "</svg>";
}

std::string circularity_bars(const Diagnosis& d) {
  constexpr int kBars = 150;
  double most = 0;
  int count = 0;
  for (const diagnose::RunGap& run : d.runs) {
    if (!run.circularity) continue;
    ++count;
    most = std::max({most, run.circularity->measured, run.circularity->given, run.circularity->found});
  }
  if (count == 0 || most == 0) return {};
  std::string svg = opened(760, 30 * count + 4);
  int y = 2;
  for (const diagnose::RunGap& run : d.runs) {
    if (!run.circularity) continue;
    svg += text_at(kBars - 6, y + 17, escaped(run.id) + (run.held_out ? " (left out)" : ""), "end");
    const auto bar = [&](int row, double value, const char* colour) {
      const double width = 500 * value / most;
      svg += fmt::format(R"(<rect x="{}" y="{}" width="{:.1f}" height="7" fill="{}"/>)", kBars, y + 8 * row, width,
                         colour);
      svg += fmt::format(R"(<text x="{:.0f}" y="{}" style="font-size:8px">{:.1f}</text>)", kBars + width + 4,
                         y + 8 * row + 7, value / kUm);
    };
    bar(0, run.circularity->measured, "#b9c4d0");
    bar(1, run.circularity->given, "#c0392b");
    bar(2, run.circularity->found, "#1f5fa8");
    y += 30;
  }
  return svg + "</svg>";
}

}  // namespace plumbline::report
