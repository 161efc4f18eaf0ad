#include "inspect/outliers.hpp"

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "inspect/statistics.hpp"

namespace plumbline::inspect {
namespace {

void predict_all(Outliers& outliers, const std::vector<RunRows>& runs) {
  outliers.mean_square.assign(runs.size(), 0);
  for_each_index(runs.size(), [&](std::size_t r) {
    const Prediction prediction(knowledge_of_others(outliers, runs, r), runs[r].slopes, runs[r].gram);
    outliers.mean_square[r] = prediction.chi2(runs[r].left) / static_cast<double>(runs[r].rows());
  });
  std::vector<double> kept;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    if (!outliers.out[r]) kept.push_back(outliers.mean_square[r]);
  }
  outliers.usual = kept.empty() ? 1 : median(kept);
}

}  // namespace

Knowledge knowledge_of_others(const Outliers& outliers, const std::vector<RunRows>& runs, std::size_t without) {
  Knowledge known(outliers.prior);
  for (std::size_t r = 0; r < runs.size(); ++r) {
    if (r != without && !outliers.out[r]) known.add(runs[r]);
  }
  return known;
}

Outliers find_outliers(const Prior& wide, const std::vector<RunRows>& runs, const OutlierOptions& options) {
  Outliers outliers{wide, std::vector<bool>(runs.size(), false), {}, 1};
  const auto most = static_cast<std::size_t>(options.most_share * static_cast<double>(runs.size()));
  for (std::size_t taken = 0;; ++taken) {
    outliers.prior = wide;
    std::vector<const RunRows*> kept;
    for (std::size_t r = 0; r < runs.size(); ++r) {
      if (!outliers.out[r]) kept.push_back(&runs[r]);
    }
    fit_spreads(outliers.prior, kept, options.rounds);
    predict_all(outliers, runs);
    std::size_t worst = runs.size();
    for (std::size_t r = 0; r < runs.size(); ++r) {
      if (!outliers.out[r] && (worst == runs.size() || outliers.mean_square[r] > outliers.mean_square[worst]))
        worst = r;
    }
    const double usual = std::max(1.0, outliers.usual);
    if (worst == runs.size() || taken >= most || outliers.mean_square[worst] < usual * (1 + options.excess)) break;
    outliers.out[worst] = true;
  }
  for (std::size_t r = 0; r < runs.size(); ++r) {
    if (outliers.mean_square[r] < std::max(1.0, outliers.usual) * (1 + options.excess)) outliers.out[r] = false;
  }
  return outliers;
}

}  // namespace plumbline::inspect
