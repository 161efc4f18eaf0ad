#include "diagnose/search.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "diagnose/candidates/kind.hpp"
#include "diagnose/readings/noise_spectrum.hpp"
#include "diagnose/readings/poses.hpp"

namespace plumbline::diagnose {
namespace {

using identify::NoiseModel;

// Whether two estimates of the noise are as near as makes no difference: a step of the colour, 2 % of the size.
bool alike(const NoiseModel& a, const NoiseModel& b) {
  constexpr double kColour = 0.051;
  constexpr double kSize = 0.02;
  for (std::size_t c = 0; c < a.channels.size(); ++c) {
    const identify::ChannelNoise& one = a.channels[c];
    const identify::ChannelNoise& other = b.channels[c];
    if (one.samples != other.samples || std::abs(one.sigma - other.sigma) > kSize * other.sigma ||
        std::abs(one.memory - other.memory) > kColour || std::abs(one.white - other.white) > kColour) {
      return false;
    }
  }
  return true;
}

class Search {
 public:
  Search(const Workbench& bench, const SearchOptions& options, const Say& say)
      : bench_(bench), options_(options), say_(say) {}

  Model run() {
    settle({}, bench_.candidates.unknowns.start());
    base_ = {fit_, noise_, problem_};
    limit_ = threshold(left_, bench_.candidates, options_.scoring, options_.threshold).log_odds;
    say_(fmt::format("threshold {:.1f} nats", limit_));
    // what is dropped may be added again: rounds are counted
    for (int round = 0; round < 2 * options_.most_effects; ++round) {
      if (static_cast<int>(picks_.size()) >= options_.most_effects || !add_one()) break;
      for (int i = 0; i < options_.most_swaps && swap_one(); ++i) {
      }
      drop_idle();
    }
    return finish();
  }

 private:
  std::vector<Pick> with(const Pick& pick, std::size_t place) const {
    std::vector<Pick> picks = picks_;
    if (place < picks.size()) {
      picks[place] = pick;
    } else {
      picks.push_back(pick);
    }
    return picks;
  }
  std::vector<Pick> without(std::size_t place) const {
    std::vector<Pick> picks = picks_;
    if (place < picks.size()) picks.erase(picks.begin() + static_cast<std::ptrdiff_t>(place));
    return picks;
  }

  // Fits these picks, estimates the noise anew from what they leave, and takes all slopes there.
  void settle(const std::vector<Pick>& picks, const Eigen::VectorXd& start) {
    picks_ = picks;
    known_.clear();
    Eigen::VectorXd from = start;
    const auto is_unknown = [](const identify::ChannelNoise& channel) { return channel.samples == 0; };
    if (std::all_of(noise_.channels.begin(), noise_.channels.end(), is_unknown)) {
      identify::Objective objective(bench_.machine.rotation, bench_.runs, identify::Unknowns(bench_.forces),
                                    {.huber = 0});
      noise_ = identify::rough_noise(objective.equations(Eigen::VectorXd(0)));
    }
    for (int round = 0; round < options_.most_noise_rounds; ++round) {
      fit_ = refit(bench_, picks_, from, noise_, options_.refit);
      from = fit_.values;
      const NoiseModel next = noise_of(fit_.left);
      if (alike(next, noise_)) break;
      if (round + 1 < options_.most_noise_rounds) noise_ = next;
    }
    problem_ = linearise(bench_.machine.rotation, bench_.runs, bench_.candidates, fit_.values, noise_);
    left_ = left_of(problem_, taken_by(bench_.candidates, picks_, fit_.values));
    say_(fmt::format(
        "noise: bar {:.3f} um (memory {:.2f}, white {:.2f}), torque {:.4f} N m (memory {:.2f}, white {:.2f})",
        noise_.channels[0].sigma * 1e6, noise_.channels[0].memory, noise_.channels[0].white, noise_.channels[1].sigma,
        noise_.channels[1].memory, noise_.channels[1].white));
  }

  // The linear problem as if the pick at `place` were not there: its numbers go back to where they change nothing.
  // Gram matrices alone.
  LinearProblem taken_back(std::size_t place, Eigen::VectorXd& values) const {
    LinearProblem problem;
    problem.gram = problem_.gram;
    for (const Block& block : problem_.blocks) problem.blocks.push_back({{}, block.gram});
    for (const int u : picks_[place].unknowns) {
      if (u < static_cast<int>(bench_.candidates.nuisances)) continue;
      const Candidate& candidate = *picks_[place].candidate;
      for (const auto& [column, size] : candidate.kind->parts(bench_.candidates, candidate, u, values)) {
        add_to_residual(problem.gram, column, size);
        for (Block& block : problem.blocks) add_to_residual(block.gram, column, size);
      }
      values[u] = bench_.candidates.unknowns[static_cast<std::size_t>(u)].start;
    }
    return problem;
  }

