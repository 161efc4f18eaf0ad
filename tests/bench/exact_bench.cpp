// The exact correction and the played machine, for each instruction set of this processor. Items are poses; limits are
// checked along with the correction. scripts/pose_times.py makes a table of it.
#include <benchmark/benchmark.h>

#include "compensate/corrector.hpp"
#include "compensate/exact/pose_batch.hpp"
#include "machine/model_file.hpp"

using namespace plumbline;
using namespace plumbline::compensate;

namespace {

constexpr int kPoses = 2048;

const machine::MachineModel& model() {
  static const machine::MachineModel read =
      machine::read_model(std::string(PLUMBLINE_SOURCE_DIR) + "/models/pm600-like.toml");
  return read;
}

// A smooth path over the middle of the workspace, all six axes moving.
std::vector<Target> path() {
  std::vector<Target> targets;
  for (int i = 0; i < kPoses; ++i) {
    const double t = 0.016 * i;
    targets.push_back({{{120 * std::cos(t), 120 * std::sin(1.3 * t), -1008 + 40 * std::sin(0.37 * t),
                         12 * std::sin(0.7 * t), 10 * std::cos(0.9 * t), 15 * std::sin(0.3 * t)}},
                       {{-120 * std::sin(t), 156 * std::cos(1.3 * t), 14.8 * std::cos(0.37 * t),
                         8.4 * std::cos(0.7 * t), -9 * std::sin(0.9 * t), 4.5 * std::cos(0.3 * t)}},
                       {},
                       3.0});
  }
  return targets;
}

exact::Setup setup_of(const physics::ForceModel& forces) {
  exact::Setup setup;
  setup.environment = forces.environment();
  setup.environment.dynamic = false;
  setup.rotation = model().rotation;
  setup.bounds = exact::sure_bounds(model().limits);
  setup.radius = machine::platform_radius(model().geometry);
  setup.sign_width_of_feed = Settings{}.sign_width_of_feed;
  setup.small_mm = 0.2;
  setup.small_deg = 0.1;
  setup.take_geometry(forces, machine::home_pose(model()));
  return setup;
}

template <class Work>
void in_batch(benchmark::State& state, Work work) {
  const physics::ForceModel forces(model());
  const exact::Setup setup = setup_of(forces);
  exact::PoseBatch batch;
  for (const Target& target : path()) batch.add(target.pose, target.slope, target.bend, *target.seconds);
  for (auto _ : state) work(batch, setup);
  state.SetItemsProcessed(state.iterations() * kPoses);
}

void alone(benchmark::State& state) {
  const Settings settings;
  const Corrector corrector(model(), settings);
  const std::vector<Target> targets = path();
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(corrector.correct(targets[i]));
    i = (i + 1) % targets.size();
  }
  state.SetItemsProcessed(state.iterations());
}

const bool registered = [] {
  for (const exact::InstructionSet& set : exact::instruction_sets()) {
    benchmark::RegisterBenchmark(("correct/" + std::string(set.name)).c_str(), [&set](benchmark::State& state) {
      in_batch(state, [&](exact::PoseBatch& batch, const exact::Setup& setup) { batch.correct(setup, set); });
    });
  }
  for (const exact::InstructionSet& set : exact::instruction_sets()) {
    benchmark::RegisterBenchmark(("play/" + std::string(set.name)).c_str(), [&set](benchmark::State& state) {
      in_batch(state, [&](exact::PoseBatch& batch, const exact::Setup& setup) {
        batch.play(setup, exact::Friction::as_modelled, set);
      });
    });
  }
  return true;
}();

}  // namespace

BENCHMARK(alone);
