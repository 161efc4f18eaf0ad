#include "report/page/svg.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace plumbline::report {
namespace {

using diagnose::ChannelGap;
using diagnose::Diagnosis;
using diagnose::RunGap;

constexpr std::size_t kMostBars = 8;

std::string closed_line(const RunGap& run, const Eigen::VectorXd& residual, double scale, const char* style) {
  std::string points;
  for (Eigen::Index i = 0; i < residual.size(); ++i) {
    const double r = std::max(55 + 25 * residual[i] / scale, 0.0);
    points += fmt::format("{:.1f},{:.1f} ", 90 + r * std::cos(run.angle[i]), 90 - r * std::sin(run.angle[i]));
  }
  return fmt::format(R"(<polygon points="{}" fill="none" {}/>)", points, style);
}

}  // namespace

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '<') {
      safe += "&lt;";
    } else if (c == '>') {
      safe += "&gt;";
    } else if (c == '&') {
      safe += "&amp;";
    } else if (c == '"') {
      safe += "&quot;";
    } else {
      safe += c;
    }
  }
  return safe;
}

std::string heat(double times_noise) {
  const double share = std::clamp(std::log10(std::max(times_noise, 1.0)), 0.0, 1.0);
  const int other = static_cast<int>(std::lround(245 - 195 * share));
  return fmt::format("rgb({},{},{})", 245 - static_cast<int>(std::lround(40 * share)), other, other);
}

std::string map_square(int x, int y, double times_noise, const std::string& title) {
  return fmt::format(
      R"(<rect x="{}" y="{}" width="{}" height="{}" fill="{}" stroke="#fff"><title>{}: {:.2f} times the noise</title></rect>)",
      x, y, kMapCell, kMapRow, heat(times_noise), title, times_noise);
}

std::string short_name(int channel) {
  return channel == identify::kRadial ? std::string("bar") : fmt::format("T{}", channel);
}

std::string gap_map(const Diagnosis& d) {
  constexpr int kLeft = 150;
  constexpr int kTop = 36;
  const int second = kLeft + identify::kChannels * kMapCell + 30;
  const int width = second + identify::kChannels * kMapCell + 10;
  const int height = kTop + kMapRow * static_cast<int>(d.runs.size()) + 6;
  std::string svg = fmt::format(R"(<svg viewBox="0 0 {} {}" width="{}" role="img">)", width, height, width);
  svg += fmt::format(R"(<text x="{}" y="12">before</text><text x="{}" y="12">after</text>)", kLeft, second);
  for (const int left : {kLeft, second}) {
    for (int c = 0; c < identify::kChannels; ++c) {
      svg += fmt::format(R"(<text x="{}" y="30" text-anchor="middle">{}</text>)", left + c * kMapCell + kMapCell / 2,
                         short_name(c));
    }
  }
  int y = kTop;
  for (const RunGap& run : d.runs) {
    svg += fmt::format(R"(<text x="{}" y="{}" text-anchor="end">{}{}</text>)", kLeft - 6, y + 13, escaped(run.id),
                       run.held_out ? " (left out)" : "");
    for (const ChannelGap& gap : run.channels) {
      const double noise = d.noise.channels[static_cast<std::size_t>(gap.channel)].sigma;
      const auto times = [noise](double rms) { return rms > 0 ? rms / noise : 0; };
      const std::string title = escaped(run.id) + ' ' + std::string(identify::channel_name(gap.channel));
      svg += map_square(kLeft + gap.channel * kMapCell, y, times(gap.before), title);
      svg += map_square(second + gap.channel * kMapCell, y, times(gap.after), title);
    }
    y += kMapRow;
  }
  return svg + "</svg>";
}

std::string polar_plot(const RunGap& run, double scale) {
  std::string svg = R"(<svg viewBox="0 0 180 196" width="180" role="img"><g fill="none" stroke="#ccc">)";
  for (const int r : {30, 55, 80}) {
    svg += fmt::format(R"(<circle cx="90" cy="90" r="{}"{}/>)", r, r == 55 ? "" : R"( stroke-dasharray="2 3")");
  }
  svg += R"(<path d="M5 90H175M90 5V175"/></g>)";
  svg += closed_line(run, run.radial_before, scale, R"(stroke="#c0392b" stroke-width="1")");
  svg += closed_line(run, run.radial_after, scale, R"(stroke="#1f5fa8" stroke-width="1.2")");
  svg += fmt::format(R"(<text x="90" y="192" text-anchor="middle">{}{}</text></svg>)", escaped(run.id),
                     run.held_out ? " (left out)" : "");
  return svg;
}

std::string evidence_bars(const Diagnosis& d) {
  const std::size_t count = std::min(d.evidence.size(), kMostBars);
  const double most = count > 0 ? std::max(d.evidence[0].log_odds, 1.0) : 1;
  std::string svg = fmt::format(R"(<svg viewBox="0 0 640 {0}" width="640" role="img">)", 24 * count + 4);
  for (std::size_t i = 0; i < count; ++i) {
    const diagnose::Evidence& e = d.evidence[i];
    const auto y = 24 * i;
    const bool named = std::find(d.confidence_set.begin(), d.confidence_set.end(), e.name) != d.confidence_set.end();
    const double width = 340 * std::max(e.log_odds, 0.0) / most;
    svg += fmt::format(
        R"(<text x="190" y="{}" text-anchor="end">{}</text><rect x="200" y="{}" width="{:.1f}" height="16" fill="{}"/>)"
        R"(<text x="{:.1f}" y="{}">{:.0f} nats</text>)",
        y + 15, escaped(e.name), y + 3, width, named ? "#1f5fa8" : "#b9c4d0", 206 + width, y + 15, e.log_odds);
  }
  return svg + "</svg>";
}

}  // namespace plumbline::report
