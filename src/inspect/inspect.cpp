#include "inspect/inspect.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/diagnostic.hpp"
#include "base/parallel.hpp"
#include "diagnose/readings/noise_spectrum.hpp"
#include "inspect/explanation.hpp"
#include "inspect/fine_noise.hpp"
#include "inspect/hypothesis.hpp"
#include "inspect/loaded_runs.hpp"
#include "inspect/looked.hpp"
#include "inspect/small_faults.hpp"
#include "inspect/some_runs.hpp"
#include "inspect/statistics.hpp"

namespace plumbline::inspect {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using identify::kChannels;
using identify::kRadial;
using measure::Run;

// How many times its noise from sample to sample a kind of channels is off: what it leaves is no noise.
double coarseness(const std::vector<identify::RunEquations>& remainders, bool bar) {
  std::vector<double> each;
  for (const identify::RunEquations& run : remainders) {
    for (std::size_t c = 0; c < run.channels.size(); ++c) {
      if ((run.channels[c] == kRadial) != bar) continue;
      const VectorXd e = run.residual.segment(static_cast<Index>(c) * run.samples, run.samples);
      const double steps = (e.tail(e.size() - 1) - e.head(e.size() - 1)).squaredNorm() / 2;
      each.push_back(std::sqrt(e.squaredNorm() / std::max(steps, 1e-300)));
    }
  }
  return each.empty() ? 1 : median(each);
}

std::vector<Tried> everything_tried(const Suspects& suspects) {
  std::vector<Tried> all = tried_channels(suspects);
  const std::vector<Relabelled> list = relabellings(suspects);
  std::vector<std::optional<Tried>> each(list.size());
  for_each_index(list.size(), [&](std::size_t i) { each[i] = tried(suspects, list[i]); });
  for (std::optional<Tried>& one : each) {
    if (one) all.push_back(std::move(*one));
  }
  return all;
}

std::optional<Fault> fault_of_run(const Looked& looked, const Bench& bench, const Outliers& outliers, std::size_t i,
                                  const InspectOptions& options) {
  const Knowledge known = knowledge_of_others(outliers, looked.rows, i);
  const Suspects suspects{bench, looked.runs, looked.whole, {i}, {&looked.rows[i]}, known};
  const Index rows = looked.rows[i].rows();
  const double before = outliers.mean_square[i] * static_cast<double>(rows);
  return explanation(everything_tried(suspects), looked.runs[i], before, rows, std::max(1.0, outliers.usual), options);
}

// What is left of a run, about what the others predict.
VectorXd off_prediction(const Looked& looked, const Outliers& outliers, std::size_t i) {
  const RunRows& rows = looked.rows[i];
  return rows.left - rows.slopes * knowledge_of_others(outliers, looked.rows, i).mean();
}

// The same of each channel, in units of the noise.
RunMisfit misfit_of(const Looked& looked, const Outliers& outliers, std::size_t i, const VectorXd& off) {
  const RunRows& rows = looked.rows[i];
  RunMisfit misfit{std::sqrt(outliers.mean_square[i]), std::vector<double>(kChannels, 0)};
  for (std::size_t c = 0; c < rows.raw.channels.size(); ++c) {
    const double square = off.segment(static_cast<Index>(c) * rows.raw.samples, rows.raw.samples).squaredNorm();
    misfit.channels[static_cast<std::size_t>(rows.raw.channels[c])] =
        std::sqrt(square / static_cast<double>(rows.raw.samples));
  }
  return misfit;
}

// Neighbouring samples of what is left of a channel have nothing in common, or go against each other, as noise does
// after others that remember.
bool is_white(const VectorXd& e) { return e.head(e.size() - 1).dot(e.tail(e.size() - 1)) < 0.25 * e.squaredNorm(); }

// A few samples are far off, and the others are not.
bool is_of_few(const VectorXd& e) {
  constexpr double kOfNormal = 1.4826;  // standard deviations a median of sizes
  const VectorXd sizes = e.cwiseAbs();
  const double of_most = kOfNormal * median(std::vector<double>(sizes.begin(), sizes.end()));
  return of_most < 0.7 * std::sqrt(e.squaredNorm() / static_cast<double>(e.size()));
}

// A run that nothing explains: noisy, or standing out far beyond the next one.
std::optional<Fault> unexplained(const Looked& looked, const Outliers& outliers, std::size_t i,
                                 const std::vector<bool>& explained, const InspectOptions& options) {
  const double usual = std::max(1.0, outliers.usual);
  const double square = outliers.mean_square[i];
  double next = usual;
  for (std::size_t k = 0; k < looked.rows.size(); ++k) {
    if (k != i && !explained[k]) next = std::max(next, outliers.mean_square[k]);
  }
  const VectorXd off = off_prediction(looked, outliers, i);
  const RunMisfit misfit = misfit_of(looked, outliers, i, off);
  const auto worst = std::max_element(misfit.channels.begin(), misfit.channels.end());
  Fault fault{FaultKind::stands_out, {looked.numbers[i]}};
  fault.channels = {static_cast<int>(worst - misfit.channels.begin())};
  fault.before = fault.after = std::sqrt(square);
  const identify::RunEquations& raw = looked.rows[i].raw;
  const VectorXd of_worst = off.segment(*raw.first_row(fault.channels[0]), raw.samples);
  if (*worst > 2 && is_white(of_worst)) {
    if (is_of_few(of_worst))
      return square < next ? std::nullopt : std::optional(fault);  // edges of steps may be the machine
    fault.kind = FaultKind::noisy;
    fault.values = {*worst};
    return fault;
  }
  if (square < options.stands_out * usual || square < options.beyond_next * next) return std::nullopt;
  return fault;
}

// Of all runs, or of some of them: the one, if any, that takes more.
std::optional<Fault> likelier(std::optional<Fault> of_all, std::optional<Fault> of_some) {
  if (!of_all || !of_some) return of_all ? of_all : of_some;
  return of_all->nats >= of_some->nats ? of_all : of_some;
}

// What one line, copied to all runs, may say a little wrongly.
bool is_alike(FaultKind kind) {
  return kind == FaultKind::radius || kind == FaultKind::bar_length || kind == FaultKind::angle_zero;
}

constexpr double kNoEffects = 1e-6;  // of the bounds of effects that are taken to be absent

class Inspector {
 public:
  Inspector(const machine::MachineModel& machine, const InspectOptions& options)
      : machine_(machine),
        options_(options),
        forces_(machine),
        candidates_(diagnose::make_candidate_set(machine, forces_)),
        wide_(prior_of(candidates_, options.outliers.share_of_bounds)),
        bench_{machine_, forces_, candidates_, wide_, usual_noise(options)} {}

