#include "report/measured/objection_text.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "base/units.hpp"
#include "physics/generic_formula.hpp"
#include "report/measured/inspection_text.hpp"

namespace plumbline::report {
namespace {

using diagnose::ReadingKind;
using identify::Objection;

constexpr std::size_t kMostNamed = 5;  // priors that are refuted; how many more there are is said

// How readings of one kind are called, and their unit.
struct KindWords {
  std::string_view of_runs;   // "the bar's readings"
  std::string_view readings;  // "the readings of the bar"
  std::string_view unit_name;
  double unit;
};

const KindWords& words_of(ReadingKind kind) {
  static constexpr KindWords kRadialWords{"the bar's readings", "the readings of the bar", "um", kUm};
  static constexpr KindWords kTorqueWords{"the torques", "the torques", "N m", 1};
  return kind == ReadingKind::radial ? kRadialWords : kTorqueWords;
}

std::string strains_text(const identify::Stage& stage) {
  const std::vector<identify::Strain>& strained = stage.plausible.strained;
  std::vector<std::string> each;
  for (std::size_t i = 0; i < std::min(strained.size(), kMostNamed); ++i) {
    each.push_back(strain_text(stage.fit.unknowns[strained[i].unknown], strained[i].sigmas, 1));
  }
  if (strained.size() > kMostNamed) each.push_back(fmt::format("and {} more", strained.size() - kMostNamed));
  return fmt::format("{}", fmt::join(each, "; "));
}

std::string worse_text(const identify::Predicted& predicted, ReadingKind kind) {
  const KindWords& words = words_of(kind);
  return fmt::format(
      "a fit to the other circles leaves {:.3g} {} of {} on those that it did not see, and the model as given {:.3g}",
      predicted.after / words.unit, words.unit_name, words.of_runs, predicted.before / words.unit);
}

// --- of a diagnosis: one `why` for each thing that may speak against it ---

std::string text_of(const diagnose::ChannelFlaw& flaw) {
  std::vector<std::string> names;
  for (const std::size_t motor : flaw.motors) names.push_back(fmt::format("torque{}_Nm", motor + 1));
  if (flaw.kind == diagnose::ChannelFlaw::Kind::sign) {
    return fmt::format(
        "{} of 6 torques ({}) {} the sign opposite to the model's in all runs: no effect does that; check the sign "
        "of each channel (positive where the strut is pulled)",
        names.size(), fmt::join(names, ", "), names.size() == 1 ? "has" : "have");
  }
  std::vector<std::string> factors;
  for (const double factor : flaw.factors) factors.push_back(fmt::format("{:.3g}", factor));
  return fmt::format(
      "{} of 6 torques ({}) {} {} times the model's: no effect does that; check the unit of each channel (N m at the "
      "screw, not per cent of the rated torque, not a current)",
      names.size(), fmt::join(names, ", "), names.size() == 1 ? "is" : "are", fmt::join(factors, ", "));
}

std::string text_of(const diagnose::SpoiledData& spoiled) {
  return fmt::format("something is wrong with the data of {}: mend it, or take it as it is with --accept",
                     spoiled.all
                         ? std::string("all runs")
                         : fmt::format("run{} {}", spoiled.runs.size() == 1 ? "" : "s", fmt::join(spoiled.runs, ", ")));
}

std::string text_of(const diagnose::OpenGap& gap) {
  const KindWords& words = words_of(gap.kind);
  return fmt::format("the gap of {} stays open, {:.3g} {} of {:.3g}, and is no noise{}", words.of_runs,
                     gap.after / words.unit, words.unit_name, gap.before / words.unit,
                     gap.kind == ReadingKind::torque ? ": check unit and sign of each torque" : "");
}

std::string text_of(const std::vector<diagnose::StrainedUnknown>& strained) {
  std::vector<std::string> lines;
  for (const diagnose::StrainedUnknown& one : strained) lines.push_back(strain_text(one.unknown, one.sigmas, 0));
  return fmt::format("{}", fmt::join(lines, "\n"));
}

std::string text_of(const diagnose::StrainedTogether& strained) {
  return fmt::format(
      "all that [uncertainty] lists would be further off together than it says, the sum of squares by {:.0f} of its "
      "standard deviations",
      strained.sigmas);
}

std::string text_of(const diagnose::MovedFar& moved) {
  return fmt::format(
      "it would move the tip by {:.3g} mm where it was measured, further than an effect of a machine does: check "
      "radius_mm and bar_mm of the runs, the unit of the readings, and whether the instrument smoothed them",
      moved.tip / kMm);
}

std::string text_of(const diagnose::GivenIsNearer& nearer) {
  return fmt::format("the model as given is nearer to {} held out", words_of(nearer.kind).of_runs);
}

std::string text_of(const identify::LessSure& sure) {
  return fmt::format(
      "by its own errors the tip would be {:.3g} um off where the model as given states {:.3g} um (rms over what was "
      "measured): these data do not hold what was fitted to them",
      sure.learnt / kUm, sure.given / kUm);
}

std::string text_of(const std::vector<diagnose::Term>& terms) {
  std::vector<std::string> lines;
  for (const diagnose::Term& term : terms)
    lines.push_back(physics::generic_formula(diagnose::generic_parameters(term)));
  return fmt::format("{}", fmt::join(lines, "\n"));
}

std::string text_of(const diagnose::Recurs& recurs) {
  std::vector<std::string> lines;
  const auto add = [&](ReadingKind kind, const std::optional<diagnose::Recurring>& of) {
    if (!of) return;
    lines.push_back(fmt::format(
        "what is left of {} is no noise: in runs at one pose that differ by {} alone it is {}, with a "
        "correlation of {:.2f}",
        words_of(kind).readings, to_text(of->by), of->correlation > 0 ? "alike" : "opposite", of->correlation));
  };
  add(ReadingKind::radial, recurs.radial);
  add(ReadingKind::torque, recurs.torque);
  return fmt::format("{}", fmt::join(lines, "\n"));
}

// Each reason beside the names of the effects found, "backlash and level".
struct DoubtWords {
  std::string names;
  bool several = false;

