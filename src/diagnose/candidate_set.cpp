#include "diagnose/candidate_set.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "base/check.hpp"
#include "base/diagnostic.hpp"

namespace plumbline::diagnose {
namespace {

using physics::EffectInfo;
using physics::ParameterSpec;

bool is_second_row(std::string_view name) {
  constexpr std::array<std::string_view, 8> kNames{"counterbalance", "lead-error",      "ring-thermal",
                                                   "joint-position", "gimbal-offset",   "screw-roll",
                                                   "spindle-growth", "frame-compliance"};
  return std::find(kNames.begin(), kNames.end(), name) != kNames.end();
}

class Maker {
 public:
  Maker(const machine::MachineModel& machine, const physics::ForceModel& forces, const CandidateSetOptions& options)
      : candidates_{identify::nuisances(machine, forces), 0, {}, {}}, options_(options) {
    candidates_.nuisances = candidates_.unknowns.size();
  }

  CandidateSet run() {
    for (const std::string& name : options_.without) check_known(name);
    for (const EffectInfo& info : physics::effect_infos()) {
      if (!info.base && info.name != "generic") add_unknowns(info);
    }
    for (std::size_t u = 0; u < candidates_.unknowns.size(); ++u) candidates_.columns.push_back(column_of(u));
    for (const EffectInfo& info : physics::effect_infos()) {
      const bool left_out =
          std::find(options_.without.begin(), options_.without.end(), info.name) != options_.without.end();
      if (!info.base && info.name != "generic" && !left_out) add_candidate(info);
    }
    return std::move(candidates_);
  }

 private:
  static void check_known(const std::string& name) {
    const auto names = physics::catalogue_names();
    if (std::find(names.begin(), names.end(), name) != names.end()) return;
    refuse("diagnose-unknown-effect", fmt::format("no effect is called {}", name),
           fmt::format("the catalogue has {}", fmt::join(names, ", ")));
  }

  void add_unknowns(const EffectInfo& info) {
    for (const ParameterSpec& spec : info.parameters) {
      for (int i = 0; i < spec.size(); ++i) {
        if (candidates_.unknowns.find(info.name, spec.key, spec.size() == 1 ? -1 : i) < 0) {
          candidates_.unknowns.add(info.name, spec.key, i);
        }
      }
    }
  }

  Column column_of(std::size_t u) const {
    const identify::Unknown& unknown = candidates_.unknowns[u];
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

  void add_candidate(const EffectInfo& info) {
    Candidate candidate{std::string(info.name), is_second_row(info.name)};
    if (info.name == "screw-stribeck") {
      add_bent(candidate, "force_N", options_.stribeck_speeds_mm_s, machine::units::mm_s.si);
    } else if (info.name == "servo-lag") {
      add_bent(candidate, "lag_ms", options_.lags_ms, machine::units::ms.si);
    } else if (info.name == "cyclic") {
      add_cyclic(candidate);
    } else {
      ActingMode way;
      way.all_or_none = way.sums_to_zero = info.name == "servo-mismatch";
      for (const ParameterSpec& spec : info.parameters) {
        for (int i = 0; i < spec.size(); ++i) {
          const int column = candidates_.unknowns.find(info.name, spec.key, spec.size() == 1 ? -1 : i);
          const bool own = spec.count == 6 && i % spec.each == 0;  // a joint's three numbers belong together
          if (own || way.column_groups.empty()) way.column_groups.emplace_back();
          way.column_groups.back().push_back(column);
        }
      }
      candidate.ways.push_back(way);
    }
    candidates_.all.push_back(candidate);
  }

  // An effect of one size that bends: a way for each setting, with a column of its own.
  void add_bent(Candidate& candidate, const char* size, const std::vector<double>& settings, double unit) {
    const int place = candidates_.unknowns.find(candidate.name, size);
    for (const double setting : settings) {
      Column column = candidates_.columns[static_cast<std::size_t>(place)];
      column.unknown = -1;
      ActingMode way{{{add(column)}}};
      way.setting = setting * unit;
      candidate.ways.push_back(way);
    }
  }

  void add_cyclic(Candidate& candidate) {
    ActingMode way;
    for (int strut = 0; strut < machine::kStruts; ++strut) {
      Column column =
          candidates_.columns[static_cast<std::size_t>(candidates_.unknowns.find("cyclic", "amplitude_um", strut))];
      column.unknown = -1;
      Column cosine = column;
      cosine.key = "cosine";
      const int sine = add(column);
      way.column_groups.push_back({sine, add(cosine)});
    }
    candidate.ways.push_back(way);
  }

  int add(const Column& column) {
    candidates_.columns.push_back(column);
    return static_cast<int>(candidates_.columns.size()) - 1;
  }

  CandidateSet candidates_;
  const CandidateSetOptions& options_;
};

}  // namespace

const Candidate& CandidateSet::candidate(std::string_view name) const {
  const auto found = std::find_if(all.begin(), all.end(), [&](const Candidate& c) { return c.name == name; });
  PLUMBLINE_CHECK(found != all.end());
  return *found;
}

CandidateSet make_candidate_set(const machine::MachineModel& machine, const physics::ForceModel& forces,
                                const CandidateSetOptions& options) {
  return Maker(machine, forces, options).run();
}

}  // namespace plumbline::diagnose
