// What speaks against a model that seems to explain the readings, however large the noise was taken to be.
#pragma once

#include "diagnose/diagnose.hpp"
#include "diagnose/readings/residuals.hpp"

namespace plumbline::diagnose {

/// How many times as far off the runs held out are as those fitted; nothing if that is little, or if single runs among
/// those fitted differ so much that chance may have done it.
std::optional<double> not_predicted(const std::vector<identify::RunEquations>& residuals, const std::vector<bool>& out,
                                    MeanSquare ResidualSums::*kind, const VerdictOptions& options);

/// What is left of readings of one kind comes again in other runs at the same pose.
struct Recurring {
  double sigmas = 0;                      // of chi-square, above what noise does
  double correlation = 0;                 // where it shows most: between runs that
  Difference by = Difference::direction;  // differ in this alone
};

struct Recurs {
  std::optional<Recurring> radial, torque;
};

/// Noise does not come again: what does is no noise, even where the estimate of the noise has taken it for such.
/// Nothing if chance may have done it, if it is as small as the last digit of a reading, or if no two runs go all the
/// way round at one pose.
Recurs recurring(const std::vector<Contrast>& contrasts, const VerdictOptions& options);
std::optional<Remainder> remainder_of(const Recurs& recurs);

/// A gap that is no noise and that stays open: of one kind of readings, after more than `share` of before, and
/// `recurs`.
std::optional<std::string> open_gap(const Recurs& recurs, const Gap& gap, double share, const VerdictOptions& options);

/// Chi-square of all nuisances together, less what it should be, in its standard deviations.
double strain_of_all(const CandidateSet& candidates, const Marginalised& marginalised);

/// Nuisances that had to go further than [uncertainty] makes believable, a line each. Those that an effect stands for
/// are none any more: they are not `taken`.
std::optional<Remainder> strained(const CandidateSet& candidates, const Marginalised& marginalised,
                                  const VerdictOptions& options);

/// Whether what is left is large enough to be more than noise.
bool is_gap(const Description& description, const VerdictOptions& options);

/// Why effects that were found are not to be named: a number of theirs stands at its bound; empty: none does.
std::string bound_doubt(const CandidateSet& candidates, const Model& model, const VerdictOptions& options);

/// The same: runs held out are further off with them than without, or a gap stays open.
std::string gap_doubt(const Model& model, const Gap& fit, const Gap& held_out, const Recurs& recurs,
                      const VerdictOptions& options);

/// Why the effects found, which leave `after` of all runs, cannot be the whole story; empty if they can. `out`: runs
/// held out.
std::string doubt_about(const Model& model, const Description& description,
                        const std::vector<identify::RunEquations>& after, const std::vector<bool>& out,
                        const VerdictOptions& options);

}  // namespace plumbline::diagnose
