// What may speak against what was found, and what may be left of it: facts, which the report puts into words.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "diagnose/description/description.hpp"
#include "diagnose/gap/contrasts.hpp"
#include "diagnose/readings/channel_flaw.hpp"
#include "identify/posterior/expected_tip.hpp"
#include "identify/unknowns/unknowns.hpp"

namespace plumbline::diagnose {

enum class ReadingKind { radial, torque };

/// What is left of readings of one kind comes again in other runs at the same pose.
struct Recurring {
  double sigmas = 0;                      // of chi-square, above what noise does
  double correlation = 0;                 // where it shows most: between runs that
  Difference by = Difference::direction;  // differ in this alone
};

struct Recurs {
  std::optional<Recurring> radial, torque;
};

/// An unknown, and how many of its prior's sigmas a fit moved it.
struct StrainedUnknown {
  identify::Unknown unknown;
  double sigmas = 0;
};

/// What the catalogue does not explain: generic terms, nuisances that had to go further than [uncertainty] makes
/// believable, or what comes again.
struct Remainder {
  double snr = 0;
  std::variant<std::vector<Term>, std::vector<StrainedUnknown>, Recurs> what;
};

/// Rms of readings of one kind, m or N m, without what was found and with it.
struct Change {
  ReadingKind kind = ReadingKind::radial;
  double before = 0;
  double after = 0;
};

/// Something is wrong with the data themselves: of these runs, or alike of all.
struct SpoiledData {
  std::vector<std::string> runs;  // ids
  bool all = false;
};

/// A number of an effect stands as far off as it can be at all, and the gap stays open.
struct AtBound {
  std::string effect;
  identify::Unknown number;
};
/// Runs held out are further off.
struct FurtherOff : Change {};
/// A gap that is no noise is not closed.
struct OpenGap : Change {};
/// One more effect would pass the threshold.
struct OneMore {};
/// The catalogue leaves a gap beside the effects.
struct LargeRemainder {
  double noises = 0;  // how many times the noise it is in all
};
/// Runs held out are much further off than those fitted.
struct NotPredicted {
  ReadingKind kind = ReadingKind::radial;
  double times = 0;
};
/// All nuisances together are further off than [uncertainty] says.
struct StrainedTogether {
  double sigmas = 0;  // the sum of squares, in its standard deviations above its mean
};
/// Readings held out are nearer to the model as given.
struct GivenIsNearer {
  ReadingKind kind = ReadingKind::radial;
};

/// The tip would be moved further than any effect of a machine does.
struct MovedFar {
  double tip = 0;  // m, on the way of some run
};

/// Readings of the bar that are so many times too large in all runs explain more than effects that were found.
struct BarGain {
  double factor = 1;
  double nats = 0;  // by which they are likelier
};

/// What was found is an effect that much looks like which no catalogue has.
struct Suspected {
  std::string effect;
};

/// Why effects that were found are not to be named.
struct Doubt {
  std::vector<std::string> effects;  // none: no effect makes such readings
  std::variant<ChannelFlaw, SpoiledData, AtBound, FurtherOff, OpenGap, OneMore, LargeRemainder, NotPredicted, BarGain,
               Suspected>
      why;
};

/// Why nothing that was learnt is to be believed, be it named or not.
using Objection = std::variant<ChannelFlaw, SpoiledData, std::vector<StrainedUnknown>, StrainedTogether, MovedFar,
                               GivenIsNearer, OpenGap, identify::LessSure>;

}  // namespace plumbline::diagnose
