#include "inspect/loaded_runs.hpp"

#include <algorithm>

#include "inspect/explanation.hpp"
#include "inspect/hypothesis.hpp"
#include "inspect/prediction.hpp"

namespace plumbline::inspect {

std::optional<Fault> payload_of_loaded_runs(const Looked& looked, const Bench& bench, const Prior& wide,
                                            const Outliers& outliers, const InspectOptions& options) {
  std::vector<std::size_t> loaded;
  std::vector<const RunRows*> free;
  for (std::size_t i = 0; i < looked.runs.size(); ++i) {
    if (outliers.out[i]) continue;  // what is wrong with it alone is said of it
    if (looked.runs[i].payload_mass > 0) {
      loaded.push_back(i);
    } else {
      free.push_back(&looked.rows[i]);
    }
  }
  if (loaded.size() < 2 || free.size() < 2) return std::nullopt;
  Prior prior = wide;
  fit_spreads(prior, free, options.outliers.rounds);
  Knowledge known(prior);
  for (const RunRows* run : free) known.add(*run);
  Suspects suspects{bench, looked.runs, looked.whole, loaded, {}, known};
  Eigen::Index rows = 0;
  for (const std::size_t i : loaded) {
    suspects.rows.push_back(&looked.rows[i]);
    rows += looked.rows[i].rows();
  }
  const double before = chi2_as_stated(suspects);
  const double usual = std::max(1.0, outliers.usual);
  if (before < (1 + options.outliers.excess) * usual * static_cast<double>(rows)) return std::nullopt;
  const std::optional<Tried> one = tried(suspects, payload_factor());
  if (!one) return std::nullopt;
  std::optional<Fault> fault = explanation({*one}, looked.runs[loaded[0]], before, rows, usual, options);
  if (!fault) return std::nullopt;
  for (std::size_t& run : fault->runs) run = looked.numbers[run];
  return fault;
}

}  // namespace plumbline::inspect
