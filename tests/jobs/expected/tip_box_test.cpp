#include "jobs/expected/tip_box.hpp"

#include <cmath>
#include <limits>

#include <catch2/catch.hpp>

#include "base/units.hpp"
#include "identify/unknowns/geometry.hpp"
#include "jobs/workspace_map.hpp"
#include "machine/machines.hpp"
#include "support/scratch.hpp"

using namespace plumbline;
using namespace plumbline::testing;

namespace {

const machine::MachineModel kMachine = pm600_like();
const identify::Unknowns kUnknowns = identify::nuisances(kMachine, physics::ForceModel(kMachine));

Eigen::MatrixXd prior() {
  Eigen::VectorXd variances(static_cast<Eigen::Index>(kUnknowns.size()));
  for (std::size_t i = 0; i < kUnknowns.size(); ++i)
    variances[static_cast<Eigen::Index>(i)] = kUnknowns[i].sigma * kUnknowns[i].sigma;
  return variances.asDiagonal();
}

jobs::TipBoxOptions box_mm(double x0, double x1, double y0, double y1, double z0, double z1) {
  jobs::TipBoxOptions options;
  options.box = {machine::Range{x0 * kMm, x1 * kMm}, machine::Range{y0 * kMm, y1 * kMm},
                 machine::Range{z0 * kMm, z1 * kMm}};
  return options;
}

}  // namespace

TEST_CASE("the tip over a box is as uncertain as a map has it") {
  jobs::TipBoxOptions options = box_mm(-100, 100, -80, 120, -1100, -900);
  options.points = 3;
  options.tilts = {0, 10 * kDeg};
  const jobs::TipBox box(kMachine, kUnknowns, options);
  CHECK(box.poses() == 27 * 5);
  const jobs::TipOverBox over = box.with(prior());

  jobs::MapOptions as_map;
  as_map.box = options.box;
  as_map.step = 100 * kMm;
  for (const auto& [axis, angle] : {std::pair(Axis::A, 10.0), {Axis::A, -10.0}, {Axis::B, 10.0}, {Axis::B, -10.0}})
    as_map.tilts.emplace_back()[axis] = angle;
  double sum = 0;
  double worst = 0;
  std::size_t reached = 0;
  jobs::map_workspace(kMachine, as_map, [&](const jobs::MapCell& cell) {
    if (!cell.reached()) return;
    ++reached;
    sum += cell.uncertainty * cell.uncertainty;
    worst = std::max(worst, cell.uncertainty);
  });
  CHECK(box.reached() == reached);
  CHECK(over.stands.rms == Approx(std::sqrt(sum / static_cast<double>(reached))));
  CHECK(over.stands.worst == Approx(worst));
  CHECK(over.stands.rms == Approx(std::sqrt((box.mean_square() * prior()).trace())));
  CHECK(over.touched_off.rms < over.stands.rms);
}

TEST_CASE("in the middle of a box, where the zero is touched off, nothing is left") {
  jobs::TipBoxOptions options = box_mm(-1e-4, 1e-4, -1e-4, 1e-4, -1000.0001, -999.9999);
  const jobs::TipOverBox over = jobs::TipBox(kMachine, kUnknowns, options).with(prior());
  CHECK(over.touched_off.worst < 1e-4 * over.stands.rms);
  CHECK(over.stands.rms == Approx(over.stands.worst).epsilon(1e-4));
  CHECK(std::abs(over.stands.worst_at[Axis::Z] + 1000) < 1e-3);
}

TEST_CASE("without a box it is the middle half of the travel") {
  const jobs::TipBox box(kMachine, kUnknowns, {});
  for (std::size_t a = 0; a < 3; ++a) {
    const machine::Range& travel = kMachine.limits.travel[a];
    CHECK(box.box()[a].lower == Approx(travel.lower + (travel.upper - travel.lower) / 4));
    CHECK(box.box()[a].upper == Approx(travel.upper - (travel.upper - travel.lower) / 4));
  }
}

TEST_CASE("what is no box, or out of reach, is refused with a way out") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  const auto message = [](const jobs::TipBoxOptions& options) {
    const Diagnostic d = refusal_of([&] { jobs::TipBox(kMachine, kUnknowns, options); });
    CHECK(d.code == "plan-box");
    CHECK_FALSE(d.help.empty());
    return d.message;
  };
  CHECK(message(box_mm(100, -100, -80, 120, -1100, -900)) == "the box has no width in X: 100 to -100 mm");
  CHECK(message(box_mm(-100, 100, 80, 80, -1100, -900)) == "the box has no width in Y: 80 to 80 mm");
  CHECK(message(box_mm(-100, 100, -80, 120, nan, -900)).starts_with("Z of the box, nan to -900 mm, is no range"));
  CHECK(message(box_mm(-100, inf, -80, 120, -1100, -900)).starts_with("X of the box, -100 to inf mm, is no range"));
  CHECK(message(box_mm(-1e5, 1e5, -80, 120, -1100, -900)).find("further out than any machine") != std::string::npos);
  const std::string out = message(box_mm(-100, 100, -80, 120, 900, 1100));
  CHECK(out.starts_with("the machine reaches no pose of the box at a tilt of 0 deg: "));
  jobs::TipBoxOptions steep = box_mm(-100, 100, -80, 120, -1100, -900);
  steep.tilts = {0, 80 * kDeg};
  CHECK(message(steep).starts_with("the machine reaches no pose of the box at a tilt of 80 deg: tilt"));
  for (const double tilt : {-5 * kDeg, 100 * kDeg, nan}) {
    steep.tilts = {0, tilt};
    CHECK(message(steep).ends_with(" deg is none"));
  }
  // one end within the travel, the middle beyond it
  CHECK(message(box_mm(250, 1000, -80, 120, -1100, -900)).starts_with("no zero can be touched off in the middle"));
}
