#include "report/measured/observability_text.hpp"

#include <iterator>
#include <map>
#include <string_view>

#include <fmt/format.h>

#include "base/units.hpp"
#include "report/measured/objection_text.hpp"

namespace plumbline::report {
namespace {

using identify::Confusion;
using identify::MeasuredAt;
using identify::Unknown;
using identify::Unknowns;

std::string_view circles_text(MeasuredAt at) {
  switch (at) {
    case MeasuredAt::poses:
      return "these poses";
    case MeasuredAt::circles_at_one_height:
      return "circles at one height";
    case MeasuredAt::circles:
      break;
  }
  return "these circles";
}

std::string confusion_text(const Confusion& c, const Unknowns& unknowns, std::string_view circles) {
  const Unknown& a = unknowns[c.first];
  const Unknown& b = unknowns[c.second];
  // K1 and K2 are lengths apart; others in the units of the file
  const bool compliances = a.label == "K1" && b.label == "K2";
  const double weight = compliances ? c.weight : c.weight * a.unit.si / b.unit.si;
  return fmt::format(
      "{} cannot separate {} from {} (correlation {:.3f}): what they determine is "
      "{:.4g}{} x {} + {} = {:.6g} +- {:.2g} {}",
      circles, a.label, b.label, c.correlation, weight, compliances ? " m" : "", a.label, b.label, c.value / b.unit.si,
      c.standard_error / b.unit.si, b.unit.name);
}

// Numbers of the geometry by how many there are: "strut-offset (6 of 6), joint-position (30 of 36), level tilt_mrad x".
std::string unknowns_text(const std::vector<std::size_t>& which, const Unknowns& unknowns) {
  std::map<std::string, std::size_t> geometry;
  std::vector<std::string> names;
  for (const std::size_t i : which) {
    if (identify::is_geometry(unknowns[i])) {
      ++geometry[unknowns[i].effect];
    } else {
      names.push_back(unknowns[i].label);
    }
  }
  for (const auto& [effect, count] : geometry) {
    names.push_back(fmt::format("{} ({} of {})", effect, count, unknowns.of_effect(effect).size()));
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

std::string held_text(const identify::Held& held) {
  return fmt::format(
      "circles do not show where the tip stands as a whole: {:.0f} % of its shift is left out ({:.1f} um), since "
      "the model as given may be nearer there; differences between places are as found, and touching off the zero on "
      "the machine removes the shift in any case",
      100 * held.share, held.back / kUm);
}

}  // namespace

std::vector<std::string> observability_text(const identify::Fit& fit, const identify::Observability& known) {
  std::vector<std::string> sentences;
  if (!known.nothing.empty())
    sentences.push_back("these data say nothing about " + unknowns_text(known.nothing, fit.unknowns));
  for (const Confusion& c : known.confusions)
    sentences.push_back(confusion_text(c, fit.unknowns, circles_text(known.measured_at)));
  if (!known.little.empty()) {
    sentences.push_back("these data add little to what [uncertainty] says of " +
                        unknowns_text(known.little, fit.unknowns));
  }
  return sentences;
}

std::string motion_text(const identify::WholeMotion& motion) {
  using Kind = identify::WholeMotion::Kind;
  const std::string_view ring = motion.ring == identify::WholeMotion::Ring::base ? "base" : "platform";
  const char axis = "XYZ"[motion.axis];
  switch (motion.kind) {
    case Kind::shift:
      return fmt::format("a shift of the {} joints along {}", ring, axis);
    case Kind::turn:
      return fmt::format("a turn of the {} joints about {}", ring, axis);
    case Kind::wider_ring:
      return fmt::format("a wider ring of {} joints", ring);
    case Kind::longer_struts:
      break;
  }
  return "all struts longer together";
}

std::vector<std::string> shown_geometry_text(const identify::ShownGeometry& shown) {
  std::vector<std::string> sentences{
      fmt::format("these data determine {} of {} directions of the geometry to better than half of what was known",
                  shown.better, shown.directions)};
  std::vector<std::string> hidden;
  for (const identify::WholeMotion& motion : shown.hidden) hidden.push_back(motion_text(motion));
  if (!hidden.empty()) {
    sentences.push_back(
        fmt::format("these data do not show {}: only what was known beforehand holds them where they are",
                    fmt::join(hidden, ", ")));
  }
  return sentences;
}

std::vector<std::string> observability_text(const identify::Stage& stage) {
  std::vector<std::string> sentences = observability_text(stage.fit, stage.observability);
  if (stage.held && stage.held->share > 0) sentences.push_back(held_text(*stage.held));
  if (stage.borne_out && !stage.objection && stage.plausible.all_strained) {
    sentences.push_back(
        all_strained_text(stage.plausible) +
        ". Something is missing in the model: run plumbline diagnose. Still, circles that a fit to the others did not "
        "see are predicted better than before: use these numbers rather than those given, but they are not the "
        "machine's own");
  }
  if (stage.geometry) {
    std::vector<std::string> geometry = shown_geometry_text(*stage.geometry);
    sentences.insert(sentences.end(), std::make_move_iterator(geometry.begin()),
                     std::make_move_iterator(geometry.end()));
  }
  return sentences;
}

}  // namespace plumbline::report