  // The residual's column and row, the last: r + J size
  static void add_to_residual(Eigen::MatrixXd& gram, int column, double size) {
    const Eigen::Index r = gram.cols() - 1;
    gram.col(r) += size * gram.col(column);
    gram.row(r) += size * gram.row(column);
  }

  LeftOut left_out(const LinearProblem& problem, const Marginalised& taken, const Score& score) const {
    std::vector<int> runs(bench_.runs.size());
    std::iota(runs.begin(), runs.end(), 0);
    return {left_out_nats(problem, taken, score.columns, score.sizes, poses_of(bench_.runs)),
            left_out_nats(problem, taken, score.columns, score.sizes, runs)};
  }

  // Candidates for a place beside the other picks, best first.
  const std::vector<Rival>& rivals(std::size_t place) {
    known_.resize(std::max(known_.size(), place + 1));
    if (known_[place].empty()) known_[place] = new_rivals(place);
    return known_[place];
  }

  // By the linear problem, then the foremost of them fitted.
  std::vector<Rival> new_rivals(std::size_t place) const {
    Eigen::VectorXd values = fit_.values;
    const std::vector<Pick> others = without(place);
    const LinearProblem problem = place < picks_.size() ? taken_back(place, values) : LinearProblem{};
    const LinearProblem& about = place < picks_.size() ? problem : problem_;
    const Marginalised taken = taken_by(bench_.candidates, others, values);
    const Eigen::MatrixXd left = left_of(about, taken);
    // what was fitted with that pick in its prior's place is a departure only without it
    const std::vector<Ranked> ranked = ranking(left, bench_.candidates, options_.scoring);
    const Refit without_it = place < picks_.size() ? refit(bench_, others, values, noise_, options_.refit) : fit_;
    std::vector<Rival> all;
    double best = -1e9;
    for (const Ranked& r : ranked) {
      if (is_picked(*r.candidate, place)) continue;
      Rival rival;
      Eigen::VectorXd start = values;
      rival.pick = pick_of(bench_.candidates, *r.candidate, r.score, start);
      rival.log_odds = r.score.log_odds;
      const bool near = r.score.log_odds > limit_ - 3 && static_cast<int>(all.size()) < options_.most_refits &&
                        r.score.log_odds > std::min(best - options_.near_nats, (1 - options_.near_share) * best);
      rival.start = start;
      if (near) {
        rival.fit = refit(bench_, with(rival.pick, place), start, noise_, options_.refit);
        rival.log_odds += 0.5 * (without_it.misfit - rival.fit.misfit - r.score.gain);
        rival.refitted = true;
        best = std::max(best, rival.log_odds);
        if (place < picks_.size()) rival.left_out = left_out(about, taken, r.score);
      }
      all.push_back(std::move(rival));
    }
    std::stable_sort(all.begin(), all.end(), [](const Rival& a, const Rival& b) {
      if (a.refitted != b.refitted) return a.refitted;
      return a.log_odds > b.log_odds;
    });
    say_rivals(all, place);
    return all;
  }

  void say_rivals(const std::vector<Rival>& all, std::size_t place) const {
    std::string text = fmt::format("place {}:", place);
    for (std::size_t i = 0; i < std::min<std::size_t>(all.size(), 7); ++i) {
      text += fmt::format(" {} {:.1f}{}", all[i].pick.candidate->name, all[i].log_odds, all[i].refitted ? "*" : "");
      if (all[i].left_out) text += fmt::format(" ({:.0f}, {:.0f})", all[i].left_out->poses, all[i].left_out->runs);
      if (all[i].pick.column_groups.size() > 1 || all[i].pick.candidate->modes[0].column_groups.size() > 1)
        text += fmt::format("/{}", all[i].pick.column_groups.size());
    }
    say_(text);
  }

  bool is_picked(const Candidate& candidate, std::size_t place) const {
    for (std::size_t i = 0; i < picks_.size(); ++i) {
      if (i != place && picks_[i].candidate == &candidate) return true;
    }
    return false;
  }

  bool add_one() {
    const std::size_t place = picks_.size();
    const std::vector<Rival>& all = rivals(place);
    if (all.empty() || !all.front().refitted || all.front().log_odds < limit_) return false;
    const Rival best = all.front();
    settle(with(best.pick, place), best.fit.values);
    return true;
  }

