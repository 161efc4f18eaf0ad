// A plan of circular tests: those that tell most of what is asked for, as a dataset that waits to be measured.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "diagnose/evidence/visible.hpp"
#include "identify/design.hpp"
#include "identify/observability.hpp"
#include "jobs/expected/tip_box.hpp"
#include "measure/dataset.hpp"

namespace plumbline::jobs {

struct PlanJob {
  std::string model;
  std::string measured;           // a dataset that is there already; empty: none
  std::vector<std::string> with;  // further ones of the same machine: jobs/measured/joined.hpp
  /// What is to be determined: tip, alone (how far it may be off over `box`), or groups (geometry, elasticity,
  /// friction, masses, centre-of-mass, level, all) and keys
  /// ("strut.motor_mass_kg", "cyclic.amplitude_um").
  std::vector<std::string> asked{"geometry"};
  std::vector<std::string>
      separate;  // two effects of the catalogue that the plan is to tell apart, in place of `asked`
  TipBoxOptions box;
  identify::CandidateOptions candidates;
  identify::DesignOptions design;
  double radial_noise = 0.5e-6;  // m, 1 sigma of a reading, independent from sample to sample
  double torque_noise = 0.05;    // N m
  std::size_t samples = 120;     // of each run
  double pause = 120;            // s between two runs
};

/// How far the tip may be off over a box, 1 sigma.
struct PlannedTip {
  std::array<machine::Range, 3> box;  // m
  std::vector<double> tilts;          // rad
  std::size_t poses = 0, reached = 0;
  TipOverBox before;
  std::vector<TipOverBox> after;  // each run
};

struct PlannedTests {
  explicit PlannedTests(identify::Unknowns of) : before(of), after(std::move(of)) {}

  measure::Dataset dataset;        // its tables hold what the model predicts
  identify::Fit before, after;     // what is known without the plan and with it: values at their start
  std::vector<std::size_t> asked;  // of the unknowns
  std::vector<double> criterion;   // after each run
  identify::Observability unseen;  // what the plan does not tell
  std::optional<identify::ShownGeometry> geometry;
  std::optional<PlannedTip> tip;
  std::size_t candidates = 0;
  std::vector<double> apart;  // of --separate: smallest distance of each effect from the other, in sigma
  std::vector<diagnose::Visible> could_name;  // by a diagnosis of it and of what was measured already
  std::size_t named_by = 0;                   // how many runs these are
};

/// Refuses what the readers of models and datasets refuse, identify-unknown-key, plan-unknown-effect, what TipBox
/// refuses, and with plan-no-candidates if the machine can make no such circle.
PlannedTests plan_tests(const PlanJob& job);

/// Writes the dataset into a folder, made if need be. Refuses with plan-folder-taken if it holds a dataset already:
/// somebody may have measured it.
void write_plan(const PlannedTests& plan, const std::string& folder);

}  // namespace plumbline::jobs
