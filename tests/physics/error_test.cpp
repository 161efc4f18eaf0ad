#include "physics/error.hpp"

#include <catch2/catch.hpp>

#include "physics/golden.hpp"

using namespace plumbline;
using namespace plumbline::physics;
using namespace plumbline::testing;

TEST_CASE("the error of forty poses agrees with an independent program") {
  const machine::MachineModel model = pm600_like();
  const ForceModel forces(model);
  const std::vector<GoldenRow> rows = golden_rows();
  REQUIRE(rows.size() == 40);
  for (const GoldenRow& row : rows) {
    Motion<double> motion;
    motion.pose = machine::pose_of(model.rotation, row.words);
    const TipError<double> error = tip_error(forces, forces.environment(), motion);
    INFO("row " << &row - rows.data() + 2 << ", iterations " << error.iterations);
    REQUIRE(error.converged());
    const auto commanded = machine::strut_lengths(model.geometry, motion.pose);
    for (int j = 0; j < 6; ++j) {
      const auto i = static_cast<std::size_t>(j);
      CHECK(commanded[j] / kMm == Approx(row.length_mm[i]).margin(1e-9).epsilon(0));
      CHECK(error.loads.nut_tension[j] == Approx(row.nut_tension[i]).margin(1e-6).epsilon(0));
      CHECK(error.loads.stretch[j] / kUm == Approx(row.stretch_um[i]).margin(2e-8).epsilon(0));
      CHECK(error.displacement[j] / kUm == Approx(row.displacement[i]).margin(1e-6).epsilon(0));
    }
  }
}