  Inspection inspect(const std::vector<Run>& runs) {
    Inspection found;
    found.faults = record_faults(runs, options_.records);
    found.runs.resize(runs.size());
    Looked looked = looked_at(runs, bench_, options_, found.faults);
    if (looked.runs.empty()) return found;
    Outliers outliers;
    std::vector<identify::RunEquations> left;
    look(looked, outliers, left);
    const bool of_all = coarseness(left, true) > options_.coarse || coarseness(left, false) > options_.coarse;
    const FineNoise fine = noise_from_sample_to_sample(kept(left, outliers), bench_.noise);
    if (std::optional<Fault> fault = likelier(
            fault_of_all(looked, outliers, of_all, fine),
            fault_of_some(looked, bench_, noise_from_sample_to_sample(left, bench_.noise), of_all, options_))) {
      found.faults.push_back(std::move(*fault));
      return found;  // before that is mended no run can be told from the others
    }
    if (take_lines(looked, left, found)) look(looked, outliers, left);
    bench_.noise = at_least(diagnose::noise_of(kept(left, outliers)), options_);
    add_noise_faults(found, looked);
    make_rows(looked, bench_);
    outliers = find_outliers(wide_, looked.rows, options_.outliers);
    judge_runs(looked, outliers, found);
    return found;
  }

