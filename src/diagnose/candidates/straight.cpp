// Effects whose readings move in proportion to their numbers: a column for each number.
#include "diagnose/candidates/kind.hpp"

namespace plumbline::diagnose {
namespace {

class Straight : public CandidateKind {
 public:
  void add_modes(const physics::EffectInfo& info, CandidateSet& set, Candidate& candidate) const override {
    ActingMode mode;
    mode.all_or_none = mode.sums_to_zero = info.sums_to_zero;
    for (const physics::ParameterSpec& spec : info.parameters) {
      for (int i = 0; i < spec.size(); ++i) {
        const int column = set.unknowns.find(info.name, spec.key, spec.size() == 1 ? -1 : i);
        const bool own = spec.count == 6 && i % spec.each == 0;  // a joint's three numbers belong together
        if (own || mode.column_groups.empty()) mode.column_groups.emplace_back();
        mode.column_groups.back().push_back(column);
      }
    }
    candidate.modes.push_back(std::move(mode));
  }

  std::vector<UnknownValue> numbers(const CandidateSet& set, const Candidate&, const ActingMode&,
                                    const std::vector<int>& columns, const Eigen::VectorXd& sizes) const override {
    std::vector<UnknownValue> numbers;
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const Column& column = set.columns[static_cast<std::size_t>(columns[i])];
      const double size = sizes[static_cast<Eigen::Index>(i)] * column.scale;
      numbers.push_back({column.unknown, set.unknowns[static_cast<std::size_t>(column.unknown)].start + size});
    }
    return numbers;
  }
};

}  // namespace

const CandidateKind& straight() {
  static const Straight kind;
  return kind;
}

}  // namespace plumbline::diagnose
