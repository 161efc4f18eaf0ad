// Diagnosis: where a model and measurements of its machine disagree, which effect is missing, how sure that is, and
// what is left when it is added.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "diagnose/compensated.hpp"
#include "diagnose/description/description.hpp"
#include "diagnose/evidence/visible.hpp"
#include "diagnose/gap/gap_map.hpp"
#include "diagnose/held_out.hpp"
#include "diagnose/next_test.hpp"
#include "diagnose/objection.hpp"
#include "diagnose/residual_model/told.hpp"
#include "diagnose/search/search.hpp"
#include "identify/held.hpp"
#include "identify/posterior/posterior.hpp"

namespace plumbline::diagnose {

struct VerdictOptions {
  double within_nats = 6;  // an effect that is that much less likely than the best one is not ruled out
  double as_strong = 0.5;  // share of the strongest one's log odds (0.7 of its SNR) from which a second may be stronger
  double same_signature = 0.9999;    // |cos| from which no data of the plan tell two effects apart,
  double told_apart_nats = 20;       // unless what the other one leaves of the first is so much: little noise tells
  double remainder_gain = 60;        // misfit that a description must take away to count as a gap
  double remainder_share = 0.04;     // of what the effects explain; a remainder above that and
  double remainder_most = 150;       // above that makes the verdict unknown, or one surer than one of two effects
  double nuisance_sigmas = 6;        // a nuisance further off than that is no nuisance
  double held_out_times = 1.35;      // as far off as the runs fitted may those held out be, and that
  double held_out_sigmas = 3;        // many standard deviations of single runs
  double recurrence_sigmas = 5;      // of chi-square, from which what is left in runs at one pose is no noise
  double held_out_rise = 1.03;       // times as far off as without an effect may runs held out be with it
  double rise_share = 0.1;           // unless it is less, squared, than that of what runs fitted come nearer
  double at_bound = 0.999;           // of its bound, from which a number stands at it
  double bound_sigmas = 3;           // if it is that many of its standard errors, or all numbers of the effect do
  double open_share = 0.5;           // of what was left before; with more, what comes again is a gap that stays open,
  double open_correlation = 0.5;     // if it is more than half of what is left
  double nuisances_together = 5;     // standard deviations of chi-square
  double farthest_tip = 0.5e-3;      // m, by which what no catalogue has moves the tip
  double least_recurring_um = 0.02;  // rms; less than that is rounding
  double least_recurring_Nm = 1e-3;
};

struct DiagnoseOptions {
  CandidateSetOptions candidates;
  HeldOutOptions held_out;
  SearchOptions search;
  DescriptionOptions description;
  ResidualOptions residual;
  VerdictOptions verdict;
  NextTestOptions next_test;
  GapMapOptions gap_map;
  ChannelOptions channels;
  CompensatedOptions compensated;
  identify::HoldOptions hold;
  std::optional<SpoiledData> spoiled;  // nothing is learnt from such data
};

enum class Verdict { named, nothing_missing, unknown };
std::string_view to_text(Verdict verdict);

/// The numbers of one key of an effect, in the file's unit.
struct NamedParameter {
  std::string key, unit;
  std::vector<double> values, errors;
  std::size_t each = 1;  // numbers that belong together: 3 for points
  bool single = false;   // one number, no list
};

/// An effect that was found.
struct NamedEffect {
  std::string name;
  std::vector<std::string> alternatives;  // that no data of this plan tell from it
  std::vector<NamedParameter> parameters;
  double log_odds = 0;  // nats, against the model without it
  std::optional<LeftOut> left_out;
};

/// An effect of the catalogue and how likely it is as the strongest.
struct Evidence {
  std::string name;
  double log_odds = 0;
  std::optional<LeftOut> left_out;  // of those fitted nonlinearly
};

/// Circularity of a run, m: as measured, and predicted if its program were compensated with the model as given, or
/// with what was found.
struct Circularity {
  double measured = 0;
  double given = 0;
  double found = 0;
};

/// What is left of one channel: rms over all samples, SI.
struct ChannelGap {
  int channel = 0;
  double before = 0;     // base model, nuisances refitted
  double runner_up = 0;  // with the second-best effect in place of the strongest
  double after = 0;
};
struct RunGap {
  std::string id;
  bool held_out = false;
  std::vector<ChannelGap> channels;
  Eigen::VectorXd angle;          // rad
  Eigen::VectorXd radial_before;  // residuals, m
  Eigen::VectorXd radial_after;
  std::optional<Circularity> circularity;  // nothing: no readings of the bar
};
struct Rms {
  std::optional<double> radial, torque;  // m, N m
};
struct Gap {
  Rms before, runner_up, after;
};

/// The test that would separate the strongest effect from another one that is not ruled out.
struct Separation {
  std::string from;
  std::optional<NextTest> test;  // nothing: no circular test does
};

struct Diagnosis {
  Verdict verdict = Verdict::nothing_missing;
  std::vector<NamedEffect> effects;  // the strongest first
  std::vector<std::string> confidence_set;
  std::vector<Evidence> evidence;  // all effects of the catalogue in the place of the strongest, best first
  std::string runner_up;           // empty: none
  double threshold = 0;            // nats
  std::optional<Doubt> doubt;      // unknown: why effects that were found are not believed; nothing: none was found
  std::optional<Remainder> remainder;
  std::vector<LearntFunction> functions;  // unknown: what the model has all the same, in place of the remainder's terms
  std::vector<Separation> next;           // for each other effect of the confidence set
  identify::NoiseModel noise;
  GapMap gap_map;  // with the base model, nuisances refitted, all runs
  std::vector<RunGap> runs;
  Gap fit, held_out;
  std::vector<Visible> visible;       // what the fitted runs could have shown
  std::optional<Objection> withheld;  // why the model stays as given; nothing: the model is what was learnt
  physics::ForceModel forces;         // with what was found and the nuisances refitted, or as given
  std::vector<double> errors;         // of its parameters, SI
  identify::Posterior posterior;      // of its numbers
  bool converged = true;
  std::vector<std::string> steps;  // what was done, in words

  explicit Diagnosis(physics::ForceModel found) : forces(std::move(found)), posterior(identify::Unknowns(forces)) {}
};

/// Diagnoses a dataset. Refuses with simulate-unreachable, diagnose-unknown-effect, and with diagnose-nothing-measured
/// if no run has a reading. `say` gets each step in words, and what is begun.
Diagnosis diagnose(const machine::MachineModel& machine, const std::vector<measure::Run>& runs,
                   const DiagnoseOptions& options = {}, const Say& say = {});

}  // namespace plumbline::diagnose
