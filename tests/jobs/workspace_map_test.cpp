#include "jobs/workspace_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <catch2/catch.hpp>

#include "base/parallel.hpp"
#include "base/units.hpp"
#include "jobs/error_table.hpp"
#include "machine/axis_words.hpp"
#include "machine/condition.hpp"
#include "machine/limits.hpp"
#include "machine/machines.hpp"
#include "machine/model_file.hpp"
#include "physics/error.hpp"
#include "report/program/map_text.hpp"
#include "support/scratch.hpp"

using namespace plumbline;

namespace {

jobs::MapOptions coarse() {
  jobs::MapOptions options;
  options.step = 0.15;
  return options;
}

std::vector<jobs::MapCell> map_cells(const machine::MachineModel& model, const jobs::MapOptions& options) {
  std::vector<jobs::MapCell> cells;
  jobs::map_workspace(model, options, [&](const jobs::MapCell& cell) { cells.push_back(cell); });
  return cells;
}

machine::MachineModel model_with(const std::string& what, const std::string& in_its_place) {
  std::string text = read_text(testing::source_path("models/pm600-like.toml"));
  text.replace(text.find(what), what.size(), in_its_place);
  return machine::parse_model(text, "model.toml");
}

}  // namespace

TEST_CASE("the grid has both ends of the box, its sides divided evenly, X fastest") {
  const machine::MachineModel model = testing::pm600_like();
  jobs::MapOptions options = coarse();
  const jobs::WorkspaceGrid grid = jobs::workspace_grid(model, options);
  CHECK(grid.axes[0].size() == 5);
  CHECK(grid.axes[2].size() == 4);
  CHECK(grid.axes[2].front() == -1.25);
  CHECK(grid.axes[2].back() == -0.8);
  CHECK(jobs::workspace_grid(model, {}).axes[0].size() == 21);  // a twentieth of 600 mm
  options.box[0] = machine::Range{0, 0.1};
  options.planes = {-1, -1.1, -1};
  options.tilts = {AxisWords{}, AxisWords{{0, 0, 0, 10, -5, 0}}};
  const std::vector<jobs::MapCell> cells = map_cells(model, options);
  REQUIRE(cells.size() == 2 * 5 * 2 * 2);
  CHECK(cells[0].pose[Axis::X] == 0);
  CHECK(cells[1].pose[Axis::X] == Approx(100));
  CHECK(cells[1].pose[Axis::Z] == Approx(-1100));
  CHECK(cells[10].pose[Axis::Z] == Approx(-1000));
  CHECK(cells[20].pose[Axis::A] == 10);
  CHECK(cells[20].pose[Axis::B] == -5);
}

TEST_CASE("a cell says what the single computations say") {
  const machine::MachineModel model = testing::pm600_like();
  jobs::MapOptions options = coarse();
  options.tilts = {AxisWords{{0, 0, 0, 10, 5, 0}}};
  for (const jobs::MapCell& cell : map_cells(model, options)) {
    INFO(cell.pose[Axis::X] << " " << cell.pose[Axis::Y] << " " << cell.pose[Axis::Z]);
    const Pose<double> pose = machine::pose_of(model.rotation, cell.pose);
    const bool within = machine::check_compensated(model.limits, model.geometry, pose).empty();
    if (!cell.reached()) {
      CHECK((!within || cell.out.front() == "beyond a singularity"));
      continue;
    }
    CHECK(within);
    jobs::error_table(model, std::vector<jobs::PoseRow>{{cell.pose, {}}}, [&](const jobs::PoseError& error) {
      CHECK((cell.error - error.error.head<3>()).norm() < 1e-12);
      CHECK(cell.largest_force == Approx(error.nut_tension.cwiseAbs().maxCoeff()));
    });
    CHECK(cell.condition == Approx(machine::condition_number(machine::strut_geometry(model.geometry, pose),
                                                             machine::platform_radius(model.geometry))));
    CHECK(cell.stiffness > 1e6);
    CHECK(cell.uncertainty > 0);
  }
}

