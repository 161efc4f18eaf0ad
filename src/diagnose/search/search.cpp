#include "diagnose/search/search.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include <fmt/format.h>

namespace plumbline::diagnose {
namespace {

std::vector<Rival>::const_iterator rival_of(const std::vector<Rival>& all, const Candidate* candidate) {
  return std::find_if(all.begin(), all.end(), [&](const Rival& r) { return r.pick.candidate == candidate; });
}

class Search {
 public:
  Search(const Workbench& bench, const SearchOptions& options, const Say& say)
      : bench_(bench), options_(options), say_(say) {}

  Model run() {
    say_.begin("fitting the model as it is given");
    settle({}, bench_.candidates.unknowns.start());
    say_.begin("working out what noise alone would look like");
    base_ = stage_;
    const Eigen::MatrixXd reduced =
        reduced_gram(*stage_.problem, marginalised_by(bench_.candidates, {}, stage_.fit.values));
    threshold_ = threshold(reduced, bench_.candidates, options_.scoring, options_.threshold).log_odds;
    say_(fmt::format("threshold {:.1f} nats", threshold_));
    // what is dropped may be added again: rounds are counted
    for (int round = 0; round < 2 * options_.most_effects; ++round) {
      if (static_cast<int>(stage_.picks.size()) >= options_.most_effects || !add_one()) break;
      for (int i = 0; i < options_.most_swaps && swap_one(); ++i) {
      }
      while (drop_one()) {
      }
    }
    return finish();
  }

 private:
  void settle(std::vector<Pick> picks, const Eigen::VectorXd& start) {
    stage_ = fitted_stage(bench_, std::move(picks), start, stage_.noise, options_, say_);
    known_.clear();
  }

  // Candidates for a place beside the other picks, best first.
  const std::vector<Rival>& rivals(std::size_t place) {
    known_.resize(std::max(known_.size(), place + 1));
    if (known_[place].empty()) {
      known_[place] = rivals_for(bench_, stage_, place, threshold_, options_, say_);
    }
    return known_[place];
  }

  bool best_passes(std::size_t place) {
    const std::vector<Rival>& all = rivals(place);
    return !all.empty() && all.front().refitted && all.front().log_odds >= threshold_;
  }

  bool add_one() {
    const std::size_t place = stage_.picks.size();
    say_.begin(place == 0 ? fmt::format("trying {} effects that it may lack", bench_.candidates.all.size())
                          : fmt::format("looking for one more effect beside {}", stage_.picks.front().candidate->name));
    if (!best_passes(place)) return false;
    const Rival best = rivals(place).front();
    settle(with(stage_.picks, best.pick, place), best.fit.values);
    return true;
  }

  // Puts a better effect in the place of one that was picked, if there is one.
  bool swap_one() {
    for (std::size_t place = 0; place < stage_.picks.size(); ++place) {
      const std::vector<Rival>& all = rivals(place);
      const Pick& now = stage_.picks[place];
      const Rival best = all.front();
      if (!best.refitted) continue;
      if (best.pick.candidate == now.candidate && best.pick.column_groups == now.column_groups) continue;
      const auto mine = rival_of(all, now.candidate);
      if (mine != all.end() && mine->refitted && best.log_odds < mine->log_odds + options_.swap_nats) continue;
      say_(fmt::format("swap {} for {}", now.candidate->name, best.pick.candidate->name));
      settle(with(stage_.picks, best.pick, place), best.fit.values);
      return true;
    }
    return false;
  }

  // Takes out an effect that no longer passes the threshold beside the others, if there is one.
  bool drop_one() {
    for (std::size_t place = 0; stage_.picks.size() > 1 && place < stage_.picks.size(); ++place) {
      if (best_passes(place)) continue;
      say_(fmt::format("drop {}", stage_.picks[place].candidate->name));
      settle(without(stage_.picks, place), stage_.fit.values);
      return true;
    }
    return false;
  }

  // The pick at a place with all its groups, if the data do not rule out that all of them act: what a smaller set
  // leaves at nil would be stated as nil exactly. Puts where to start from into `start`.
  Pick widened(std::size_t place, Eigen::VectorXd& start) const {
    const Pick& pick = stage_.picks[place];
    if (pick.column_groups.size() == pick.acts().column_groups.size()) return pick;
    Eigen::VectorXd values = stage_.fit.values;
    const LinearProblem problem = taken_back(bench_, stage_, place, values);
    const Eigen::MatrixXd reduced =
        reduced_gram(problem, marginalised_by(bench_.candidates, without(stage_.picks, place), values));
    const auto score = [&](const std::vector<int>& column_groups) {
      return score_of(reduced, bench_.candidates, *pick.candidate, pick.mode, column_groups, options_.scoring);
    };
    std::vector<int> all(pick.acts().column_groups.size());
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
    Eigen::VectorXd start = stage_.fit.values;
    for (std::size_t place = 0; place < picks.size(); ++place) {
      const std::size_t before = picks[place].unknowns.size();
      picks[place] = widened(place, start);
      more = more || picks[place].unknowns.size() > before;
    }
    return more ? refit(bench_, picks, start, stage_.noise, options_.refit) : stage_.fit;
  }

  Found found_at(std::size_t place, const Pick& pick) {
    Found found;
    found.pick = pick;
    found.rivals = rivals(place);
    const auto mine = rival_of(found.rivals, pick.candidate);
    if (mine != found.rivals.end()) {
      found.log_odds = mine->log_odds;
      found.left_out = mine->left_out;
      found.rivals.erase(mine);
    }
    if (!found.rivals.empty() && !found.rivals.front().refitted) {  // the gap is shown with it, however unlikely
      Rival& second = found.rivals.front();
      second.fit = refit(bench_, with(stage_.picks, second.pick, place), second.start, stage_.noise, options_.refit);
    }
    return found;
  }

  Model finish() {
    Model model;
    model.one_more = best_passes(stage_.picks.size());
    std::vector<Pick> picks = stage_.picks;
    model.fit = last_fit(picks);
    for (std::size_t place = 0; place < picks.size(); ++place) model.found.push_back(found_at(place, picks[place]));
    std::stable_sort(model.found.begin(), model.found.end(),
                     [](const Found& a, const Found& b) { return a.log_odds > b.log_odds; });
    model.noise = stage_.noise;
    model.threshold = threshold_;
    model.base = std::move(base_);
    model.problem = std::move(stage_.problem);
    return model;
  }

  const Workbench& bench_;
  const SearchOptions& options_;
  const Say& say_;
  FittedStage stage_;
  FittedStage base_;
  std::vector<std::vector<Rival>> known_;  // of each place of the stage
  double threshold_ = 0;
};

}  // namespace

std::vector<Pick> picks_of(const Model& model) {
  std::vector<Pick> picks;
  for (const Found& found : model.found) picks.push_back(found.pick);
  return picks;
}

Model search(const Workbench& bench, const SearchOptions& options, const Say& say) {
  return Search(bench, options, say).run();
}

}  // namespace plumbline::diagnose
