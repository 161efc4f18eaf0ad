#include "diagnose/search/picks.hpp"

#include <algorithm>

#include "base/check.hpp"
#include "diagnose/candidates/kind.hpp"

namespace plumbline::diagnose {

std::vector<Pick> with(std::vector<Pick> picks, const Pick& pick, std::size_t place) {
  if (place < picks.size()) {
    picks[place] = pick;
  } else {
    picks.push_back(pick);
  }
  return picks;
}

std::vector<Pick> without(std::vector<Pick> picks, std::size_t place) {
  if (place < picks.size()) picks.erase(picks.begin() + static_cast<std::ptrdiff_t>(place));
  return picks;
}

Pick pick_of(const CandidateSet& candidates, const Candidate& candidate, const Score& score, Eigen::VectorXd& values) {
  Pick pick{&candidate, score.mode, score.column_groups, {}};
  for (const UnknownValue& number :
       candidate.kind->numbers(candidates, candidate, pick.acts(), score.columns, score.sizes)) {
    PLUMBLINE_CHECK(number.unknown >= 0);
    values[number.unknown] = number.value;
    pick.unknowns.push_back(number.unknown);
  }
  return pick;
}

Marginalised marginalised_by(const CandidateSet& candidates, const std::vector<Pick>& picks,
                             const Eigen::VectorXd& values) {
  Marginalised marginalised;
  std::vector<double> precision;
  std::vector<double> departure;
  std::vector<bool> free(candidates.nuisances, false);
  std::vector<int> more;
  for (const Pick& pick : picks) {
    for (const int place : pick.unknowns) {
      if (place < static_cast<int>(candidates.nuisances)) {
        free[static_cast<std::size_t>(place)] = true;
      } else {
        more.push_back(place);
      }
    }
  }
  for (std::size_t i = 0; i < candidates.nuisances; ++i) {
    const identify::Unknown& u = candidates.unknowns[i];
    marginalised.columns.push_back(static_cast<int>(i));
    precision.push_back(free[i] ? kWeakPrecision : 1);
    departure.push_back(free[i] ? 0 : (values[static_cast<Eigen::Index>(i)] - u.start) / u.scale);
  }
  for (const int place : more) {
    marginalised.columns.push_back(place);
    precision.push_back(kWeakPrecision);
    departure.push_back(0);
  }
  marginalised.precision = Eigen::Map<Eigen::VectorXd>(precision.data(), static_cast<Eigen::Index>(precision.size()));
  marginalised.departure = Eigen::Map<Eigen::VectorXd>(departure.data(), static_cast<Eigen::Index>(departure.size()));
  return marginalised;
}

std::vector<int> may_be_marginalised(const CandidateSet& candidates, const std::vector<Pick>& picks) {
  std::vector<int> columns;
  for (std::size_t u = 0; u < candidates.unknowns.size(); ++u) {
    const bool picked = std::any_of(picks.begin(), picks.end(), [&](const Pick& pick) {
      return pick.candidate->name == candidates.unknowns[u].effect;
    });
    if (u < candidates.nuisances || picked) columns.push_back(static_cast<int>(u));
  }
  return columns;
}

}  // namespace plumbline::diagnose
