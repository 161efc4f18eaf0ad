// Files that each check refuses are in bad/, where model_file_test.cpp reads them.
#include "machine/model_checks.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "machine/machines.hpp"
#include "support/scratch.hpp"

using namespace plumbline;
using namespace plumbline::machine;

namespace {

template <class Change>
Diagnostic refused_model(const Change& change) {
  MachineModel model = testing::pm600_like();
  change(model);
  return testing::refusal_of([&] { check_model(model); });
}

ModelValue& travel_of_x(MachineModel& model) {
  for (ModelValue& value : model.values) {
    if (value.table == "limits" && value.key == "x_mm") return value;
  }
  FAIL("there is no travel of X");
  return model.values.front();
}

}  // namespace

TEST_CASE("machines that make sense pass") {
  for (const MachineModel& model : testing::three_machines()) CHECK_NOTHROW(check_model(model));
}

TEST_CASE("gravity is what it is on Earth, and points down") {
  CHECK(refused_model([](MachineModel& m) { m.gravity = {0, 0, 9.81}; }).message == "gravity points up");
  CHECK(refused_model([](MachineModel& m) { m.gravity = {0, 0, -9.74}; }).code == "model-gravity");
  CHECK(refused_model([](MachineModel& m) { m.gravity = {0, 0, -9.78}; }).code.empty());  // at the equator
}

TEST_CASE("joints are six points of a machine that is larger than a fist") {
  const Diagnostic same =
      refused_model([](MachineModel& m) { m.geometry.base_joints_W.col(4) = m.geometry.base_joints_W.col(1); });
  CHECK(same.code == "model-coincident-joints");
  CHECK(same.message == "joints 2 and 5 of [base] are the same point");
  const auto meet = [](MachineModel& m) {
    for (const int j : {0, 2, 4}) m.geometry.base_joints_W.col(j) = m.geometry.base_joints_W.col((j + 5) % 6);
  };
  CHECK(refused_model(meet).code.empty());  // two by two at three points
  const Diagnostic three = refused_model([&](MachineModel& m) {
    meet(m);
    m.geometry.base_joints_W.col(1) = m.geometry.base_joints_W.col(0);
  });
  CHECK(three.code == "model-coincident-joints");
  const Diagnostic small = refused_model([](MachineModel& m) { m.geometry.platform_joints_P *= 1e-3; });
  CHECK(small.code == "model-unit");
  CHECK(small.message == "all coordinates of the joints of [platform] are below 10 mm");
}

TEST_CASE("a single joint in metres is found, wherever it stands") {
  for (int j = 0; j < kStruts; ++j) {
    for (const bool base : {true, false}) {
      INFO(j << base);
      const Diagnostic one = refused_model(
          [&](MachineModel& m) { (base ? m.geometry.base_joints_W : m.geometry.platform_joints_P).col(j) *= 1e-3; });
      CHECK(one.code == "model-unit");
      CHECK(one.message.starts_with(fmt::format("joint {} of [{}]", j + 1, base ? "base" : "platform")));
    }
  }
  // a frame whose origin is a joint, as a fit to measurements leaves it
  for (const double off : {0.0, 30e-6, -2e-6}) {
    CHECK(refused_model([&](MachineModel& m) {
            const Vector3<double> origin = m.geometry.base_joints_W.col(2);
            m.geometry.base_joints_W.colwise() -= origin;
            m.geometry.base_joints_W.col(2) += Vector3<double>(off, -off, off / 2);
          }).code != "model-unit");
  }
}

TEST_CASE("travel and lengths have their lower limit first") {
  CHECK(refused_model([](MachineModel& m) { travel_of_x(m).values = {0.3, -0.3}; }).code == "model-limit-order");
  CHECK(refused_model([](MachineModel& m) { travel_of_x(m).values = {-0.0003, 0.0003}; }).code == "model-unit");
  const Diagnostic lengths = refused_model([](MachineModel& m) { m.limits.length_min[2] = m.limits.length_max[2]; });
  CHECK(lengths.code == "model-length-order");
  CHECK(lengths.message == "strut 3: length_min_mm is not below length_max_mm");
}

TEST_CASE("a machine whose struts do not hold the platform is refused") {
  // the platform is the base, smaller: all struts meet in one point of its axis
  const Diagnostic singular = refused_model([](MachineModel& m) {
    m.geometry.platform_joints_P = 0.25 * m.geometry.base_joints_W;
    m.geometry.platform_joints_P.row(2).setConstant(0.15);
    m.geometry.base_joints_W.row(2).setConstant(0);
  });
  CHECK(singular.code == "model-singular-home");
}
