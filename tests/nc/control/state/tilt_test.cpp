// Directions of the tool and planes that lie askew: against rotations written out, and what a program may do there.
#include "nc/control/state/tilt.hpp"

#include <array>
#include <cmath>
#include <random>
#include <string>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "base/units.hpp"
#include "nc/programs.hpp"

using namespace plumbline;
using namespace plumbline::nc;
using namespace plumbline::nc::tests;

namespace {

using Vector = std::array<double, 3>;

// A vector turned about X (0), Y (1) or Z (2).
Vector turned_about(int axis, double deg, const Vector& v) {
  const double c = std::cos(deg * kDeg);
  const double s = std::sin(deg * kDeg);
  if (axis == 0) return {v[0], c * v[1] - s * v[2], s * v[1] + c * v[2]};
  if (axis == 1) return {c * v[0] + s * v[2], v[1], -s * v[0] + c * v[2]};
  return {c * v[0] - s * v[1], s * v[0] + c * v[1], v[2]};
}

Vector tool_of(const RotationOrder& order, const AxisWords& words) {
  Vector v{0, 0, 1};
  for (std::size_t i = 3; i-- > 0;) v = turned_about(order[i], words.values[3 + static_cast<std::size_t>(order[i])], v);
  return v;
}

constexpr std::array<RotationOrder, 6> kOrders{RotationOrder{2, 1, 0}, RotationOrder{2, 0, 1}, RotationOrder{1, 2, 0},
                                               RotationOrder{0, 2, 1}, RotationOrder{0, 1, 2}, RotationOrder{1, 0, 2}};

ProgramSettings fanuc_at_zero(FreeRotation free) {
  ProgramSettings settings = at_zero();
  settings.work_offsets[1] = WorkOffset{};
  settings.free_rotation = free;
  Tool tool;
  tool.number = 1;
  tool.length_mm = 100;
  settings.tools = ToolTable({tool});
  return settings;
}

struct Ran {
  std::string code;
  std::size_t line = 0;
  AxisSet known;
  AxisWords position;
};

Ran ran(const std::string& text, const ProgramSettings& settings, const char* name = "fanuc") {
  const ProgramFile program(text);
  const InputFile file(program.path());
  Ran result;
  try {
    Program blocks(file, dialect(name), settings);
    while (const Step* step = blocks.next()) {
      result.known = step->known;
      result.position = step->position;
    }
  } catch (const Refusal& refusal) {
    result.code = refusal.diagnostic().code;
    result.line = refusal.diagnostic().place.line;
    CHECK_FALSE(refusal.diagnostic().help.empty());
  }
  return result;
}

const std::string kPlane = "G90 G54 G0 X0. Y0. Z50. A0. B0. C0.\nG68.2 X0. Y0. Z0. I0. J20. K0.\n";

}  // namespace

TEST_CASE("A and B put the tool along a direction, whatever the order of rotations and C are") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> angle(-60, 60);
  for (const RotationOrder& order : kOrders) {
    for (int i = 0; i < 200; ++i) {
      AxisWords words;
      for (const Axis axis : {Axis::A, Axis::B, Axis::C}) words[axis] = angle(random);
      const Vector along = tool_of(order, words);
      const auto found = orientation_along({3 * along[0], 3 * along[1], 3 * along[2]}, order, words[Axis::C]);
      INFO(order[0] << order[1] << order[2] << " A" << words[Axis::A] << " B" << words[Axis::B] << " C"
                    << words[Axis::C]);
      if (along[2] <= 0) {
        CHECK_FALSE(found);
        continue;
      }
      REQUIRE(found);
      CHECK((*found)[Axis::C] == words[Axis::C]);
      const Vector stands = tool_of(order, *found);
      for (std::size_t k = 0; k < 3; ++k) CHECK(stands[k] == Approx(along[k]).margin(1e-12));
    }
  }
  CHECK_FALSE(orientation_along({0, 0, 0}, kOrders[0], 0));
  CHECK_FALSE(orientation_along({1, 0, 0}, kOrders[0], 0));
  CHECK_FALSE(orientation_along({0, 0.1, -1}, kOrders[0], 0));
}

TEST_CASE("angles in turn are rotations about the axes as turned so far") {
  const Turn turn = turned_in_turn("ZXZ", {35, 20, -50});
  const AxisWords point{{1, -2, 3, 4, 5, 6}};
  const AxisWords out = turned(turn, point);
  const Vector by_hand = turned_about(
      2, 35, turned_about(0, 20, turned_about(2, -50, Vector{point[Axis::X], point[Axis::Y], point[Axis::Z]})));
  CHECK(out[Axis::X] == Approx(by_hand[0]));
  CHECK(out[Axis::Y] == Approx(by_hand[1]));
  CHECK(out[Axis::Z] == Approx(by_hand[2]));
  CHECK(out[Axis::B] == 5);
  const AxisWords back = turned_back(turn, out);
  for (const Axis axis : kAllAxes) CHECK(back[axis] == Approx(point[axis]));
}