  // Puts a better effect in the place of one that was picked, if there is one.
  bool swap_one() {
    for (std::size_t place = 0; place < picks_.size(); ++place) {
      const std::vector<Rival>& all = rivals(place);
      const Pick now = picks_[place];
      const Rival best = all.front();
      if (!best.refitted) continue;
      const bool same = best.pick.candidate == now.candidate && best.pick.column_groups == now.column_groups;
      if (same) continue;
      const auto mine =
          std::find_if(all.begin(), all.end(), [&](const Rival& r) { return r.pick.candidate == now.candidate; });
      if (mine != all.end() && mine->refitted && best.log_odds < mine->log_odds + 0.5) continue;
      say_(fmt::format("swap {} for {}", now.candidate->name, best.pick.candidate->name));
      settle(with(best.pick, place), best.fit.values);
      return true;
    }
    return false;
  }

  // Takes out what no longer passes the threshold beside the others.
  void drop_idle() {
    for (std::size_t place = 0; picks_.size() > 1 && place < picks_.size(); ++place) {
      const std::vector<Rival>& all = rivals(place);
      if (!all.empty() && all.front().refitted && all.front().log_odds >= limit_) continue;
      say_(fmt::format("drop {}", picks_[place].candidate->name));
      settle(without(place), fit_.values);
      place = static_cast<std::size_t>(-1);
    }
  }

  // The pick at a place with all its carriers, if the data do not rule out that all of them act: what a smaller set
  // leaves at nil would be stated as nil exactly.
  // Puts where to start from into `start`.
  Pick widened(std::size_t place, Eigen::VectorXd& start) const {
    const Pick& pick = picks_[place];
    const ActingMode& mode = pick.candidate->modes[static_cast<std::size_t>(pick.mode)];
    if (pick.column_groups.size() == mode.column_groups.size()) return pick;
    Eigen::VectorXd values = fit_.values;
    const LinearProblem problem = taken_back(place, values);
    const Eigen::MatrixXd left = left_of(problem, taken_by(bench_.candidates, without(place), values));
    const auto score = [&](const std::vector<int>& column_groups) {
      return score_of(left, bench_.candidates, *pick.candidate, pick.mode, column_groups, options_.scoring);
    };
    std::vector<int> all(mode.column_groups.size());
    std::iota(all.begin(), all.end(), 0);
    const Score full = score(all);
    if (full.log_odds < score(pick.column_groups).log_odds - options_.all_struts_nats) return pick;
    Pick wide = pick_of(bench_.candidates, *pick.candidate, full, values);
    start(wide.unknowns) = values(wide.unknowns);
    return wide;
  }

  // The last fit, from where the search ended.
  Refit last_fit(std::vector<Pick>& picks) const {
    bool more = false;
    Eigen::VectorXd start = fit_.values;
    for (std::size_t place = 0; place < picks.size(); ++place) {
      const std::size_t before = picks[place].unknowns.size();
      picks[place] = widened(place, start);
      more = more || picks[place].unknowns.size() > before;
    }
    return more ? refit(bench_, picks, start, noise_, options_.refit) : fit_;
  }

  Model finish() {
    Model model;
    const std::vector<Rival>& more = rivals(picks_.size());
    model.one_more = !more.empty() && more.front().refitted && more.front().log_odds >= limit_;
    std::vector<Pick> picks = picks_;
    model.fit = last_fit(picks);
    for (std::size_t place = 0; place < picks_.size(); ++place) {
      Found found;
      found.pick = picks[place];
      found.rivals = rivals(place);
      const auto mine = std::find_if(found.rivals.begin(), found.rivals.end(),
                                     [&](const Rival& r) { return r.pick.candidate == found.pick.candidate; });
      if (mine != found.rivals.end()) {
        found.log_odds = mine->log_odds;
        found.left_out = mine->left_out;
        found.rivals.erase(mine);
      }
      if (!found.rivals.empty() &&
          !found.rivals.front().refitted) {  // the gap is shown with the runner-up, however far
        Rival& second = found.rivals.front();
        second.fit = refit(bench_, with(second.pick, place), second.start, noise_, options_.refit);
      }
      model.found.push_back(std::move(found));
    }
    std::stable_sort(model.found.begin(), model.found.end(),
                     [](const Found& a, const Found& b) { return a.log_odds > b.log_odds; });
    model.noise = noise_;
    model.threshold = limit_;
    model.base = base_;
    model.problem = std::move(problem_);
    return model;
  }

  const Workbench& bench_;
  const SearchOptions& options_;
  const Say& say_;
  std::vector<Pick> picks_;
  std::vector<std::vector<Rival>> known_;  // of each place, since the last settle()
  NoiseModel noise_;
  Refit fit_;
  FittedStage base_;
  LinearProblem problem_;
  Eigen::MatrixXd left_;
  double limit_ = 0;
};

}  // namespace

Model search(const Workbench& bench, const SearchOptions& options, const Say& say) {
  return Search(bench, options, say).run();
}

}  // namespace plumbline::diagnose