TEST_CASE("the uncertainty is the spread of the tip over machines drawn from [uncertainty]") {
  // K1 and K2 alone: the tip moves in proportion, so that two machines at one sigma say it all
  const machine::MachineModel model = model_with(
      "joint_position_um = 8\nstrut_offset_um = 5\ncompliance_relative = 0.05\ncoulomb_friction_N = "
      "6\ncentre_of_mass_mm = 1.5\nlevel_mrad = 0.15\n",
      "compliance_relative = 0.05\n");
  jobs::MapOptions options = coarse();
  options.step = 0.3;
  const auto k1 = map_cells(
      model_with("compliance_per_length_um_N_m = 0.01287", "compliance_per_length_um_N_m = 0.0135135"), options);
  const auto k2 = map_cells(model_with("compliance_um_N = 0.00782", "compliance_um_N = 0.008211"), options);
  const auto cells = map_cells(model, options);
  REQUIRE(cells.size() == k1.size());
  const auto middle = static_cast<std::size_t>(std::find_if(cells.begin(), cells.end(),
                                                            [](const jobs::MapCell& cell) {
                                                              return cell.pose[Axis::X] == 0 &&
                                                                     cell.pose[Axis::Y] == 0 &&
                                                                     cell.pose[Axis::Z] == -1025;
                                                            }) -
                                               cells.begin());
  REQUIRE(middle < cells.size());
  CHECK(cells[middle].touched_off == 0);
  int reached = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (!cells[i].reached()) continue;
    ++reached;
    const auto moved = [&](const std::vector<jobs::MapCell>& other, std::size_t at) {
      return Vector3<double>(other[at].error - cells[at].error);
    };
    CHECK(cells[i].uncertainty == Approx(std::hypot(moved(k1, i).norm(), moved(k2, i).norm())).epsilon(1e-2));
    const double apart =
        std::hypot((moved(k1, i) - moved(k1, middle)).norm(), (moved(k2, i) - moved(k2, middle)).norm());
    CHECK(cells[i].touched_off == Approx(apart).epsilon(2e-2));
  }
  CHECK(reached > 20);
}

TEST_CASE("poses out of reach say by which limit, and are counted") {
  const machine::MachineModel model = model_with("length_max_mm = 1900", "length_max_mm = 1400");
  jobs::MapOptions options = coarse();
  options.box[2] = machine::Range{-1.3, -0.8};
  options.tilts = {AxisWords{}, AxisWords{{0, 0, 0, 40, 0, 0}}};
  std::uint64_t outside = 0;
  bool too_long = false;
  const jobs::MapSummary summary = jobs::map_workspace(model, options, [&](const jobs::MapCell& cell) {
    if (cell.reached()) return;
    ++outside;
    if (cell.pose[Axis::A] == 40) CHECK(cell.out.front() == "tilt too large");
    if (cell.pose[Axis::Z] < -1299) CHECK(std::count(cell.out.begin(), cell.out.end(), "Z too small") == 1);
    too_long = too_long || std::count(cell.out.begin(), cell.out.end(), "strut 3 too long") == 1;
  });
  CHECK(too_long);
  CHECK(summary.poses == summary.reached + outside);
  CHECK(summary.out.at("tilt too large") == summary.poses / 2);
  CHECK(summary.error.spread.count() == summary.reached);
}

TEST_CASE("the map does not depend on how many processors there are") {
  const machine::MachineModel model = testing::pm600_like();
  const auto text = [&](unsigned processors) {
    const HeldProcessors held(processors);
    const testing::Scratch scratch;
    OutputFile out(scratch.path("map.csv"));
    report::MapTable table(out, true);
    jobs::map_workspace(model, coarse(), [&](const jobs::MapCell& cell) { table.add(cell); });
    out.commit();
    return scratch.text("map.csv");
  };
  CHECK(text(1) == text(3));
}

TEST_CASE("without [uncertainty] there is none, and the words say so") {
  std::string text = read_text(testing::source_path("models/pm600-like.toml"));
  text.resize(text.find("[uncertainty]"));
  const machine::MachineModel model = machine::parse_model(text, "model.toml");
  CHECK_FALSE(jobs::knows_uncertainty(model));
  const jobs::MapSummary summary = jobs::map_workspace(model, coarse(), [](const jobs::MapCell&) {});
  CHECK_FALSE(summary.has_uncertainty);
  CHECK(report::map_text(summary).find("no [uncertainty]") != std::string::npos);
}

TEST_CASE("boxes and steps that are slips are refused") {
  const machine::MachineModel model = testing::pm600_like();
  jobs::MapOptions options;
  options.box[1] = machine::Range{0.1, 0.1};
  CHECK(testing::refusal_of([&] { jobs::workspace_grid(model, options); }).code == "map-box");
  options.box[1] = machine::Range{0, std::numeric_limits<double>::infinity()};
  CHECK(testing::refusal_of([&] { jobs::workspace_grid(model, options); }).code == "map-box");
  options = {};
  options.planes = {std::nan("")};
  CHECK(testing::refusal_of([&] { jobs::workspace_grid(model, options); }).code == "map-box");
  options = {};
  options.step = 1e-5;
  CHECK(testing::refusal_of([&] { jobs::workspace_grid(model, options); }).code == "map-step");
}
