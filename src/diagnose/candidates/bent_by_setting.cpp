// Effects of one size that bend by a number beside it: a mode for each setting that is tried.
#include "diagnose/candidates/kind.hpp"

namespace plumbline::diagnose {
namespace {

class BentBySetting : public TriedShapes {
 public:
  std::vector<UnknownValue> numbers(const CandidateSet& set, const Candidate& candidate, const ActingMode& mode,
                                    const std::vector<int>& columns, const Eigen::VectorXd& sizes) const override {
    const physics::Bend& bend = *info_of(candidate).bend;
    const Column& column = set.columns[static_cast<std::size_t>(columns.front())];
    return {{set.unknowns.find(candidate.name, bend.size), sizes[0] * column.scale},
            {set.unknowns.find(candidate.name, bend.shape), mode.shape}};
  }
};

}  // namespace

const CandidateKind& bent_by_setting() {
  static const BentBySetting kind;
  return kind;
}

}  // namespace plumbline::diagnose