 private:
  // With the noise that is assumed by now.
  void look(Looked& looked, Outliers& outliers, std::vector<identify::RunEquations>& left) const {
    make_rows(looked, bench_);
    outliers = find_outliers(wide_, looked.rows, options_.outliers);
    left = remainders(looked, outliers, bench_.noise);
  }

  // What is wrong with one run alone would hide what all have in common. All are kept by reference.
  Suspects agreeing(const Looked& looked, const Outliers& outliers, const Knowledge& known) const {
    Suspects suspects{bench_, looked.runs, looked.whole, {}, {}, known};
    for (std::size_t i = 0; i < looked.runs.size(); ++i) {
      if (outliers.out[i]) continue;
      suspects.runs.push_back(i);
      suspects.rows.push_back(&looked.rows[i]);
    }
    return suspects;
  }

  // Of runs that agree, against the model alone and its priors. `labels`: whether labels are doubted, too; that takes
  // long.
  std::optional<Fault> fault_of_all(const Looked& looked, const Outliers& outliers, bool labels,
                                    const FineNoise& noise_found) {
    const Knowledge nothing(wide_);
    const Suspects suspects = agreeing(looked, outliers, nothing);
    std::optional<Fault> fault = finer_than_any_bar(suspects);
    if (!fault) fault = has_no_signs(suspects);
    std::vector<Tried> of_alike;
    if (!fault) {
      std::vector<Tried> all = labels ? everything_tried(suspects) : tried_channels(suspects);
      of_alike = tried_alike(suspects);
      all.insert(all.end(), of_alike.begin(), of_alike.end());
      fault = likeliest_of_all(looked, suspects, std::move(all), noise_found);
    }
    if (!fault) {
      // wide as its effects are, the catalogue describes machines whose bar reads a 25th of what gravity does, and such
      // as stand centimetres off
      const Knowledge bare(prior_of(candidates_, kNoEffects));
      const Suspects of_bare = agreeing(looked, outliers, bare);
      fault = fits_in_larger_unit(of_bare);
      if (!fault && gains(suspects, of_alike)) {
        fault = likeliest_of_all(looked, of_bare, tried_alike(of_bare), noise_found);
      }
    }
    if (!fault) return std::nullopt;
    if (is_alike(fault->kind)) {
      for (const Tried& one : tried_alike(suspects, true)) {
        if (one.fault.kind == fault->kind) fault->values = one.fault.values;
      }
    }
    fault->all = true;
    // what is said of the place is of the first of them that was looked at
    fault->runs = looked.numbers;
    if (is_setting(fault->kind)) std::swap(fault->runs.front(), fault->runs[suspects.runs.front()]);
    return fault;
  }

  // Whether one of them makes the readings more likely though the effects of the catalogue are there to explain them.
  bool gains(const Suspects& suspects, const std::vector<Tried>& all) const {
    const double before = chi2_as_stated(suspects);
    return std::any_of(all.begin(), all.end(),
                       [&](const Tried& one) { return (before - one.chi2) / 2 - one.penalty >= options_.least_nats; });
  }

