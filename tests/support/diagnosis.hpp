// A diagnosis made by hand, for tests of what is written of it.
#pragma once

#include "diagnose/diagnose.hpp"
#include "machine/model_file.hpp"
#include "support/scratch.hpp"

namespace plumbline::testing {

/// One effect found on two runs, the second left out: bar readings and torques.
inline diagnose::Diagnosis small_diagnosis() {
  diagnose::Diagnosis d(physics::ForceModel(machine::read_model(source_file("models/pm600-like.toml"))));
  d.verdict = diagnose::Verdict::named;
  d.effects.push_back({"backlash", {"cyclic"}, {{"width_um", "um", {4.1, 0}, {0.1, 0}, 1, false}}, 50});
  d.confidence_set = {"backlash", "cyclic"};
  d.evidence = {{"backlash", 50}, {"cyclic", 48}, {"cable", -1}};
  d.threshold = 9.5;
  d.noise.channels[identify::kRadial] = {0.5e-6, 0.3, 120, 0};
  d.noise.channels[1] = {0.05, 0.3, 120, 0};
  d.fit = {{3.1e-6, 0.06}, {}, {0.6e-6, 0.05}};
  d.held_out = {{3.0e-6, 0.06}, {}, {0.7e-6, 0.05}};
  for (const char* const id : {"first", "<last> & \"best\""}) {
    diagnose::RunGap run;
    run.id = id;
    run.held_out = run.id != "first";
    run.channels = {{identify::kRadial, 3.1e-6, 0, 0.6e-6}, {1, 0.06, 0, 0.05}};
    run.angle = Eigen::VectorXd::LinSpaced(4, 0, 3);
    run.radial_before = Eigen::VectorXd::Constant(4, 3e-6);
    run.radial_after = Eigen::VectorXd::Constant(4, 0.5e-6);
    d.runs.push_back(run);
  }
  d.runs[0].circularity = diagnose::Circularity{20e-6, 9e-6, 4e-6};
  d.evidence[0].left_out = diagnose::LeftOut{31.5, 33.5};
  diagnose::ChannelResiduals bar{identify::kRadial, 3.1e-6};
  bar.arcs[3] = 5e-6;
  bar.waves[1] = 1e-6;
  bar.wave_noise.fill(0.1e-6);
  d.gap_map.channels = {bar};
  d.gap_map.contrasts = {{diagnose::Difference::direction, 2, {0.5e-6, 0.05}, {2e-6, 0.1}}};
  d.gap_map.groups = {{diagnose::Grouping::tilt, 0, 5, 2, {3.1e-6, 0.06}}};
  d.gap_map.reversals = {{0, 6, 4e-6, 0.5e-6, 0, 0}};
  return d;
}

}  // namespace plumbline::testing
