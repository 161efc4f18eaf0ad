#include "jobs/plan.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <map>
#include <numbers>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "base/diagnostic.hpp"
#include "base/files/path_of.hpp"
#include "base/parallel.hpp"
#include "base/text/nearest_name.hpp"
#include "identify/unknowns/geometry.hpp"
#include "identify/unknowns/named_keys.hpp"
#include "jobs/could_name.hpp"
#include "jobs/measured/joined.hpp"
#include "machine/model_file.hpp"
#include "measure/dataset_text.hpp"
#include "measure/planned_run.hpp"
#include "measure/run_table.hpp"
#include "measure/simulation.hpp"

namespace plumbline::jobs {
namespace {

using identify::Fit;
using identify::Unknowns;

// --- what is asked for ---

using Places = std::vector<std::size_t>;

constexpr std::string_view kTip = "tip";

// What people ask for together, by the keys of [uncertainty] that say how well it is known.
const std::map<std::string, std::vector<std::string>>& groups() {
  static const std::map<std::string, std::vector<std::string>> all{
      {"geometry", {"strut_offset_um", "joint_position_um"}},
      {"elasticity", {"compliance_relative"}},
      {"friction", {"coulomb_friction_N"}},
      {"masses", {"platform_mass_kg", "strut_mass_kg", "motor_mass_kg"}},
      {"centre-of-mass", {"centre_of_mass_mm"}},
      {"level", {"level_mrad"}}};
  return all;
}

void add(Places& places, const Places& more) {
  for (const std::size_t place : more) {
    if (std::find(places.begin(), places.end(), place) == places.end()) places.push_back(place);
  }
}

Places asked_for(Unknowns& unknowns, const std::vector<std::string>& names) {
  Places places;
  for (const std::string& name : names) {
    if (name == "all") {
      for (std::size_t i = 0; i < unknowns.size(); ++i) add(places, {i});
      continue;
    }
    const auto group = groups().find(name);
    if (group == groups().end()) {
      add(places, identify::named_unknowns(unknowns, name));
    } else {
      for (const std::string& uncertainty : group->second) {
        for (const std::string& key : identify::names_known_by(uncertainty)) {
          add(places, identify::named_unknowns(unknowns, key));
        }
      }
    }
  }
  return places;
}

// The numbers of an effect that is to be separated from another one; nothing is known of it beforehand, even if
// [uncertainty] lists it.
Places effect_numbers(Unknowns& unknowns, const std::string& name) {
  const std::vector<std::string_view> known = physics::cause_names();
  if (std::find(known.begin(), known.end(), name) == known.end()) {
    refuse("plan-unknown-effect", fmt::format("no effect is called {}", name), suggestion(name, known));
  }
  if (unknowns.of_effect(name).empty()) unknowns.add_effect(name);
  Places places = unknowns.of_effect(name);
  for (const std::size_t place : places) unknowns.set_free(place);
  return places;
}

// --- what plans are made of ---

identify::NoiseModel noise_of(const PlanJob& job) {
  identify::NoiseModel noise;
  for (int c = 0; c < identify::kChannels; ++c) {
    noise.channels[static_cast<std::size_t>(c)].sigma = c == identify::kRadial ? job.radial_noise : job.torque_noise;
  }
  return noise;
}

std::vector<Eigen::MatrixXd> informations(const machine::MachineModel& machine, const std::vector<measure::Run>& runs,
                                          const Unknowns& unknowns, const identify::NoiseModel& noise) {
  std::vector<Eigen::MatrixXd> all(runs.size());
  for_each_index(runs.size(),
                 [&](std::size_t i) { all[i] = run_information(machine.rotation, runs[i], unknowns, noise); });
  return all;
}

std::vector<measure::Run> measured_already(const PlanJob& job) {
  if (job.measured.empty()) return {};
  return read_joined(job.measured, job.with).dataset.runs;
}

Eigen::MatrixXd known_already(const machine::MachineModel& machine, const std::vector<measure::Run>& measured,
                              const Unknowns& unknowns, const identify::NoiseModel& noise) {
  const auto size = static_cast<Eigen::Index>(unknowns.size());
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(size, size);
  for (const Eigen::MatrixXd& one : informations(machine, measured, unknowns, noise)) sum += one;
  return sum;
}

void fill(Fit& fit, const Eigen::MatrixXd& information) {
  fit.values = fit.unknowns.start();
  fit.information = information;
  fit.covariance = identify::posterior_covariance(fit.unknowns, information);
  fit.converged = true;
}

// --- the plan as a dataset ---

std::vector<measure::TableColumn> columns_of(const PlanJob& job) {
  using measure::Column;
  std::vector<measure::TableColumn> columns{{Column::time, 4}, {Column::angle, 4}};
  if (job.candidates.bar_readings) columns.push_back({Column::radial, 4});
  for (int j = 0; job.candidates.torques && j < machine::kStruts; ++j) {
    columns.push_back({static_cast<Column>(static_cast<int>(Column::torque1) + j), 5});
  }
  return columns;
}

measure::Dataset dataset_of(const machine::MachineModel& machine, const PlanJob& job, std::vector<measure::Run> runs) {
  measure::Dataset dataset;
  dataset.machine = machine.name;
  double now = 0;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    measure::Run& run = runs[i];
    run.id = fmt::format("{:02}-{}", i + 1, to_text(run.direction));
    run.file = run.id + ".csv";
    run.start = std::round(now);
    now += 2 * std::numbers::pi * run.radius / run.feed + job.pause;
    run.columns = columns_of(job);
    measure::lay_samples(run, job.samples, job.candidates.bar_readings, job.candidates.torques);
  }
  dataset.runs = std::move(runs);
  dataset = measure::simulated(machine, physics::ForceModel(machine), std::move(dataset));
  for (measure::Run& run : dataset.runs) run.planned = measure::table_hash(measure::run_table_text(run));
  dataset.document = parse_toml(
      fmt::format("# A plan by plumbline. Its tables hold what the model {} predicts, until they are measured.\n{}",
                  machine.name, measure::dataset_text(dataset)),
      "");
  return dataset;
}

// What the plan is for.
struct Aim {
  Unknowns unknowns;
  Places asked, other;  // other: of the second effect to be separated
  std::optional<TipBox> box;
};

bool asks_for(const PlanJob& job, std::string_view name) {
  return job.separate.empty() && std::find(job.asked.begin(), job.asked.end(), name) != job.asked.end();
}

Aim aim_of(const machine::MachineModel& machine, const PlanJob& job) {
  const physics::ForceModel forces(machine);
  const bool tip = asks_for(job, kTip);
  const bool geometry = tip || asks_for(job, "geometry");
  Aim aim{geometry ? identify::geometry_unknowns(machine, forces) : identify::nuisances(machine, forces), {}, {}, {}};
  if (tip) {
    aim.asked = asked_for(aim.unknowns, {"all"});
    aim.box.emplace(machine, aim.unknowns, job.box);
  } else if (job.separate.empty()) {
    aim.asked = asked_for(aim.unknowns, job.asked);
  } else {
    aim.asked = effect_numbers(aim.unknowns, job.separate.at(0));
    aim.other = effect_numbers(aim.unknowns, job.separate.at(1));
  }
  return aim;
}

identify::Criterion criterion_of(const Aim& aim) {
  if (aim.box) {
    return identify::v_optimal(aim.unknowns, {aim.box->mean_square(), aim.box->mean_square_touched_off()});
  }
  return aim.other.empty() ? identify::d_optimal(aim.unknowns, aim.asked)
                           : identify::separating(aim.unknowns, aim.asked, aim.other);
}

// Run by run, as the design adds them.
PlannedTip planned_tip(const Aim& aim, const PlanJob& job, const std::vector<Eigen::MatrixXd>& information,
                       Eigen::MatrixXd known, const identify::Design& design, double weight) {
  const auto now = [&] { return aim.box->with(identify::posterior_covariance(aim.unknowns, known)); };
  PlannedTip tip{aim.box->box(), job.box.tilts, aim.box->poses(), aim.box->reached(), now(), {}};
  for (const std::size_t chosen : design.chosen) {
    known += weight * information[chosen];
    tip.after.push_back(now());
  }
  return tip;
}

}  // namespace

