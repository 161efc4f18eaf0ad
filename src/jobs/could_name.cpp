#include "jobs/could_name.hpp"

#include <algorithm>
#include <cmath>

#include "diagnose/evidence/threshold.hpp"
#include "diagnose/search/picks.hpp"
#include "measure/planned_run.hpp"

namespace plumbline::jobs {

std::vector<diagnose::Visible> could_name(const machine::MachineModel& machine, std::vector<measure::Run> runs,
                                          const identify::NoiseModel& noise, const CouldNameOptions& options) {
  identify::NoiseModel of_fewer = noise;  // fewer samples, each as much less noisy
  double all = 0;
  double looked_at = 0;
  for (measure::Run& run : runs) {
    const std::size_t samples = std::min(run.samples(), options.samples);
    all += static_cast<double>(run.samples());
    looked_at += static_cast<double>(samples);
    measure::lay_samples(run, samples, run.has_radial(), run.has_torque());
  }
  for (identify::ChannelNoise& channel : of_fewer.channels) channel.sigma *= std::sqrt(looked_at / std::max(all, 1.0));
  const diagnose::CandidateSet candidates = diagnose::make_candidate_set(machine, physics::ForceModel(machine));
  const Eigen::VectorXd start = candidates.unknowns.start();
  const diagnose::LinearProblem problem =
      diagnose::linearise(machine.rotation, runs, candidates, start, of_fewer, std::vector<int>{});
  const Eigen::MatrixXd reduced = diagnose::reduced_gram(problem, diagnose::marginalised_by(candidates, {}, start));
  diagnose::ThresholdOptions drawn;
  drawn.draws = options.draws;
  const double threshold = diagnose::threshold(reduced, candidates, {}, drawn).log_odds;
  return diagnose::visible_effects(reduced, candidates, threshold);
}

}  // namespace plumbline::jobs
