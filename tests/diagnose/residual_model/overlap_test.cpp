#include "diagnose/residual_model/overlap.hpp"

#include <cmath>

#include <catch2/catch.hpp>

#include "diagnose/evidence/linear_problem.hpp"
#include "diagnose/usual_noise.hpp"
#include "identify/plans.hpp"

namespace plumbline::diagnose {
namespace {

using identify::SlopeRows;

// How far apart two matrices of one kind are, in units of what the first has on its diagonal.
double apart(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  const Eigen::VectorXd size = a.diagonal().cwiseMax(1e-9 * a.diagonal().maxCoeff()).cwiseSqrt().cwiseInverse();
  return (size.asDiagonal() * (a - b) * size.asDiagonal()).cwiseAbs().maxCoeff();
}

TEST_CASE("by groups of samples, smooth functions have in common what they have by all samples") {
  constexpr int kSamples = 720;
  testing::Random random(5);
  const machine::MachineModel machine = testing::pm600_like();
  const physics::ForceModel forces(machine);
  std::vector<measure::Run> runs = testing::measured(testing::wider_plan(kSamples), forces, 0.5e-6, 0.05, random);
  runs.resize(2);
  const CandidateSet candidates = make_candidate_set(machine, forces);
  const Workbench bench{machine, forces, runs, candidates};
  const identify::NoiseModel noise = testing::usual_noise(0.6);
  const LinearProblem problem = linearise(machine.rotation, runs, candidates, candidates.unknowns.start(), noise);
  const std::vector<ReadyRun> ready = ready_runs(bench, forces, problem);
  for (const Shape& shape : smooth_shapes()) {
    if (shape.coordinates.front() == coordinates::kAx) continue;  // alike at all samples: the set-up takes it out
    // a turn of a strut is a jump, and noise that remembers makes much of it
    const double in_groups_bound = shape.strut_powers[coordinates::kSign - coordinates::kLength] > 0 ? 0.2 : 0.04;
    const Region region = region_of(shape, ready, forces.machine);
    SlopeRows columns = columns_of(shape, region, ready[1], forces.machine);
    const Eigen::Index count = shape.functions();
    if (only_alike(shape)) {
      SlopeRows sum = columns.leftCols(count);
      for (int part = 1; part < shape.parts(); ++part) sum += columns.middleCols(part * count, count);
      columns = sum;
    }
    columns = without_setup(*ready[1].raw, columns, noise);
    const SlopeRows& others = problem.blocks[1].rows;
    const Eigen::VectorXd widths =
        prior_widths(shape, 0.3).replicate(columns.cols() / count, 1);  // of the roughest that are tried
    const Eigen::MatrixXd gram = widths.asDiagonal() * (columns.transpose() * columns) * widths.asDiagonal();
    const Eigen::MatrixXd cross = others.transpose() * columns * widths.asDiagonal();
    for (const auto& [points, bound] : {std::pair{kSamples, 0.02}, std::pair{180, in_groups_bound}}) {
      const Overlap found = overlap_in_groups(shape, region, ready[1], forces.machine, noise,
                                              in_groups(others, kSamples, points), points);
      CAPTURE(static_cast<int>(shape.channel), shape.coordinates, shape.strut_powers, points);
      REQUIRE(found.gram.rows() == columns.cols());
      CHECK(apart(gram, widths.asDiagonal() * found.gram * widths.asDiagonal()) < bound);
      const Eigen::MatrixXd off = cross - found.cross * widths.asDiagonal();
      const double most = (others.colwise().norm().transpose() * gram.diagonal().cwiseSqrt().transpose()).maxCoeff();
      CHECK(off.cwiseAbs().maxCoeff() < bound * most);
    }
  }
}

TEST_CASE("groups of samples keep the size of white noise, and the last may be smaller") {
  SlopeRows rows(10, 1);
  rows << 1, 2, 3, 4, 5, 6, 7, 8, 9, 10;  // of two channels of five samples
  const SlopeRows found = in_groups(rows, 5, 2);
  REQUIRE(found.rows() == 6);
  CHECK(found(0, 0) == Approx(3 / std::sqrt(2.0)));
  CHECK(found(2, 0) == Approx(5));
  CHECK(found(3, 0) == Approx(13 / std::sqrt(2.0)));
  CHECK(in_groups(rows, 5, 5) == rows);
  CHECK(in_groups(rows, 5, 180) == rows);
}

}  // namespace
}  // namespace plumbline::diagnose
