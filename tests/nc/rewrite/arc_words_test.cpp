#include "nc/rewrite/arc_words.hpp"

#include <catch2/catch.hpp>

#include "nc/rewrite/last_step.hpp"
#include "support/scratch.hpp"

using namespace plumbline;
using namespace plumbline::nc;
using namespace plumbline::nc::tests;

namespace {

std::optional<ArcForm> form_of(const LastStep& step, const OutputState& control = {},
                               std::string_view name = "linuxcnc") {
  const EmitSettings emit;
  return arc_form(dialect(name), WordGrid(dialect(name), emit), *step, control);
}

}  // namespace

TEST_CASE("arcs are written where the control is known to go evenly from radius to radius") {
  const std::optional<ArcForm> form = form_of(LastStep("G17 G2 X10 I5 F100\n"));
  REQUIRE(form);
  CHECK(form->beside == AxisSet::all());
  CHECK(form->half_centre_mm == Approx(5e-5));
  CHECK(form->radii_apart_mm < spiral_taken(false));
  CHECK(form->may_close);
  CHECK_FALSE(form_of(LastStep("G1 X10 F100\n")));
  CHECK_FALSE(form_of(LastStep("G54 G17 G0 X0. Y0.\nG2 X10. I5. F100.\n", "fanuc"), {}, "fanuc"));
  CHECK_FALSE(form_of(LastStep("G54 G17 G0 X0 Y0\nG2 X10 I5 F100\n", "siemens"), {}, "siemens"));
  CHECK(form_of(LastStep("G20 G17 G2 X1 I0.5 F10\n"))->half_centre_mm == Approx(25.4 * 5e-7));
}

TEST_CASE("a whole circle closes only where words say where it begins") {
  OutputState control;
  control.shift[Axis::Y] = 0.00002;
  CHECK_FALSE(form_of(LastStep("G17 G2 I5 F100\n"), control)->may_close);
  CHECK(form_of(LastStep("G18 G2 I5 F100\n"), control)->may_close);  // Y is not in its plane
  CHECK(form_of(LastStep("G91 G17 G2 I5 F100\n"), control)->may_close);
}

TEST_CASE("a centre is rounded as its word is, from where the arc begins or in the work system") {
  const EmitSettings emit;
  const WordGrid words(dialect("linuxcnc"), emit);
  const Arc arc{Plane::zx, {7.00004, 0, -3.00006}, -1};
  const AxisWords start{{2, 0, 0, 0, 0, 0}};
  const ArcWords from_start = arc_words(words, *LastStep("G18 G2 X10 I5 K-3 F100\n"), arc, start);
  CHECK(from_start.letters == std::array{'K', 'I'});
  CHECK(from_start.value[0] == -3.0001);
  CHECK(from_start.value[1] == 5);
  CHECK(from_start.arc.centre_mm[0] == 7);
  CHECK(from_start.arc.centre_mm[2] == -3.0001);
  const ArcWords finer = arc_words(words, *LastStep("G18 G2 X10 I4.999999 K-3.0001 F100\n"), arc, start);
  CHECK(finer.value[1] == 5.00004);
  const ArcWords absolute = arc_words(words, *LastStep("G90.1 G18 G2 X10 I5 K0 F100\n"), arc, start);
  CHECK(absolute.value[1] == 7);
}
