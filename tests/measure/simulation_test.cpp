#include "measure/simulation.hpp"

#include <catch2/catch.hpp>
#include <ceres/jet.h>

#include "machine/machines.hpp"
#include "measure/circularity.hpp"
#include "measure/runs.hpp"

using namespace plumbline;
using namespace plumbline::measure;
using namespace plumbline::testing;

TEST_CASE("the commanded motion is one turn at constant feed") {
  for (const Direction direction : {Direction::ccw, Direction::cw}) {
    const machine::MachineModel machine = pm600_like();
    Run run = circle_run({10, 20, -1000}, {5, -3, 2}, direction, 3600);
    run.start = 100;
    const auto before = circular_motion(machine.rotation, run, 799);
    const auto here = circular_motion(machine.rotation, run, 800);
    const auto after = circular_motion(machine.rotation, run, 801);
    const double dt = after.time - before.time;
    CHECK(here.time == Approx(100 + 80 * kDeg * 0.144 * 60));
    CHECK(here.twist.v_WT.norm() == Approx(run.feed));
    CHECK(((after.pose.p_WT - before.pose.p_WT) / dt).isApprox(here.twist.v_WT, 1e-5));
    CHECK(((after.twist.v_WT - before.twist.v_WT) / dt).isApprox(here.acceleration.v_WT, 1e-5));
    CHECK(here.pose.R_WP == machine::rotation<double>(machine.rotation, run.tilt));
    CHECK(circular_motion(machine.rotation, run, 0).pose.p_WT.isApprox(run.centre_W + Vector3<double>(0.144, 0, 0)));
  }
}

TEST_CASE("the bar is inclined when it is longer than the radius") {
  Run run = circle_run({0, 100, -1008}, {0, 0, 0});
  CHECK(ideal_ball(run).isApprox(Vector3<double>(0, 0.1, -1.05), 1e-12));  // sqrt(150^2 - 144^2) = 42
  run.bar.reset();
  CHECK(ideal_ball(run) == run.centre_W);
}

TEST_CASE("the circularities of an independent program come out of simulated runs") {
  const machine::MachineModel machine = pm600_like();
  const physics::ForceModel forces(machine);
  struct Case {
    Vector3<double> centre, tilt;
    double circularity_um, margin_um;
  };
  const std::vector<Case> cases{{{0, 100, -1008}, {-25, 0, 0}, 208, 2}, {{0, 100, -1008}, {-23, 0, 0}, 126, 2},
                                {{0, 100, -1008}, {-20, 0, 0}, 71, 1},  {{0, 100, -1008}, {-10, 0, 0}, 20, 1},
                                {{0, 100, -1008}, {0, 0, 0}, 8.4, 1},   {{0, 100, -1008}, {10, 0, 0}, 8.8, 1},
                                {{0, 100, -1008}, {20, 0, 0}, 15.0, 1}, {{-70, -70, -1008}, {-17, -17, 0}, 123, 2}};
  Dataset dataset;
  for (const Case& test : cases) dataset.runs.push_back(circle_run(test.centre, test.tilt, Direction::ccw, 720));
  dataset = simulated(machine, forces, dataset);
  for (std::size_t i = 0; i < cases.size(); ++i) {
    INFO("run " << i);
    const CircularityFigures figures = circularity_figures(profile_of(dataset.runs[i]));
    CHECK(figures.least_squares / kUm == Approx(cases[i].circularity_um).margin(cases[i].margin_um).epsilon(0));
    CHECK(figures.minimum_zone <= figures.least_squares);
    CHECK(figures.minimum_zone > 0.8 * figures.least_squares);
  }
}

TEST_CASE("a known payload, the direction and the time change a run") {
  const machine::MachineModel machine = pm600_like();
  physics::ForceModel forces(machine);
  const Run run = circle_run({0, 100, -1008}, {-20, 0, 0});
  const auto mean_torque = [&](const Run& r) {
    double sum = 0;
    for (const auto& sample : simulate_run(machine, forces, r).samples) sum += sample.torque.sum();
    return sum / static_cast<double>(r.samples());
  };
  Run loaded = run;
  loaded.payload_mass = 20;
  CHECK(mean_torque(loaded) > mean_torque(run) + 0.3);  // N m
  const Run cw = circle_run({0, 100, -1008}, {-20, 0, 0}, Direction::cw);
  const RunSimulation there = simulate_run(machine, forces, run);
  const RunSimulation back = simulate_run(machine, forces, cw);
  // at the same place 120 - i: friction, twice
  CHECK((there.samples[30].torque - back.samples[90].torque).cwiseAbs().maxCoeff() > 0.5);
  forces.parameters[static_cast<std::size_t>(forces.add("thermal-drift"))] = 1 / 3600.0;  // strut 1, 1 K/h
  Run later = run;
  later.start = 3600;
  const Vector3<double> moved =
      simulate_run(machine, forces, later).samples[30].tip_W - simulate_run(machine, forces, run).samples[30].tip_W;
  CHECK(moved.norm() > 2 * kUm);  // 11.5 um/K on a metre
}

TEST_CASE("a sample's derivative by a parameter equals the finite difference") {
  using Jet = ceres::Jet<double, 1>;
  const machine::MachineModel machine = pm600_like();
  physics::ForceModel forces(machine);
  const Run run = circle_run({0, 100, -1008}, {-22, 0, 0});
  const physics::Environment environment = environment_of(forces, run);
  const auto mass = static_cast<std::size_t>(forces.find("platform-gravity", "mass_kg"));
  std::vector<Jet> jets = physics::parameters_as<Jet>(forces);
  jets[mass].v[0] = 1;
  const auto motion = circular_motion(machine.rotation, run, 17);
  const auto by_jet = simulate_sample(forces, jets.data(), environment, motion);
  const Vector3<Jet> ball = ideal_ball(run).cast<Jet>();
  const Jet reading = bar_reading<Jet>(by_jet.tip_W, ball, Jet(0.15));
  const auto reading_with = [&](double more) {
    std::vector<double> p = forces.parameters;
    p[mass] += more;
    return bar_reading<double>(simulate_sample(forces, p.data(), environment, motion).tip_W, ideal_ball(run), 0.15);
  };
  CHECK(reading.v[0] == Approx((reading_with(0.01) - reading_with(-0.01)) / 0.02).epsilon(1e-5));
}

TEST_CASE("a run that the machine cannot make is refused by its name") {
  const machine::MachineModel machine = pm600_like();
  physics::ForceModel forces(machine);
  forces.parameters[static_cast<std::size_t>(forces.find("platform-gravity", "mass_kg"))] = 1e8;
  Run run = circle_run({0, 100, -1008}, {-20, 0, 0});
  run.id = "sunk";
  run.place.file = "dataset.toml";
  try {
    simulate_run(machine, forces, run);
    FAIL_CHECK("was not refused");
  } catch (const Refusal& refusal) {
    CHECK(refusal.diagnostic().code == "simulate-unreachable");
    CHECK(refusal.diagnostic().message.find("sunk") != std::string::npos);
    CHECK(refusal.diagnostic().place.file == "dataset.toml");
  }
}
