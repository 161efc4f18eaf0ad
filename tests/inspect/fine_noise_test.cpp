#include "inspect/fine_noise.hpp"

#include <catch2/catch.hpp>

using namespace plumbline;
using inspect::Fault;
using inspect::FaultKind;
using inspect::FineNoise;

TEST_CASE("noise from sample to sample leaves out what is slow, and is scaled with the readings of another unit") {
  constexpr Eigen::Index samples = 400;
  identify::RunEquations run;
  run.channels = {identify::kRadial};
  run.samples = samples;
  run.residual = Eigen::VectorXd::LinSpaced(samples, -3, 3);
  for (Eigen::Index i = 0; i < samples; ++i) run.residual[i] += i % 2 == 0 ? 0.05 : -0.05;
  identify::NoiseModel noise;
  noise.channels[identify::kRadial].sigma = 0.05;
  const FineNoise fine = inspect::noise_from_sample_to_sample({run}, noise);
  // steps of 0.1: their mean square is twice that of noise of 0.071
  CHECK(fine.square[identify::kRadial] == Approx(2 * samples).epsilon(0.03));
  CHECK(fine.rows[identify::kRadial] == samples);
  CHECK(fine.with_memory() == Approx(FineNoise::kRemembers * fine.square[identify::kRadial]));
  CHECK(fine.expected({}) == fine.square[identify::kRadial]);
  Fault unit{FaultKind::bar_unit, {}};
  unit.channels = {identify::kRadial};
  unit.values = {4};
  CHECK(fine.expected(unit) == Approx(fine.square[identify::kRadial] / 16));
}
