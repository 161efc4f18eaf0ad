// What the columns of one run are made from.
#pragma once

#include "diagnose/candidates/candidate_set.hpp"
#include "diagnose/readings/sample_states.hpp"
#include "identify/equations/run_model.hpp"
#include "physics/bend.hpp"

namespace plumbline::diagnose {

struct RunColumns {
  const CandidateSet& candidates;
  const physics::MachineConstants& machine;
  const std::vector<SampleState>& states;
  const identify::RunEquations& equations;

  /// How all readings move with a number of an effect.
  auto slope(std::string_view effect, std::string_view key, int index) const {
    return equations.slopes.col(candidates.unknowns.find(effect, key, index));
  }
  /// SI per unit of the linear problem.
  double scale(int column) const { return candidates.columns[static_cast<std::size_t>(column)].scale; }

  /// of(what a strut does) at each sample, the same for each channel.
  template <class Of>
  Eigen::VectorXd each_sample(int strut, Of&& of) const {
    Eigen::VectorXd values(static_cast<Eigen::Index>(states.size()));
    for (std::size_t i = 0; i < states.size(); ++i) {
      const SampleState& s = states[i];
      const double length = s.struts.length[strut];
      values[static_cast<Eigen::Index>(i)] = of(physics::StrutMoment{length, s.speed[strut], s.acceleration[strut],
                                                                     machine.radians_per_length(strut) * length});
    }
    return values.replicate(static_cast<Eigen::Index>(equations.channels.size()), 1);
  }

  /// All columns in units of the linear problem, and the residual last.
  identify::SlopeRows all() const;
};

}  // namespace plumbline::diagnose
