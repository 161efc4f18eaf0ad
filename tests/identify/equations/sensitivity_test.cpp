// Derivatives of readings against finite differences of simulated ones.
#include "identify/equations/sensitivity.hpp"

#include <catch2/catch.hpp>

#include "machine/machines.hpp"
#include "measure/runs.hpp"
#include "measure/simulation.hpp"

using namespace plumbline;
using namespace plumbline::identify;
using namespace plumbline::testing;

namespace {

using Outcome = Eigen::Matrix<double, kOutcomes, 1>;

struct Bench {
  measure::Run run = circle_run({-40, 60, -1008}, {-12, 7, 3});
  physics::Motion<double> motion;

  Bench() {
    run.payload_mass = 7;
    run.start = 900;
    motion = measure::circular_motion(pm600_like().rotation, run, 17);
  }
  physics::TipError<double> error(const physics::ForceModel& forces) const {
    return physics::tip_error(forces, measure::environment_of(forces, run), motion, {.tolerance_m = 1e-14});
  }
  // What changes from one model to the other.
  Outcome change(const physics::ForceModel& from, const physics::ForceModel& to) const {
    const physics::TipError<double> a = error(from);
    const physics::TipError<double> b = error(to);
    const Vector3<double> turn = machine::logarithm<double>(b.pose.R_WP * a.pose.R_WP.transpose());
    return (Outcome() << b.pose.p_WT - a.pose.p_WT, b.loads.torque - a.loads.torque, turn).finished();
  }
};

// um, mN m and urad: what a difference of one means is then alike.
Outcome scaled(const Outcome& outcome) {
  return (Outcome() << outcome.segment<3>(kTipRow) * 1e6, outcome.segment<6>(kTorqueRow) * 1e3,
          outcome.segment<3>(kTurnRow) * 1e6)
      .finished();
}

// An ordinary value of each unknown: some scales of it away from where it starts.
Eigen::VectorXd ordinary(const Unknowns& unknowns, Random& random) {
  Eigen::VectorXd values = unknowns.start();
  for (std::size_t i = 0; i < unknowns.size(); ++i) {
    const Unknown& u = unknowns[i];
    const double away = u.start != 0 ? 0.1 : uniform(random, 0.5, 3);
    values[static_cast<Eigen::Index>(i)] = u.start + away * u.scale;
  }
  return values;
}

void check_slopes(const Unknowns& unknowns, const Eigen::VectorXd& values) {
  const Bench bench;
  const physics::ForceModel forces = unknowns.at(values);
  const Sensitivity sensitivity(forces, unknowns);
  Slopes slopes(kOutcomes, static_cast<Eigen::Index>(unknowns.size()));
  sensitivity.at(measure::environment_of(forces, bench.run), bench.motion, bench.error(forces), slopes);
  for (std::size_t i = 0; i < unknowns.size(); ++i) {
    const auto column = static_cast<Eigen::Index>(i);
    INFO(unknowns[i].label);
    const double h = 1e-4 * unknowns[i].scale;
    Eigen::VectorXd beside = values;
    beside[column] -= h;
    const physics::ForceModel before = unknowns.at(beside);
    beside[column] += 2 * h;
    const physics::ForceModel later = unknowns.at(beside);
    // over one scale of the unknown, so that the margin is in um and mN m
    const Outcome finite = scaled(bench.change(before, later)) / (2e-4);
    const Outcome exact = scaled(slopes.col(column)) * unknowns[i].scale;
    const Outcome off = (finite - exact).cwiseAbs();
    CHECK(off.head<kTurnRow>().maxCoeff() <= 2e-5 + 1e-6 * finite.head<kTurnRow>().cwiseAbs().maxCoeff());
    // to first order of how far the platform is turned: some 1e-4
    CHECK(off.segment<3>(kTurnRow).maxCoeff() <= 2e-5 + 1e-3 * finite.segment<3>(kTurnRow).cwiseAbs().maxCoeff());
    CHECK(exact.cwiseAbs().maxCoeff() > 0);
  }
}

}  // namespace

TEST_CASE("the readings' derivatives by each nuisance equal finite differences through the fixed point") {
  Random random(31);
  const machine::MachineModel machine = pm600_like();
  const Unknowns unknowns = nuisances(machine, physics::ForceModel(machine));
  CHECK(unknowns.size() == 2 + 6 + 3 + 2 + 6 + 36);
  check_slopes(unknowns, unknowns.start());
  check_slopes(unknowns, ordinary(unknowns, random));
}

TEST_CASE("the readings' derivatives by each parameter of each effect equal finite differences") {
  Random random(32);
  const machine::MachineModel machine = pm600_like();
  for (const physics::EffectInfo& info : physics::effect_infos()) {
    INFO(info.name);
    if (info.description) continue;  // silent without settings: the next tests
    Unknowns unknowns{physics::ForceModel(machine)};
    unknowns.add_effect(info.name);
    if (unknowns.size() > 0) check_slopes(unknowns, ordinary(unknowns, random));
  }
}

TEST_CASE("the readings' derivatives by a generic term equal finite differences") {
  Random random(34);
  physics::ForceModel forces(pm600_like());
  forces.add("generic");
  const int powers = forces.find("generic", "strut_powers");
  for (const int power : {0, 3}) forces.parameters[static_cast<std::size_t>(powers + power)] = 1;
  forces.parameters[static_cast<std::size_t>(forces.find("generic", "shared_powers") + 1)] = 2;
  Unknowns unknowns(forces);
  for (const char* key : {"length_um", "drive_N", "torque_Nm", "tip_um"}) unknowns.add("generic", key, 2);
  Eigen::VectorXd values(4);
  values << 2e-6, 3, 0.01, 3e-6;
  check_slopes(unknowns, values);
}

TEST_CASE("the readings' derivatives by the weights of a residual function equal finite differences") {
  Random random(35);
  physics::ForceModel forces(pm600_like());
  forces.add("residual");
  const int first = forces.add("residual");
  const auto set = [&](int offset, double value) {
    forces.parameters[static_cast<std::size_t>(first + offset)] = value;
  };
  set(physics::Residual::kCoordinate, 10);  // the tension
  set(physics::Residual::kPart, 3);
  Unknowns unknowns(forces);
  for (const char* key : {"length_um", "drive_N", "torque_Nm"}) unknowns.add("residual", key, 1, 1);
  Eigen::VectorXd values(3);
  values << 2e-6, 3, 0.01;
  check_slopes(unknowns, values);
  CHECK(unknowns[0].label == "residual length_um 2, row 2");
}

TEST_CASE("derivatives hold with all effects acting at once") {
  Random random(33);
  const machine::MachineModel machine = pm600_like();
  Unknowns unknowns = nuisances(machine, physics::ForceModel(machine));
  for (const std::string_view name : physics::catalogue_names()) {
    const bool description = physics::effect_infos()[physics::effect_index(name)].description;
    if (unknowns.of_effect(name).empty() && !description) unknowns.add_effect(name);
  }
  check_slopes(unknowns, 0.5 * (unknowns.start() + ordinary(unknowns, random)));
}
