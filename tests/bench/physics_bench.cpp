// Kinematics and physics per pose: one at a time, and in packs. Items per second are poses per second.
#include <benchmark/benchmark.h>

#include "machine/forward.hpp"
#include "machine/model_file.hpp"
#include "physics/error.hpp"

using namespace plumbline;
using namespace plumbline::physics;

namespace {

constexpr int kPoses = 256;  // of a circle, visited over and over

const machine::MachineModel& model() {
  static const machine::MachineModel read =
      machine::read_model(std::string(PLUMBLINE_SOURCE_DIR) + "/models/pm600-like.toml");
  return read;
}

template <class T>
constexpr int lanes() {
  if constexpr (kIsPack<T>) {
    return T::size();
  } else {
    return 1;
  }
}

// Points of a tilted circle at 1 m/min, one after the other; a pack holds as many neighbours as it has lanes.
template <class T>
std::vector<Motion<T>> circle() {
  const machine::RotationOrder order;
  std::vector<Motion<T>> motions(kPoses / lanes<T>());
  for (int n = 0; n < kPoses; ++n) {
    const double angle = 2 * std::numbers::pi * n / kPoses;
    const Vector3<double> outward(std::cos(angle), std::sin(angle), 0);
    const Vector3<double> x = Vector3<double>(0, 0.1, -1.008) + 0.144 * outward;
    const Vector3<double> v = 1000 * kMmPerMin * Vector3<double>(-outward.y(), outward.x(), 0);
    const Matrix3<double> R = machine::rotation<double>(order, {-20 * kDeg, 0, 0});
    Motion<T>& motion = motions[static_cast<std::size_t>(n / lanes<T>())];
    motion.pose.R_WP = R.cast<T>();
    for (int a = 0; a < 3; ++a) {
      if constexpr (kIsPack<T>) {
        motion.pose.p_WT[a].set(n % T::size(), x[a]);
        motion.twist.v_WT[a].set(n % T::size(), v[a]);
      } else {
        motion.pose.p_WT[a] = x[a];
        motion.twist.v_WT[a] = v[a];
      }
    }
  }
  return motions;
}

// Runs `work` on one motion after the other.
template <class T, class Work>
void run(benchmark::State& state, Work work) {
  const std::vector<Motion<T>> motions = circle<T>();
  std::size_t n = 0;
  for ([[maybe_unused]] auto _ : state) {
    auto result = work(motions[n]);
    benchmark::DoNotOptimize(result);
    n = n + 1 == motions.size() ? 0 : n + 1;
  }
  state.SetItemsProcessed(state.iterations() * lanes<T>());
}

template <class T>
void inverse(benchmark::State& state) {
  run<T>(state, [](const Motion<T>& motion) { return machine::strut_geometry(model().geometry, motion.pose); });
}

template <class T>
void factorise(benchmark::State& state) {
  run<T>(state, [](const Motion<T>& motion) {
    return machine::Lu6<T>(machine::jacobian(machine::strut_geometry(model().geometry, motion.pose)));
  });
}

template <class T>
void loads(benchmark::State& state) {
  const ForceModel forces(model());
  const std::vector<Parameter<T>> parameters = parameters_as<T>(forces);
  const Environment environment = forces.environment();
  run<T>(state, [&](const Motion<T>& motion) {
    return strut_stretch(forces, parameters.data(), environment, motion).stretch;
  });
}

// The closed form of a compensated pose: one inverse, one load case, one forward solution.
template <class T>
void compensated_pose(benchmark::State& state) {
  const ForceModel forces(model());
  const std::vector<Parameter<T>> parameters = parameters_as<T>(forces);
  const Environment environment = forces.environment();
  run<T>(state, [&](const Motion<T>& motion) {
    const StrutStretch<T> s = strut_stretch(forces, parameters.data(), environment, motion);
    return machine::forward_near<T>(forces.machine.geometry, motion.pose, s.struts, s.jacobian, -s.stretch).pose;
  });
}

template <class T>
void exact_error(benchmark::State& state) {
  const ForceModel forces(model());
  const std::vector<Parameter<T>> parameters = parameters_as<T>(forces);
  const Environment environment = forces.environment();
  run<T>(state, [&](const Motion<T>& motion) {
    return tip_error(forces, parameters.data(), environment, motion).displacement;
  });
}

void forward_cold(benchmark::State& state) {
  const Pose<double> home = machine::home_pose(model());
  run<double>(state, [&](const Motion<double>& motion) {
    return machine::forward(model().geometry, machine::strut_lengths(model().geometry, motion.pose), home);
  });
}

template <class T>
void forward_warm(benchmark::State& state) {
  machine::PerStrut<double> change;
  change << 30e-6, -20e-6, 25e-6, -5e-6, 11e-6, 40e-6;
  run<T>(state, [&](const Motion<T>& motion) {
    const machine::StrutGeometry<T> struts = machine::strut_geometry(model().geometry, motion.pose);
    const machine::Lu6<T> lu(machine::jacobian(struts));
    return machine::forward_near<T>(model().geometry, motion.pose, struts, lu, change.cast<T>());
  });
}

BENCHMARK(inverse<double>);
BENCHMARK(inverse<Pack>);
BENCHMARK(factorise<double>);
BENCHMARK(factorise<Pack>);
BENCHMARK(loads<double>);
BENCHMARK(loads<Pack>);
BENCHMARK(forward_cold);
BENCHMARK(forward_warm<double>);
BENCHMARK(forward_warm<Pack>);
BENCHMARK(compensated_pose<double>);
BENCHMARK(compensated_pose<Pack>);
BENCHMARK(exact_error<double>);
BENCHMARK(exact_error<Pack>);

}  // namespace
