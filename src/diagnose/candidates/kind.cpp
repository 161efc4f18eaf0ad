#include "diagnose/candidates/kind.hpp"

#include <algorithm>

#include "base/check.hpp"

namespace plumbline::diagnose {
namespace {

double si_of(const physics::EffectInfo& info, std::string_view key) {
  const auto spec = std::find_if(info.parameters.begin(), info.parameters.end(),
                                 [&](const physics::ParameterSpec& s) { return s.key == key; });
  PLUMBLINE_CHECK(spec != info.parameters.end());
  return spec->unit.si;
}

}  // namespace

const physics::EffectInfo& info_of(const Candidate& candidate) {
  return physics::effect_infos()[physics::effect_index(candidate.name)];
}

const CandidateKind& kind_of(const physics::EffectInfo& info) {
  if (info.bend == nullptr) return straight();
  switch (info.bend->by) {
    case physics::Bend::By::setting:
      return bent_by_setting();
    case physics::Bend::By::size:
      return bent_by_size();
    case physics::Bend::By::phase:
      break;
  }
  return bent_by_phase();
}

void CandidateKind::fill(const RunColumns&, const Candidate&, identify::SlopeRows&) const {}

std::vector<std::pair<int, double>> CandidateKind::parts(const CandidateSet& set, const Candidate&, int unknown,
                                                         const Eigen::VectorXd& values) const {
  const identify::Unknown& u = set.unknowns[static_cast<std::size_t>(unknown)];
  if (u.shape) return {};
  return {{unknown, (values[unknown] - u.start) / u.scale}};
}

int add_made_column(CandidateSet& set, int unknown) {
  Column column = set.columns[static_cast<std::size_t>(unknown)];
  column.unknown = -1;
  set.columns.push_back(std::move(column));
  return static_cast<int>(set.columns.size()) - 1;
}

void TriedShapes::add_modes(const physics::EffectInfo& info, CandidateSet& set, Candidate& candidate) const {
  const int size = set.unknowns.find(info.name, info.bend->size);
  for (const double shape : info.bend->tried) {
    ActingMode mode{{{add_made_column(set, size)}}};
    mode.shape = shape * si_of(info, info.bend->shape);
    candidate.modes.push_back(std::move(mode));
  }
}

void TriedShapes::fill(const RunColumns& run, const Candidate& candidate, identify::SlopeRows& all) const {
  const physics::Bend& bend = *info_of(candidate).bend;
  for (const ActingMode& mode : candidate.modes) {
    const int column = mode.column_groups[0][0];
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(all.rows());
    for (int j = 0; j < machine::kStruts; ++j) {
      sum += run.slope(bend.of, bend.of_key, j).cwiseProduct(run.each_sample(j, [&](const physics::StrutMoment& strut) {
        return bend.factor(strut, mode.shape);
      }));
    }
    all.col(column) = run.scale(column) * sum;
  }
}

}  // namespace plumbline::diagnose