  std::optional<Fault> likeliest_of_all(const Looked& looked, const Suspects& suspects, std::vector<Tried> all,
                                        const FineNoise& noise_found) {
    leave_large_ones(all, looked.runs[0], options_);
    if (all.empty()) return std::nullopt;
    const Tried& best = *std::min_element(all.begin(), all.end(), [](const Tried& a, const Tried& b) {
      return a.chi2 + 2 * a.penalty < b.chi2 + 2 * b.penalty;
    });
    Index rows = 0;
    for (const RunRows* run : suspects.rows) rows += run->rows();
    const double before = chi2_as_stated(suspects);
    const double noise = std::max(1.0, best.chi2 / static_cast<double>(rows));
    Fault fault = best.fault;
    fault.nats = (before - best.chi2) / (2 * noise) - best.penalty;
    fault.before = std::sqrt(before / static_cast<double>(rows));
    fault.after = std::sqrt(best.chi2 / static_cast<double>(rows));
    const double fine = noise_found.with_memory();
    const bool alike = is_alike(best.fault.kind);
    const double least = alike ? std::min(fine, best.chi2) : fine;  // what is not to be had by a number alone
    const double left = std::max(0.0, best.chi2 - least);
    const double excess = before - least;
    // as with one run: it takes away most of what is off, and leaves little more than noise
    const double expected = noise_found.expected(best.fault);
    if (before - best.chi2 < options_.explained * (before - noise_found.expected({}))) return std::nullopt;
    if (best.chi2 > options_.near * expected) return std::nullopt;
    // what may be off by a little must explain most of what is off; a sign cannot be a little wrong
    const bool by_degrees = best.fault.kind == FaultKind::clock || alike;
    if (by_degrees && left > options_.all_explained * excess) return std::nullopt;
    // and has no number that could be fitted to what the model lacks. But where much stays open with it, an effect that
    // no catalogue has may prefer the other sign of a bar, which reads little
    const bool bar_is_open = best.fault.kind == FaultKind::bar_sign && fault.after > options_.all_open;
    const bool sign = best.fault.kind == FaultKind::motor_sign || best.fault.kind == FaultKind::bar_sign;
    if (fault.nats < (sign && !bar_is_open ? 2 * options_.least_nats : options_.all_nats)) return std::nullopt;
    return fault;
  }

  // What is periodic in time is told, and taken out of what is looked at. Whether there is any.
  bool take_lines(Looked& looked, const std::vector<identify::RunEquations>& left, Inspection& found) const {
    std::vector<Line> lines = find_lines(looked.runs, left, diagnose::noise_of(left), options_.lines);
    if (lines.empty()) return false;
    for (Fault& fault : periodic_faults(looked, lines, options_.lines)) found.faults.push_back(std::move(fault));
    looked.runs = without_lines(std::move(looked.runs), lines);
    looked.whole = without_lines(std::move(looked.whole), lines);
    for (Line& line : lines) {
      for (std::size_t& r : line.runs) r = looked.numbers[r];
    }
    found.lines = std::move(lines);
    return true;
  }

  void add_noise_faults(Inspection& found, const Looked& looked) const {
    const auto add = [&](int channel, const std::optional<double>& stated) {
      const identify::ChannelNoise& noise = bench_.noise.channels[static_cast<std::size_t>(channel)];
      if (!stated || noise.samples == 0 || noise.sigma < options_.larger * *stated) return;
      Fault fault{FaultKind::noise, looked.numbers, true, {channel}, {noise.sigma, *stated}};
      fault.blocks = false;
      found.faults.push_back(std::move(fault));
    };
    add(kRadial, options_.instrument.bar_sigma);
    add(kRadial + 1, options_.instrument.torque_sigma);
  }