PlannedTests plan_tests(const PlanJob& job) {
  const machine::MachineModel machine = machine::read_model(job.model);
  const Aim aim = aim_of(machine, job);
  const std::vector<measure::Run> candidates = identify::candidate_runs(machine, job.candidates);
  if (candidates.empty()) {
    refuse("plan-no-candidates", "the machine can make no such circle within its limits and away from singularities",
           "choose a smaller --radius, or look at [limits] of the model", {machine.document.file});
  }
  const identify::NoiseModel noise = noise_of(job);
  const std::vector<Eigen::MatrixXd> information = informations(machine, candidates, aim.unknowns, noise);
  std::vector<measure::Run> measured = measured_already(job);
  const Eigen::MatrixXd known = known_already(machine, measured, aim.unknowns, noise);
  identify::DesignOptions options = job.design;
  options.readings_per_sample = static_cast<double>(job.samples) / static_cast<double>(job.candidates.samples);
  const identify::Design design = identify::design(information, known, criterion_of(aim), options);

  PlannedTests plan(aim.unknowns);
  fill(plan.before, known);
  fill(plan.after, design.information);
  std::vector<measure::Run> runs;
  for (const std::size_t chosen : design.chosen) runs.push_back(candidates[chosen]);
  plan.dataset = dataset_of(machine, job, std::move(runs));
  plan.candidates = candidates.size();
  plan.criterion = design.criterion;
  if (aim.box) plan.tip = planned_tip(aim, job, information, known, design, options.readings_per_sample);
  plan.asked = aim.asked;
  plan.asked.insert(plan.asked.end(), aim.other.begin(), aim.other.end());
  if (!job.separate.empty()) {
    for (const auto& [these, those] : {std::pair(aim.asked, aim.other), std::pair(aim.other, aim.asked)}) {
      plan.apart.push_back(std::sqrt(identify::noncentrality(aim.unknowns, design.information, these, those)));
    }
  }
  std::vector<measure::Run> all = plan.dataset.runs;
  std::move(measured.begin(), measured.end(), std::back_inserter(all));
  plan.could_name = could_name(machine, all, noise);
  plan.named_by = all.size();
  plan.unseen = identify::observability(plan.after, plan.dataset.runs);
  plan.geometry = identify::shown_geometry(machine.geometry, aim.unknowns, plan.after.covariance);
  return plan;
}

void write_plan(const PlannedTests& plan, const std::string& folder) {
  const std::filesystem::path taken = path_of(folder) / "dataset.toml";
  std::error_code ignored;
  if (std::filesystem::exists(taken, ignored)) {
    refuse("plan-folder-taken", fmt::format("there is a dataset in {} already", folder),
           "it may have been measured: name another folder with -o", {taken.generic_string()});
  }
  measure::write_dataset(plan.dataset, folder);
}

}  // namespace plumbline::jobs
