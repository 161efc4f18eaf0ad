// Effects of a size and a phase on each strut: columns of a sine and a cosine, which make up any phase.
#include <cmath>

#include "diagnose/candidates/kind.hpp"

namespace plumbline::diagnose {
namespace {

class BentByPhase : public CandidateKind {
 public:
  void add_modes(const physics::EffectInfo& info, CandidateSet& set, Candidate& candidate) const override {
    ActingMode mode;
    for (int strut = 0; strut < machine::kStruts; ++strut) {
      const int size = set.unknowns.find(info.name, info.bend->size, strut);
      const int sine = add_made_column(set, size);
      mode.column_groups.push_back({sine, add_made_column(set, size)});
    }
    candidate.modes.push_back(std::move(mode));
  }

  void fill(const RunColumns& run, const Candidate& candidate, identify::SlopeRows& all) const override {
    const physics::Bend& bend = *info_of(candidate).bend;
    for (const ColumnGroup& group : candidate.modes[0].column_groups) {
      const int strut = run.candidates.columns[static_cast<std::size_t>(group[0])].strut;
      const auto slope = run.slope(bend.of, bend.of_key, strut);
      const auto sine = [&](const physics::StrutMoment& moment) { return bend.factor(moment, 0); };
      all.col(group[0]) = run.scale(group[0]) * slope.cwiseProduct(run.each_sample(strut, sine));
      all.col(group[1]) = run.scale(group[1]) * slope.cwiseProduct(run.each_sample(strut, bend.quarter_turn_on));
    }
  }

  std::vector<UnknownValue> numbers(const CandidateSet& set, const Candidate& candidate, const ActingMode&,
                                    const std::vector<int>& columns, const Eigen::VectorXd& sizes) const override {
    const physics::Bend& bend = *info_of(candidate).bend;
    std::vector<UnknownValue> numbers;
    for (std::size_t i = 0; i + 1 < columns.size(); i += 2) {
      const Column& column = set.columns[static_cast<std::size_t>(columns[i])];
      const double sine = sizes[static_cast<Eigen::Index>(i)] * column.scale;
      const double cosine = sizes[static_cast<Eigen::Index>(i) + 1] * column.scale;
      numbers.push_back({set.unknowns.find(candidate.name, bend.size, column.strut), std::hypot(sine, cosine)});
      numbers.push_back({set.unknowns.find(candidate.name, bend.shape, column.strut), std::atan2(cosine, sine)});
    }
    return numbers;
  }
};

}  // namespace

const CandidateKind& bent_by_phase() {
  static const BentByPhase kind;
  return kind;
}

}  // namespace plumbline::diagnose
