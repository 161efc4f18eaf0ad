// What speaks against a model that seems to explain the readings, however large the noise was taken to be.
#pragma once

#include "diagnose/diagnose.hpp"
#include "diagnose/readings/residuals.hpp"

namespace plumbline::diagnose {

/// How many times as far off the runs held out are as those fitted; nothing if that is little, or if single runs among
/// those fitted differ so much that chance may have done it.
std::optional<double> not_predicted(const std::vector<identify::RunEquations>& residuals, const std::vector<bool>& out,
                                    MeanSquare ResidualSums::*kind, const VerdictOptions& options);

/// Noise does not come again: what does is no noise, even where the estimate of the noise has taken it for such.
/// Nothing if chance may have done it, if it is as small as the last digit of a reading, or if no two runs go all the
/// way round at one pose.
Recurs recurring(const std::vector<Contrast>& contrasts, const VerdictOptions& options);
std::optional<Remainder> remainder_of(const Recurs& recurs);

/// A gap that is no noise and that stays open: of one kind of readings, after more than `share` of before, and
/// `recurs`.
std::optional<OpenGap> open_gap(const Recurs& recurs, const Gap& gap, double share, const VerdictOptions& options);

/// Chi-square of all nuisances together, less what it should be, in its standard deviations.
double strain_of_all(const CandidateSet& candidates, const Marginalised& marginalised);

/// Nuisances that had to go further than [uncertainty] makes believable. Those that an effect stands for are none any
/// more: they are not among the marginalised ones.
std::vector<StrainedUnknown> strained(const CandidateSet& candidates, const Marginalised& marginalised,
                                      const VerdictOptions& options);
std::optional<Remainder> remainder_of(std::vector<StrainedUnknown> strained);

/// Whether what is left is large enough to be more than noise.
bool is_gap(const Description& description, const VerdictOptions& options);

/// What doubts are about.
struct Doubted {
  const Model& model;
  const Description& description;                    // of what nothing explains beside the effects found
  const std::vector<identify::RunEquations>& after;  // what these leave of all runs
  const std::vector<bool>& out;                      // runs held out
  Gap fit, held_out;
  Recurs recurs;
};

/// Why the effects found are not to be named: a number of theirs stands at its bound, runs held out are further off
/// with them than without, a gap stays open, or they cannot be the whole story. Nothing: none was found, or they are
/// believed.
std::optional<Doubt> doubt_of(const CandidateSet& candidates, const Doubted& of, const VerdictOptions& options);

}  // namespace plumbline::diagnose