TEST_CASE("what C is off goes on into A and B where C stays, and is gone where it goes to zero") {
  const auto along = tool_of(kOrders[0], {{0, 0, 0, 20, 10, 5}});
  Orienting orienting{{along[0], along[1], along[2]}, kOrders[0], FreeRotation::c_stays, 5};
  const AxisWords shift{{0.1, 0.2, 0.3, 7, 8, 0.01}};
  const AxisWords stays = shift_after(orienting, shift);
  CHECK(stays[Axis::X] == 0.1);
  CHECK(stays[Axis::C] == Approx(0.01));
  const Vector off = tool_of(kOrders[0], {{0, 0, 0, 20 + stays[Axis::A], 10 + stays[Axis::B], 5.01}});
  for (std::size_t k = 0; k < 3; ++k) CHECK(off[k] == Approx(along[k]).margin(1e-12));
  orienting.free = FreeRotation::c_zero;
  const AxisWords zero = shift_after(orienting, shift);
  for (const Axis axis : {Axis::A, Axis::B, Axis::C}) CHECK(zero[axis] == 0);
}

TEST_CASE("on a tilted plane X, Y and Z are to be stated anew, at its begin and after it") {
  const ProgramSettings settings = fanuc_at_zero(FreeRotation::c_zero);
  CHECK(ran(kPlane, settings).known == AxisSet::rotary());
  const Ran turned = ran(kPlane + "G53.1\n", settings);
  CHECK(turned.known == AxisSet::rotary());
  CHECK(turned.position[Axis::A] == Approx(20));
  CHECK(ran(kPlane + "G53.1\nG0 X5. Y0.\nG43 H1 Z30.\n", settings).known == AxisSet::all());
  CHECK(ran(kPlane + "G53.1\nG0 X5. Y0. Z9.\nG69\n", settings).known == AxisSet::rotary());
  CHECK(ran(kPlane + "G53.1\nG0 X5. Y0. Z9.\nG53 Z0.\n", settings).known == AxisSet::rotary());
  CHECK(ran(kPlane + "G53.1\nG0 X5. Y0. Z9.\nG91 G28 Z0.\n", settings).known == AxisSet::rotary());
}

TEST_CASE("what no source says of a tilted plane is refused") {
  const ProgramSettings settings = fanuc_at_zero(FreeRotation::c_zero);
  for (const char* const line :
       {"G0 A5.", "G1 X5. B2. F100.", "G68.2 X0. Y0. Z0. I0. J5. K0.", "G55", "G52 X5.", "G92 X0.", "G68 X0. Y0. R10.",
        "G43.4 H1", "G53 G0 C0.", "G91 G28 A0.", "G10 L2 P1 X5.", "G92.1 X0."}) {
    const Ran result = ran(kPlane + "G53.1\nG0 X0. Y0. Z9.\n" + line + "\n", settings);
    INFO(line);
    CHECK(result.code == "nc-tilted-plane");
    CHECK(result.line == 5);
  }
  for (const char* const before :
       {"G43.4 H1", "G52 X5.", "G92 X5.", "G68 X0. Y0. R10.", "G81 X0. Y0. Z-5. R1. F50.", "G91"}) {
    const Ran result =
        ran(fmt::format("G90 G54 G0 X0. Y0. Z50. A0. B0. C0.\n{}\nG68.2 X0. Y0. Z0. I0. J20. K0.\n", before), settings);
    INFO(before);
    CHECK(result.code == "nc-tilted-plane");
    CHECK(result.line == 3);
  }
  CHECK(ran("G90 G54 G0 X0. Y0. Z50. A0. B0. C0.\nG68.2 X0. Y0. Z0. I0. J95. K0.\nG53.1\n", settings).code ==
        "nc-tilted-plane");
  ProgramSettings turned = settings;
  turned.work_offsets[0]->origin[Axis::C] = 5;
  CHECK(ran(kPlane + "G53.1\n", turned).code == "nc-tilted-plane");
  turned.free_rotation = FreeRotation::c_stays;
  CHECK(ran(kPlane + "G53.1\n", turned).code.empty());
  turned.start[index(Axis::C)].reset();
  CHECK(ran("G90 G54\nG68.2 X0. Y0. Z0. I0. J20. K0.\nG53.1\n", turned).line == 3);
}

TEST_CASE("a tilted plane names the rotary axes, as far as it turns them") {
  for (const std::string text :
       {"G68.2 X0. Y0. Z0. I0. J20. K0.\nG53.1\nG0 X0. Y0. Z9.\n", "G0 X0. Y0. Z9. A1. B2. C3.\n"}) {
    const ProgramFile program(text);
    CHECK(named_axes(InputFile(program.path()), dialect("fanuc")) == AxisSet::all());
  }
}