  // The bar drifts by as much in all runs, about what they say together; or by itself in most, about what the others
  // say of each. Its size, m.
  std::optional<double> drift_of_all(const Looked& looked, const Outliers& outliers) const {
    const Knowledge nothing(wide_);
    if (const Suspects agree = agreeing(looked, outliers, nothing); agree.runs.size() >= 2) {
      const std::optional<Drift> common = drift_of(agree);
      if (common && common->gain > 2 * options_.least_nats) return common->size;
    }
    std::vector<std::optional<Drift>> each(looked.rows.size());
    for_each_index(each.size(), [&](std::size_t i) {
      const Knowledge known = knowledge_of_others(outliers, looked.rows, i);
      each[i] = drift_of({bench_, looked.runs, looked.whole, {i}, {&looked.rows[i]}, known});
    });
    std::vector<double> sizes;
    double sum = 0;
    int with = 0;
    for (const std::optional<Drift>& drift : each) {
      if (!drift) continue;
      sum += drift->gain - 1;
      if (drift->gain > options_.least_nats / 4) ++with;
      sizes.push_back(std::abs(drift->size));
    }
    const auto count = static_cast<double>(sizes.size());
    if (sizes.size() < 2 || sum < options_.drift_sigmas * std::sqrt(2 * count) ||
        with < options_.lines.in_runs * count) {
      return std::nullopt;
    }
    return median(sizes);
  }

  void judge_runs(const Looked& looked, const Outliers& outliers, Inspection& found) {
    found.usual = std::sqrt(outliers.usual);
    const std::optional<double> drifts = drift_of_all(looked, outliers);
    if (drifts) found.faults.push_back({FaultKind::drift, looked.numbers, true, {kRadial}, {*drifts}});
    std::vector<std::optional<Fault>> faults(looked.runs.size());
    std::vector<bool> explained(looked.runs.size(), false);
    for_each_index(looked.runs.size(), [&](std::size_t i) {
      found.runs[looked.numbers[i]] = misfit_of(looked, outliers, i, off_prediction(looked, outliers, i));
    });
    for (std::size_t i = 0; i < looked.runs.size(); ++i) {
      if (excess_of(outliers, i, options_.outliers) < 1) continue;
      faults[i] = fault_of_run(looked, bench_, outliers, i, options_);
      explained[i] = faults[i].has_value();
    }
    for (Fault& fault : found.faults) {
      if (fault.kind != FaultKind::same_readings) continue;
      if (found.runs[fault.runs[1]].all <= found.runs[fault.runs[0]].all) continue;
      std::swap(fault.runs[0], fault.runs[1]);
      fault.like = fault.runs[1];
    }
    for (std::size_t i = 0; i < looked.runs.size(); ++i) {
      const bool looked_closer = excess_of(outliers, i, options_.outliers) >= 1;
      if (looked_closer && !faults[i]) faults[i] = unexplained(looked, outliers, i, explained, options_);
      if (!faults[i] || (drifts && faults[i]->kind == FaultKind::drift)) continue;
      if (explained[i]) {
        faults[i]->runs = {looked.numbers[i]};
        faults[i]->like = looked.numbers[faults[i]->like];
      }
      found.faults.push_back(std::move(*faults[i]));
    }
    if (std::optional<Fault> fault = payload_of_loaded_runs(looked, bench_, wide_, outliers, options_)) {
      found.faults.push_back(std::move(*fault));
    }
    doubt_small_faults(found, options_);
  }

  const machine::MachineModel& machine_;
  InspectOptions options_;
  physics::ForceModel forces_;
  diagnose::CandidateSet candidates_;
  Prior wide_;
  Bench bench_;
};

}  // namespace

Inspection inspect(const machine::MachineModel& machine, const std::vector<Run>& runs, const InspectOptions& options) {
  return Inspector(machine, options).inspect(runs);
}

std::vector<Run> cleaned(std::vector<Run> runs, const Inspection& inspection, const InspectOptions& options) {
  for (Run& run : runs) {
    const auto spikes = spikes_in(run, options.records);
    run = measure::without_samples(std::move(run), spikes);
  }
  std::vector<Line> lines = inspection.lines;
  for (Line& line : lines) {  // what is folded within every so many samples is folded otherwise within all of them
    line.runs.erase(std::remove_if(line.runs.begin(), line.runs.end(),
                                   [&](std::size_t r) { return runs[r].samples() > options.most_samples; }),
                    line.runs.end());
  }
  return without_lines(std::move(runs), lines);
}

}  // namespace plumbline::inspect
