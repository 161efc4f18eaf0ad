#include "machine/axis_words.hpp"

#include <catch2/catch.hpp>

using namespace plumbline;
using namespace plumbline::machine;

TEST_CASE("words become poses and come back") {
  const AxisWords words{{100, -20.5, -1008, -25, 3, 370}};
  const Pose<double> pose = pose_of({}, words);
  CHECK((pose.p_WT - Vector3<double>(0.1, -0.0205, -1.008)).norm() < 1e-16);
  const AxisWords back = words_of({}, pose, {{0, 0, 0, -20, 0, 360}});
  for (const Axis axis : kAllAxes) CHECK(back[axis] == Approx(words[axis]).margin(1e-11));
}
