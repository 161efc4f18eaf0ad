#include "report/page/diagnosis_page.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/units.hpp"
#include "report/measured/diagnosis_text.hpp"
#include "report/measured/next_test_text.hpp"
#include "report/measured/objection_text.hpp"
#include "report/page/svg.hpp"
#include "report/page/where_svg.hpp"

namespace plumbline::report {
namespace {

using diagnose::Diagnosis;
using diagnose::Gap;
using diagnose::NamedEffect;
using diagnose::NamedParameter;

constexpr const char* kStyle =
    "body{font:15px/1.5 system-ui,sans-serif;color:#222;max-width:1000px;margin:2em auto;padding:0 1em}"
    "h1{font-size:1.6em;margin:0}h2{font-size:1.15em;margin:2em 0 .4em;border-bottom:1px solid #ddd}"
    "svg text{font:11px system-ui,sans-serif;fill:#333}table{border-collapse:collapse}"
    "td,th{padding:.2em .9em;text-align:right;border-bottom:1px solid "
    "#eee}td:first-child,th:first-child{text-align:left}"
    ".verdict{font-size:1.25em;margin:.6em 0}.quiet{color:#666}.polar{display:flex;flex-wrap:wrap;gap:6px}"
    ".b{color:#c0392b}.a{color:#1f5fa8}pre{background:#f6f6f6;padding:.7em;white-space:pre-wrap}";

std::string verdict_text(const Diagnosis& d) {
  switch (d.verdict) {
    case diagnose::Verdict::nothing_missing:
      return "Nothing is missing that these runs could show: what model and measurements differ by is noise.";
    case diagnose::Verdict::unknown:
      return "There is a gap, and no effect of the catalogue explains it.";
    case diagnose::Verdict::named:
      break;
  }
  return fmt::format("The model misses: {}.", escaped(names_text(d)));
}

std::string figure(const std::optional<double>& value, double unit, int decimals) {
  return value ? fmt::format("{:.{}f}", *value / unit, decimals) : "-";
}

std::string gap_row(const char* what, const Gap& gap, bool second) {
  const auto pair = [&](auto of, double unit, int decimals) {
    std::string cells = fmt::format("<td>{}</td>", figure(of(gap.before), unit, decimals));
    if (second) cells += fmt::format("<td>{}</td>", figure(of(gap.runner_up), unit, decimals));
    return cells + fmt::format("<td>{}</td>", figure(of(gap.after), unit, decimals));
  };
  return fmt::format("<tr><td>{}</td>{}{}</tr>", what, pair([](const diagnose::Rms& r) { return r.radial; }, kUm, 2),
                     pair([](const diagnose::Rms& r) { return r.torque; }, 1, 3));
}

std::string gap_table(const Diagnosis& d) {
  const bool second = !d.runner_up.empty();
  const std::string middle = second ? fmt::format("<th>with {}</th>", escaped(d.runner_up)) : "";
  std::string html = fmt::format(
      "<table><tr><th></th><th>bar, um: before</th>{0}<th>after</th><th>torque, N m: before</th>{0}<th>after</th></tr>",
      middle);
  html += gap_row("fitted runs", d.fit, second) + gap_row("runs left out", d.held_out, second) + "</table>";
  const auto noise = [&](int channel, double unit, int decimals, const char* unit_name) {
    const identify::ChannelNoise& of = d.noise.channels[static_cast<std::size_t>(channel)];
    return of.samples > 0 ? fmt::format("{:.{}f} {}", of.sigma / unit, decimals, unit_name) : "not measured";
  };
  return html + fmt::format("<p class=quiet>Noise, from the spectrum of what is left: bar {}, torque {}.</p>",
                            noise(identify::kRadial, kUm, 2, "um"), noise(1, 1, 3, "N m"));
}

std::string polar_plots(const Diagnosis& d) {
  const auto has_bar = [](const diagnose::RunGap& run) { return run.radial_before.size() > 0; };
  if (std::none_of(d.runs.begin(), d.runs.end(), has_bar)) return {};
  double most = kUm;
  for (const diagnose::RunGap& run : d.runs) {
    if (has_bar(run)) most = std::max(most, run.radial_before.cwiseAbs().maxCoeff());
  }
  const double scale = 0.6 * most;
  std::string html = "<div class=polar>";
  for (const diagnose::RunGap& run : d.runs) {
    if (has_bar(run)) html += polar_plot(run, scale);
  }
  return html + fmt::format(
                    "</div><p class=quiet>Bar readings minus model, the set-up fitted: <span class=b>before</span>, "
                    "<span class=a>after</span>. Rings are {:.1f} um apart.</p>",
                    scale / kUm);
}

// What the base model leaves, cut in the ways in which effects show.
std::string where_tables(const Diagnosis& d) {
  if (d.gap_map.channels.empty()) return {};
  return "<h3>Around the circle, before</h3>" + circle_map(d) + "<h3>Pairs of runs, before</h3>" + contrast_table(d) +
         "<p class=quiet>rms in units of the noise; 1: nothing but noise. What differs with direction is odd in "
         "it.</p><h3>Groups of runs, before</h3>" +
         group_table(d) + "<h3>Steps where struts turn around, before</h3>" + reversal_bars(d) +
         "<p class=quiet>In the direction of growing strut speed; whiskers: two standard errors. Red: more than "
         "three.</p>";
}

// Evidence on poses and runs that were left out in turn.
std::string left_out_table(const Diagnosis& d) {
  std::string rows;
  for (const diagnose::Evidence& e : d.evidence) {
    if (!e.left_out) continue;
    rows += fmt::format("<tr><td>{}</td><td>{:.1f}</td><td>{:.1f}</td><td>{:.1f}</td></tr>", escaped(e.name),
                        e.log_odds, e.left_out->poses, e.left_out->runs);
  }
  if (rows.empty()) return {};
  return fmt::format("<p class=quiet>{}</p>", kNats) +
         "<table><tr><th>nats</th><th>all fitted runs</th><th>each pose predicted from the others</th><th>each "
         "run</th></tr>" +
         rows + "</table>";
}

std::string circles(const Diagnosis& d) {
  const std::string bars = circularity_bars(d);
  if (bars.empty()) return {};
  return "<h2>What it is good for</h2>" + bars +
         "<p class=quiet>Circularity of each circle, um, noise included: grey as measured; predicted if its program is "
         "compensated with the model as given (<span class=b>red</span>), and with what was found (<span "
         "class=a>blue</span>).</p>";
}

std::string parameter_rows(const NamedParameter& p) {
  std::string rows;
  for (std::size_t i = 0; i < p.values.size(); ++i) {
    const std::string name = p.single ? p.key : fmt::format("{} {}", p.key, i + 1);
    rows += fmt::format("<tr><td>{}</td><td>{:.4g}</td><td>{}</td></tr>", escaped(name), p.values[i],
                        p.errors[i] > 0 ? fmt::format("{:.2g}", p.errors[i]) : "not fitted");
  }
  return rows;
}

std::string effects(const Diagnosis& d) {
  std::string html;
  for (const NamedEffect& effect : d.effects) {
    html += fmt::format(
        "<h3>{}</h3><p>{:.0f} nats against the model without it; by chance the best of the catalogue "
        "passes {:.1f} in 0.3 % of machines.</p>",
        escaped(effect.name), effect.log_odds, d.threshold);
    if (!effect.alternatives.empty()) {
      html += fmt::format("<p>No data of this plan tell it from {}.</p>",
                          escaped(fmt::format("{}", fmt::join(effect.alternatives, ", "))));
    }
    html += "<table><tr><th>number</th><th>value</th><th>standard error</th></tr>";
    for (const NamedParameter& parameter : effect.parameters) html += parameter_rows(parameter);
    html += "</table>";
  }
  return html;
}

std::string next_tests(const Diagnosis& d) {
  std::string html;
  for (const diagnose::Separation& next : d.next) html += fmt::format("<p>{}</p>", escaped(next_test_text(next)));
  return html;
}

std::string could_show(const Diagnosis& d) {
  std::string never;
  std::string from;
  for (const diagnose::Visible& one : d.visible) {
    std::string& list = one.shows ? from : never;
    list += fmt::format("{}{}", list.empty() ? "" : ", ", escaped(one.name));
    if (one.shows) list += fmt::format(" {:.2g} {}", one.smallest, escaped(one.unit));
  }
  std::string html;
  if (!never.empty()) html += fmt::format("<p>These runs could not have shown, at any size: {}.</p>", never);
  if (!from.empty()) html += fmt::format("<p>They would have shown, from this size on: {}.</p>", from);
  return html;
}

}  // namespace

std::string diagnosis_page(const Diagnosis& d, const std::string& title) {
  std::string html = fmt::format(
      "<!doctype html><html lang=en><meta charset=utf-8><meta name=viewport content=\"width=device-width\">"
      "<title>{0}</title><style>{1}</style><h1>{0}</h1><p class=verdict>{2}</p>",
      escaped(title), kStyle, verdict_text(d));
  if (d.withheld)
    html += fmt::format("<p>The model stays as it was given: {}.</p>", escaped(objection_text(*d.withheld)));
  if (d.verdict == diagnose::Verdict::nothing_missing) html += could_show(d);
  if (d.confidence_set.size() > 1) {
    html += fmt::format("<p>Not ruled out: {}.</p>", escaped(fmt::format("{}", fmt::join(d.confidence_set, ", "))));
  }
  html += "<h2>The gap</h2>" + gap_table(d);
  html +=
      "<h2>Where</h2>" + gap_map(d) + "<p class=quiet>White: the noise. Full red: ten times the noise and more.</p>";
  html += polar_plots(d);
  html += where_tables(d);
  if (!d.evidence.empty()) {
    html += "<h2>Which</h2>" + evidence_bars(d) +
            "<p class=quiet>How much more likely the readings are with the effect, as a natural logarithm. Blue: not "
            "ruled out as "
            "the strongest.</p>" +
            left_out_table(d);
  }
  if (!d.effects.empty()) html += "<h2>What was found</h2>" + effects(d);
  if (d.doubt) html += fmt::format("<h2>What was not believed</h2><p>{}.</p>", escaped(doubt_text(*d.doubt)));
  if (d.remainder) {
    html += fmt::format(
        "<h2>What the catalogue does not explain</h2><p>A description, not a cause; {:.0f} times the noise in "
        "all.</p><pre>{}</pre>",
        d.remainder->snr, escaped(remainder_text(*d.remainder)));
  }
  html += circles(d);
  if (!d.next.empty()) html += "<h2>What next</h2>" + next_tests(d);
  return html + "</html>\n";
}

}  // namespace plumbline::report
