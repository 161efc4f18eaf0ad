#include "report/measured/next_test_text.hpp"

#include <fmt/format.h>

#include "base/units.hpp"

namespace plumbline::report {

std::string next_test_text(const diagnose::Separation& separation) {
  if (!separation.test) {
    return fmt::format("no circular test separates it from {}", separation.from);
  }
  const measure::Run& run = separation.test->run;
  return fmt::format(
      "next test, to separate it from {} (by {:.0f} sigma): centre {:.0f}, {:.0f}, {:.0f} mm, A {:.1f} B {:.1f} "
      "deg, {}, F{:.0f}{}",
      separation.from, separation.test->separation, run.centre_W.x() / kMm, run.centre_W.y() / kMm,
      run.centre_W.z() / kMm, run.tilt.x() / kDeg, run.tilt.y() / kDeg, measure::to_text(run.direction),
      run.feed / kMmPerMin, run.payload_mass > 0 ? fmt::format(", {:.0f} kg at the tip", run.payload_mass) : "");
}

}  // namespace plumbline::report
