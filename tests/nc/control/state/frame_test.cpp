#include "nc/control/state/frame.hpp"

#include <catch2/catch.hpp>

using namespace plumbline;
using namespace plumbline::nc;

namespace {

Frame some_frame() {
  Frame frame;
  frame.origin = {{5, 6, 7, 1, 2, 3}};
  frame.rotation_deg = 30;
  frame.g92 = {{2, 3, -1, 4, 0, 0}};
  frame.tool = {{1, 0, 50, 0, 0, 0}};
  return frame;
}

}  // namespace

TEST_CASE("offsets apply in order: shift, rotation, work offset, tool") {
  const Frame frame = some_frame();
  const AxisWords pose = frame.to_pose({{1, 1, 0, 0, 0, 0}});
  CHECK(pose[Axis::X] == Approx(5.5980762));  // 5 + 3 cos 30 - 4 sin 30
  CHECK(pose[Axis::Y] == Approx(10.9641016));
  CHECK(pose[Axis::Z] == Approx(6));
  CHECK(pose[Axis::A] == Approx(5));
  const AxisWords machine = frame.to_machine({{1, 1, 0, 0, 0, 0}});
  CHECK(machine[Axis::X] == Approx(6.5980762));
  CHECK(machine[Axis::Z] == Approx(56));
}

TEST_CASE("and back") {
  const Frame frame = some_frame();
  const AxisWords work{{-3, 8, 11, 12, 13, 14}};
  const AxisWords again = frame.from_machine(frame.to_machine(work));
  const AxisWords posed = frame.from_pose(frame.to_pose(work));
  for (const Axis axis : kAllAxes) {
    CHECK(again[axis] == Approx(work[axis]));
    CHECK(posed[axis] == Approx(work[axis]));
  }
}