  std::string operator()(const diagnose::ChannelFlaw& flaw) const { return text_of(flaw); }
  std::string operator()(const diagnose::SpoiledData& spoiled) const { return text_of(spoiled); }

  std::string operator()(const diagnose::AtBound& at) const {
    const identify::Unknown& number = at.number;
    const bool reading_alone = physics::effect_infos()[physics::effect_index(at.effect)].reading_alone;
    return fmt::format("{} would stand at its bound of {:.4g} {}, as far as it can be at all: {}", at.effect,
                       number.upper / number.unit.si, number.unit.name,
                       reading_alone ? "check unit and sign of each torque"
                                     : "check units and signs of the channels, and what the dataset says of its runs");
  }

  std::string operator()(const diagnose::FurtherOff& change) const {
    const KindWords& words = words_of(change.kind);
    return fmt::format("with {} {} of the runs held out would be further off, {:.3g} {} for {:.3g}", names,
                       words.of_runs, change.after / words.unit, words.unit_name, change.before / words.unit);
  }

  std::string operator()(const diagnose::OpenGap& gap) const { return fmt::format("with {} {}", names, text_of(gap)); }

  std::string operator()(const diagnose::OneMore&) const {
    return fmt::format("{} {} not enough: one more effect would pass the threshold", names, several ? "are" : "is");
  }

  std::string operator()(const diagnose::LargeRemainder& remainder) const {
    return fmt::format("{} would leave too much: {:.0f} times the noise in all", names, remainder.noises);
  }

  std::string operator()(const diagnose::NotPredicted& of) const {
    return fmt::format("{} would explain the runs fitted, but {} of the runs held out are {:.1f} times as far off",
                       names, words_of(of.kind).readings, of.times);
  }

  std::string operator()(const diagnose::BarGain& bar) const {
    return fmt::format(
        "{} would explain the readings, but a bar that reads {:.3g} times what it should in all runs explains more: "
        "check its scale, and whether radii are diameters",
        names, bar.factor);
  }

  std::string operator()(const diagnose::Suspected& of) const {
    return fmt::format(
        "{} is a suspect only: other stiffnesses that change with the load, which no "
        "catalogue has, look much like it",
        several ? fmt::format("{} explain the readings, of which {}", names, of.effect)
                : fmt::format("{} explains the readings, and", names));
  }
};

}  // namespace

std::string strain_text(const identify::Unknown& unknown, double sigmas, int decimals) {
  return fmt::format("{} is {:.4g} {} off, {:.{}f} times what [uncertainty] says of it", unknown.label,
                     sigmas * unknown.sigma / unknown.unit.si, unknown.unit.name, std::abs(sigmas), decimals);
}

std::string all_strained_text(const identify::Plausibility& plausible) {
  return fmt::format(
      "all that [uncertainty] lists would be further off together than it says: chi-square is {:.0f} where {:.0f} is "
      "expected, as in less than one of a thousand machines",
      plausible.chi2, plausible.degrees);
}

std::string objection_text(const identify::Stage& stage) {
  if (!stage.objection) return {};
  switch (*stage.objection) {
    case Objection::strained:
      return strains_text(stage);
    case Objection::all_strained:
      return all_strained_text(stage.plausible);
    case Objection::radial_worse:
      return worse_text(stage.plausible.radial, ReadingKind::radial);
    case Objection::torque_worse:
      break;
  }
  return worse_text(stage.plausible.torque, ReadingKind::torque);
}

std::string objection_text(const jobs::IdentifiedModel& model) {
  std::vector<std::string> all;
  if (model.inspection.blocks()) all.push_back(spoiled_text(model));  // what was fitted to such data says little
  if (const identify::Stage* const stage = model.found.objected()) {
    all.push_back(objection_text(*stage));
  } else if (model.open_gap) {
    all.push_back(text_of(*model.open_gap));
  } else if (model.less_sure) {
    all.push_back(text_of(*model.less_sure));
  }
  return fmt::format("{}", fmt::join(all, "; and of the fit: "));
}

std::string spoiled_text(const jobs::IdentifiedModel& model) {
  std::vector<std::string> faults;
  for (const inspect::Fault& fault : model.inspection.faults) {
    if (fault.blocks) faults.push_back(fault_text(fault, model.runs));
  }
  return faults.empty() ? "" : fmt::format("something is wrong with the data: {}", fmt::join(faults, "; "));
}

std::string not_converged_text(const jobs::IdentifiedModel& model) {
  const std::string spoiled = spoiled_text(model);
  return (spoiled.empty() ? "" : spoiled + "; and ") + "the fit did not converge";
}

std::string objection_text(const diagnose::Objection& objection) {
  return std::visit([](const auto& why) { return text_of(why); }, objection);
}

std::string doubt_text(const diagnose::Doubt& doubt) {
  return std::visit(DoubtWords{fmt::format("{}", fmt::join(doubt.effects, " and ")), doubt.effects.size() > 1},
                    doubt.why);
}

std::string remainder_text(const diagnose::Remainder& remainder) {
  return std::visit([](const auto& what) { return text_of(what); }, remainder.what);
}

}  // namespace plumbline::report
