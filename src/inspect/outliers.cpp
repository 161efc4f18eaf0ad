#include "inspect/outliers.hpp"

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "inspect/statistics.hpp"

namespace plumbline::inspect {
namespace {

// The readings of the bar alone, which come first: their chi-square over their number.
double bar_square(const Knowledge& known, const RunRows& run) {
  const Eigen::Index count = run.raw.samples;
  if (!run.raw.first_row(identify::kRadial) || run.rows() == count) return 0;
  const identify::SlopeRows slopes = run.slopes.topRows(count);
  return Prediction(known, slopes).chi2(run.left.head(count)) / static_cast<double>(count);
}

void predict_all(Outliers& outliers, const std::vector<RunRows>& runs) {
  outliers.mean_square.assign(runs.size(), 0);
  outliers.bar_square.assign(runs.size(), 0);
  for_each_index(runs.size(), [&](std::size_t r) {
    const Knowledge known = knowledge_of_others(outliers, runs, r);
    const Prediction prediction(known, runs[r].slopes, runs[r].gram);
    outliers.mean_square[r] = prediction.chi2(runs[r].left) / static_cast<double>(runs[r].rows());
    outliers.bar_square[r] = bar_square(known, runs[r]);
  });
  std::vector<double> kept;
  std::vector<double> bars;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    if (outliers.out[r]) continue;
    kept.push_back(outliers.mean_square[r]);
    if (outliers.bar_square[r] > 0) bars.push_back(outliers.bar_square[r]);
  }
  outliers.usual = kept.empty() ? 1 : median(kept);
  outliers.usual_bar = bars.empty() ? 1 : median(bars);
}

}  // namespace

Knowledge knowledge_of_others(const Outliers& outliers, const std::vector<RunRows>& runs, std::size_t without) {
  Knowledge known(outliers.prior);
  for (std::size_t r = 0; r < runs.size(); ++r) {
    if (r != without && !outliers.out[r]) known.add(runs[r]);
  }
  return known;
}

double excess_of(const Outliers& outliers, std::size_t run, const OutlierOptions& options) {
  const double all = outliers.mean_square[run] / (std::max(1.0, outliers.usual) * (1 + options.excess));
  const double bar = outliers.bar_square[run] / (std::max(1.0, outliers.usual_bar) * (1 + options.bar_excess));
  return std::max(all, bar);
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
      if (outliers.out[r]) continue;
      if (worst == runs.size() || excess_of(outliers, r, options) > excess_of(outliers, worst, options)) worst = r;
    }
    if (worst == runs.size() || taken >= most || excess_of(outliers, worst, options) < 1) break;
    outliers.out[worst] = true;
  }
  for (std::size_t r = 0; r < runs.size(); ++r) {
    if (excess_of(outliers, r, options) < 1) outliers.out[r] = false;
  }
  return outliers;
}

}  // namespace plumbline::inspect
