// What is expected to be left at the tip along a path, on a machine that is not as its model says.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/diagnostic.hpp"
#include "compensate/read_back/figures.hpp"
#include "compensate/recorded/drawn_path.hpp"
#include "compensate/recorded/path_samples.hpp"
#include "jobs/expected/tip_doubts.hpp"

namespace plumbline::jobs {

/// What is known of how sure a model's numbers are.
struct Knowledge {
  std::optional<identify::Posterior> posterior;  // nothing: the model does not say
  std::optional<Diagnostic> warning;             // why the posterior that the model names is not used

  const identify::Posterior* posterior_or_null() const { return posterior ? &*posterior : nullptr; }
};

/// The posterior that the model names, or else its [uncertainty]. One that cannot be read, or belongs to other numbers,
/// is not used, and no other in its place: `warning` has the refusal.
Knowledge knowledge_of(const machine::MachineModel& model);

/// Of many poses, m; means are over time, or over the poses where nothing has a time.
struct ExpectedFigures {
  double mean = 0;                    // of what is expected
  double within = 0;                  // mean of what 95 % are within
  double largest_within = 0;          // and the largest of these
  std::size_t line = 0;               // where that is
  std::array<double, kCauses> rms{};  // by what makes it
  std::string file = {};              // of the line, as compensate::SourceLine has it
};

struct ExpectedError {
  std::string made_by;      // what it is known from
  bool from_data = false;   // else from [uncertainty] alone
  std::uint64_t poses = 0;  // that were looked at
  ExpectedFigures stands;
  std::optional<ExpectedFigures> touched_off;
  AxisWords zero;  // where: mm and deg, in W
};

/// Adds up doubts that come one after the other.
class ExpectedTally {
 public:
  /// `weight`: how long the machine is near there.
  void add(const PoseDoubt& doubt, const compensate::SourceLine& at, double weight);
  bool any() const { return poses_ > 0; }
  ExpectedError take(const identify::Posterior& posterior, const AxisWords& zero);

 private:
  struct Sums {
    ExpectedFigures figures;
    void add(const TipDoubt& doubt, const compensate::SourceLine& at, double weight);
    void end(double weights);
  };
  Sums stands_, touched_off_;
  bool has_zero_ = false;
  double weights_ = 0;
  std::uint64_t poses_ = 0;
};

/// At each of these points of a program, its zero touched off there, on all processors. Nothing where the machine
/// cannot stand.
std::vector<std::optional<PoseDoubt>> doubts_at(const machine::MachineModel& model,
                                                const identify::Posterior& posterior,
                                                const compensate::Settings& settings, const AxisWords& zero,
                                                const std::vector<compensate::PathSample>& samples);

/// The same at the points of a picture of it.
std::vector<std::optional<PoseDoubt>> doubts_at(const machine::MachineModel& model,
                                                const identify::Posterior& posterior,
                                                const compensate::Settings& settings, const AxisWords& zero,
                                                const compensate::DrawnPath& path);

/// Along samples of a program, on all processors. The zero is touched off where the settings say, or at the first of
/// them. Nothing: no samples, or the machine can stand at none of them.
std::optional<ExpectedError> expected_along(const machine::MachineModel& model, const identify::Posterior& posterior,
                                            const compensate::Settings& settings,
                                            const std::vector<compensate::PathSample>& samples);

/// What is said of a program at its end.
struct Expectation {
  std::optional<ExpectedError> error;            // nothing: the model does not say how sure its numbers are
  std::optional<Diagnostic> warning;             // why nothing is known
  std::optional<identify::Posterior> posterior;  // that it was known from
  std::vector<std::optional<PoseDoubt>> drawn;   // at the points of a picture, where there is one
};

/// Gathers samples of a program while it is read, and then says what is expected. Samples of it are dear beside its
/// correction: there are few, the extremes of all axes among them.
class ExpectedAlong {
 public:
  /// Both must outlive it.
  ExpectedAlong(const machine::MachineModel& model, const compensate::Settings& settings, bool wanted);

  /// Whether samples are needed at all.
  bool asks() const { return knowledge_.posterior.has_value(); }
  compensate::PathSamples& samples() { return samples_; }
  /// To be called once, at the end. `path`: a picture of the program, or null.
  Expectation take(const compensate::DrawnPath* path = nullptr);

 private:
  const machine::MachineModel& model_;
  const compensate::Settings& settings_;
  Knowledge knowledge_;
  compensate::PathSamples samples_;
};

}  // namespace plumbline::jobs
