// The machines in models/: each is read, makes sense, and goes there and back all over its work.
#include <algorithm>
#include <filesystem>
#include <set>

#include <catch2/catch.hpp>

#include "base/files/files.hpp"
#include "machine/condition.hpp"
#include "machine/forward.hpp"
#include "machine/limits.hpp"
#include "machine/machines.hpp"

using namespace plumbline;
using namespace plumbline::machine;

namespace {

std::vector<std::filesystem::path> model_files() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(testing::source_path("models"))) {
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

TEST_CASE("there are several machines, each under its own name, that say where their numbers come from") {
  std::set<std::string> names;
  for (const auto& file : model_files()) {
    INFO(file.filename().string());
    const MachineModel model = read_model(file.string());
    CHECK(model.name == file.stem().string());
    CHECK(model.provenance.find("assumed") + model.provenance.find("fitted") != 2 * std::string::npos);
    names.insert(model.name);
  }
  CHECK(names.size() >= 4);
  CHECK(names.contains("linuxcnc-hexapod"));
}

TEST_CASE("every machine stands at home, well away from its singularities, with sane limits") {
  for (const auto& file : model_files()) {
    INFO(file.filename().string());
    const MachineModel model = read_model(file.string());
    const Pose<double> home = home_pose(model);
    CHECK(check_compensated(model.limits, model.geometry, home).empty());
    CHECK(condition_number(strut_geometry(model.geometry, home), platform_radius(model.geometry)) < 20);
    CHECK(model.limits.tilt >= 10 * kDeg);
    CHECK(model.limits.tilt <= 45 * kDeg);
    for (int j = 0; j < kStruts; ++j) CHECK(model.limits.length_max[j] < 3 * model.limits.length_min[j]);
    for (const Range& travel : model.limits.travel) CHECK(travel.upper - travel.lower > 100 * kMm);
  }
}

TEST_CASE("every machine finds its pose again from its strut lengths, all over its work") {
  for (const auto& file : model_files()) {
    INFO(file.filename().string());
    const MachineModel model = read_model(file.string());
    const Pose<double> home = home_pose(model);
    const int side = side_of(model.geometry, home);
    testing::Random random(20);
    int reached = 0;
    for (int i = 0; i < 300; ++i) {
      const Pose<double> pose = testing::pose_within(model.limits, random);
      if (!check_compensated(model.limits, model.geometry, pose).empty()) continue;
      if (side_of(model.geometry, pose) != side) continue;  // tilted far in a corner of the PM-600's box
      ++reached;
      INFO("pose " << i);
      const Pose<double> start = testing::pose_beside(pose, 20 * kMm, 3 * kDeg, random);
      const ForwardResult back = forward(model.geometry, strut_lengths<double>(model.geometry, pose), start);
      REQUIRE(back.converged());
      CHECK((back.pose.p_WT - pose.p_WT).norm() < 1e-9);
      CHECK((back.pose.R_WP - pose.R_WP).norm() < 1e-9);
    }
    CHECK(reached > 150);
  }
}
