// Effects that bend by their own size: a mode for each size that is tried, its column per unit of it.
#include <algorithm>
#include <cmath>

#include "diagnose/candidates/kind.hpp"

namespace plumbline::diagnose {
namespace {

class BentBySize : public TriedShapes {
 public:
  std::vector<UnknownValue> numbers(const CandidateSet& set, const Candidate& candidate, const ActingMode& mode,
                                    const std::vector<int>& columns, const Eigen::VectorXd& sizes) const override {
    const Column& column = set.columns[static_cast<std::size_t>(columns.front())];
    // what shows grows with its square
    const double size = std::sqrt(std::max(sizes[0] * column.scale, 0.0) * mode.shape);
    return {{set.unknowns.find(candidate.name, info_of(candidate).bend->size), size}};
  }
  // What it adds goes with its size and the square of it, for which the columns of two sizes do.
  std::vector<std::pair<int, double>> parts(const CandidateSet& set, const Candidate& candidate, int unknown,
                                            const Eigen::VectorXd& values) const override {
    const identify::Unknown& u = set.unknowns[static_cast<std::size_t>(unknown)];
    const double size = (values[unknown] - u.start) / u.scale;
    const ActingMode& little = candidate.modes.front();
    const ActingMode& much = candidate.modes.back();
    const double share = (values[unknown] - little.shape) / (much.shape - little.shape);
    return {{little.column_groups[0][0], (1 - share) * size}, {much.column_groups[0][0], share * size}};
  }
};

}  // namespace

const CandidateKind& bent_by_size() {
  static const BentBySize kind;
  return kind;
}

}  // namespace plumbline::diagnose
