// The design of circular tests: which of those that a machine can make tell most of what is asked for.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "identify/equations/objective.hpp"

namespace plumbline::identify {

struct CandidateOptions {
  std::vector<double> radii{0.144};   // m
  std::optional<double> bar = 0.150;  // m; of circles that it reaches, others are made with the bar in their plane
  std::vector<double> feeds{1000.0 / 60000};  // m/s
  std::vector<double> payloads{0};            // kg, known masses at the tool tip
  double step = 0.010;                        // m, to which centres are rounded
  double tilt_step = 0.017453292519943295;    // rad
  double tilt_share = 0.9;                    // of the limit of tilt that plans use
  double most_off = 0.5e-3;                   // m, that the model's tip may be off on a circle (stands_firm)
  bool bar_readings = true;
  bool torques = true;
  std::size_t samples = 36;  // of each candidate
  std::size_t most = 400;    // candidates
  std::size_t tries = 60;    // draws for each of them: most circles that are drawn go beyond the machine's limits
  std::uint64_t seed = 1;
};

/// Whether the model's tip is at no sample of a run further than `most` (m) from where it is commanded. Beside a
/// singularity it is: a machine that gives way a little more than its model may not stand there.
bool stands_firm(const machine::RotationOrder& order, const physics::ForceModel& forces, const measure::Run& run,
                 double most);

/// Circular tests that the machine can make, the tip never further off than `most_off`, drawn evenly from its travel
/// and tilt, both directions. Their order and number depend on the seed alone.
std::vector<measure::Run> candidate_runs(const machine::MachineModel& machine, const CandidateOptions& options = {});

/// What a plan is good for, the greater the better: of the information that all its runs give together, in scales of
/// the unknowns and without priors.
using Criterion = std::function<double(const Eigen::MatrixXd& information)>;

/// D-optimality for some of the unknowns: the logarithm of the determinant of what is known of them after the data, the
/// others within their priors  [Atkinson, Donev, Tobias 2007, 10.3: D_s].
Criterion d_optimal(const Unknowns& unknowns, std::vector<std::size_t> asked);

/// V-optimality: minus the logarithm of the mean variance, um^2, of what moves with the unknowns, S the slopes;
/// `mean_squares` are means of S^T S, SI. Of several, the mean of the logarithms: each counts by the share by which it
/// falls  [Atkinson, Donev, Tobias 2007, 10.6].
Criterion v_optimal(const Unknowns& unknowns, const std::vector<Eigen::MatrixXd>& mean_squares);

/// How far one effect stands out when another one and everything else may take what it can: the noncentrality of the
/// weakest number of `effect`, its size one scale (Unknown::scale: a hundredth of its range), the others within their
/// priors. Numbers that nothing shows at the unknowns' start are left out.
double noncentrality(const Unknowns& unknowns, const Eigen::MatrixXd& information,
                     const std::vector<std::size_t>& effect, const std::vector<std::size_t>& other);

/// The smaller of the two noncentralities, its logarithm: plans that tell two effects apart whichever acts
/// `unknowns` are kept by reference  [Atkinson and Fedorov 1975, T-optimality, about a model that holds both].
Criterion separating(const Unknowns& unknowns, std::vector<std::size_t> one, std::vector<std::size_t> other);

struct DesignOptions {
  std::size_t runs = 12;
  std::size_t most_passes = 6;     // of exchanges
  double least_gain = 1e-6;        // of the criterion for which a run is exchanged
  double readings_per_sample = 1;  // independent readings of a real run for each sample of a candidate
};

/// What a run tells at the unknowns' start, in scales. Refuses with simulate-unreachable.
Eigen::MatrixXd run_information(const machine::RotationOrder& order, const measure::Run& run, const Unknowns& unknowns,
                                const NoiseModel& noise);

struct Design {
  std::vector<std::size_t> chosen;  // of the candidates, what tells most first
  std::vector<double> criterion;    // after each of them
  Eigen::MatrixXd information;      // of what was known already and all of them, in scales
  std::size_t exchanges = 0;
};

/// Chooses runs one after the other, each the one that makes the criterion greatest, and then exchanges them one by one
/// for better ones until none is left  [Fedorov 1972]. A run may be chosen again: it is then repeated.
/// `known`: the information of what was measured already.
Design design(const std::vector<Eigen::MatrixXd>& candidates, const Eigen::MatrixXd& known, const Criterion& criterion,
              const DesignOptions& options = {});

}  // namespace plumbline::identify
