#include "diagnose/candidates/candidate_set.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "base/check.hpp"
#include "base/diagnostic.hpp"
#include "diagnose/candidates/kind.hpp"

namespace plumbline::diagnose {
namespace {

using physics::EffectInfo;
using physics::ParameterSpec;

void check_known(const std::string& name) {
  const auto names = physics::catalogue_names();
  if (std::find(names.begin(), names.end(), name) != names.end()) return;
  refuse("diagnose-unknown-effect", fmt::format("no effect is called {}", name),
         fmt::format("the catalogue has {}", fmt::join(names, ", ")));
}

void add_unknowns(const EffectInfo& info, identify::Unknowns& unknowns) {
  for (const ParameterSpec& spec : info.parameters) {
    for (int i = 0; i < spec.size(); ++i) {
      if (unknowns.find(info.name, spec.key, spec.size() == 1 ? -1 : i) < 0) unknowns.add(info.name, spec.key, i);
    }
  }
}

Column column_of(const identify::Unknowns& unknowns, std::size_t u) {
  const identify::Unknown& unknown = unknowns[u];
  Column column{unknown.effect, unknown.key, unknown.index};
  column.unknown = static_cast<int>(u);
  column.scale = unknown.scale;
  const auto& infos = physics::effect_infos();
  for (const ParameterSpec& spec : infos[physics::effect_index(unknown.effect)].parameters) {
    if (spec.key == unknown.key && spec.count == 6 && unknown.index >= 0) column.strut = unknown.index / spec.each;
  }
  column.lower = (unknown.lower - unknown.start) / unknown.scale;
  column.upper = (unknown.upper - unknown.start) / unknown.scale;
  return column;
}

}  // namespace

const Candidate& CandidateSet::candidate(std::string_view name) const {
  const auto found = std::find_if(all.begin(), all.end(), [&](const Candidate& c) { return c.name == name; });
  PLUMBLINE_CHECK(found != all.end());
  return *found;
}

CandidateSet make_candidate_set(const machine::MachineModel& machine, const physics::ForceModel& forces,
                                const CandidateSetOptions& options) {
  for (const std::string& name : options.without) check_known(name);
  CandidateSet set{identify::nuisances(machine, forces), 0, {}, {}};
  set.nuisances = set.unknowns.size();
  for (const EffectInfo& info : physics::effect_infos()) {
    if (info.is_cause()) add_unknowns(info, set.unknowns);
  }
  for (std::size_t u = 0; u < set.unknowns.size(); ++u) set.columns.push_back(column_of(set.unknowns, u));
  for (const EffectInfo& info : physics::effect_infos()) {
    const bool left_out = std::find(options.without.begin(), options.without.end(), info.name) != options.without.end();
    if (!info.is_cause() || left_out) continue;
    Candidate candidate{std::string(info.name), info.rare, {}, &kind_of(info)};
    candidate.kind->add_modes(info, set, candidate);
    set.all.push_back(std::move(candidate));
  }
  return set;
}

CandidateSet make_nuisance_set(const machine::MachineModel& machine, const physics::ForceModel& forces) {
  CandidateSet set{identify::nuisances(machine, forces), 0, {}, {}};
  set.nuisances = set.unknowns.size();
  add_unknowns(physics::effect_infos()[physics::effect_index(physics::StrutOffset::name)], set.unknowns);
  for (std::size_t u = 0; u < set.unknowns.size(); ++u) set.columns.push_back(column_of(set.unknowns, u));
  return set;
}

}  // namespace plumbline::diagnose
