// Where model and measurements disagree: residuals cut in the ways in which effects show.
#pragma once

#include "diagnose/gap/channels.hpp"
#include "diagnose/gap/contrasts.hpp"
#include "diagnose/gap/groups.hpp"
#include "diagnose/gap/reversals.hpp"
#include "physics/force_model.hpp"

namespace plumbline::diagnose {

struct GapMap {
  std::vector<ChannelResiduals> channels;
  std::vector<Contrast> contrasts;
  std::vector<RunGroup> groups;
  std::vector<Reversal> reversals;
};

struct GapMapOptions {
  GroupOptions groups;
  ReversalOptions reversals;
};

/// `residuals` are those of `runs` (all of them) beside `forces`, the set-ups fitted.
GapMap gap_map_of(const machine::RotationOrder& order, const std::vector<measure::Run>& runs,
                  const physics::ForceModel& forces, const std::vector<identify::RunEquations>& residuals,
                  const identify::NoiseModel& noise, const GapMapOptions& options = {});

}  // namespace plumbline::diagnose
