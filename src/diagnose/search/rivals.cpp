#include "diagnose/search/rivals.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "diagnose/candidates/kind.hpp"
#include "diagnose/readings/poses.hpp"

namespace plumbline::diagnose {
namespace {

// The residual's column and row, the last: r + J size
void add_to_residual(Eigen::MatrixXd& gram, int column, double size) {
  const Eigen::Index r = gram.cols() - 1;
  gram.col(r) += size * gram.col(column);
  gram.row(r) += size * gram.row(column);
}

LeftOut left_out(const Workbench& bench, const LinearProblem& problem, const Marginalised& marginalised,
                 const Score& score) {
  std::vector<int> runs(bench.runs.size());
  std::iota(runs.begin(), runs.end(), 0);
  return {left_out_nats(problem, marginalised, score.columns, score.sizes, poses_of(bench.runs)),
          left_out_nats(problem, marginalised, score.columns, score.sizes, runs)};
}

// Whether a pick is the one of a stage at that place: what the stage was fitted with needs no other fit.
bool is_fitted(const FittedStage& stage, std::size_t place, const Pick& pick) {
  if (place >= stage.picks.size() || !stage.fit.converged) return false;
  const Pick& now = stage.picks[place];
  return now.candidate == pick.candidate && now.mode == pick.mode && now.column_groups == pick.column_groups;
}

bool is_picked(const std::vector<Pick>& picks, const Candidate& candidate) {
  return std::any_of(picks.begin(), picks.end(), [&](const Pick& pick) { return pick.candidate == &candidate; });
}

// "place 0: backlash 41.2* (38, 40)/6 cyclic 12.0": * is fitted, in brackets nats on poses and runs left out, after
// the stroke on how many struts
std::string rivals_text(const std::vector<Rival>& all, std::size_t place, std::size_t most) {
  std::string text = fmt::format("place {}:", place);
  for (std::size_t i = 0; i < std::min(all.size(), most); ++i) {
    text += fmt::format(" {} {:.1f}{}", all[i].pick.candidate->name, all[i].log_odds, all[i].refitted ? "*" : "");
    if (all[i].left_out) text += fmt::format(" ({:.0f}, {:.0f})", all[i].left_out->poses, all[i].left_out->runs);
    if (all[i].pick.column_groups.size() > 1 || all[i].pick.candidate->modes[0].column_groups.size() > 1)
      text += fmt::format("/{}", all[i].pick.column_groups.size());
  }
  return text;
}

}  // namespace

LinearProblem taken_back(const Workbench& bench, const FittedStage& stage, std::size_t place, Eigen::VectorXd& values) {
  LinearProblem problem;
  problem.gram = stage.problem->gram;
  for (const Block& block : stage.problem->blocks) problem.blocks.push_back({{}, block.gram});
  const Candidate& candidate = *stage.picks[place].candidate;
  for (const int u : stage.picks[place].unknowns) {
    if (u < static_cast<int>(bench.candidates.nuisances)) continue;
    for (const auto& [column, size] : candidate.kind->parts(bench.candidates, candidate, u, values)) {
      add_to_residual(problem.gram, column, size);
      for (Block& block : problem.blocks) add_to_residual(block.gram, column, size);
    }
    values[u] = bench.candidates.unknowns[static_cast<std::size_t>(u)].start;
  }
  return problem;
}

std::vector<Rival> rivals_for(const Workbench& bench, const FittedStage& stage, std::size_t place, double threshold,
                              const SearchOptions& options, const Say& say) {
  const bool replaces = place < stage.picks.size();
  Eigen::VectorXd values = stage.fit.values;
  const std::vector<Pick> others = without(stage.picks, place);
  const LinearProblem without_pick = replaces ? taken_back(bench, stage, place, values) : LinearProblem{};
  const LinearProblem& problem = replaces ? without_pick : *stage.problem;
  const Marginalised marginalised = marginalised_by(bench.candidates, others, values);
  const std::vector<Ranked> ranked = ranking(reduced_gram(problem, marginalised), bench.candidates, options.scoring);
  // what was fitted with that pick in its prior's place is a departure only without it
  const Refit fit_without = replaces ? refit(bench, others, values, stage.noise, options.refit) : stage.fit;
  std::vector<Rival> all;
  double best = std::numeric_limits<double>::lowest();
  for (const Ranked& r : ranked) {
    if (is_picked(others, *r.candidate)) continue;
    Rival rival;
    rival.start = values;
    rival.pick = pick_of(bench.candidates, *r.candidate, r.score, rival.start);
    rival.log_odds = r.score.log_odds;
    const bool near = r.score.log_odds > threshold - options.below_threshold &&
                      static_cast<int>(all.size()) < options.most_refits &&
                      r.score.log_odds > std::min(best - options.near_nats, (1 - options.near_share) * best);
    if (near) {
      rival.fit = is_fitted(stage, place, rival.pick)
                      ? stage.fit
                      : refit(bench, with(stage.picks, rival.pick, place), rival.start, stage.noise, options.refit);
      rival.log_odds += 0.5 * (fit_without.misfit - rival.fit.misfit - r.score.gain);
      rival.refitted = true;
      best = std::max(best, rival.log_odds);
      if (replaces) rival.left_out = left_out(bench, problem, marginalised, r.score);
    }
    all.push_back(std::move(rival));
  }
  std::stable_sort(all.begin(), all.end(), [](const Rival& a, const Rival& b) {
    if (a.refitted != b.refitted) return a.refitted;
    return a.log_odds > b.log_odds;
  });
  say(rivals_text(all, place, options.most_listed));
  return all;
}

}  // namespace plumbline::diagnose
