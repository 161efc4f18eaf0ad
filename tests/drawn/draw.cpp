#include "drawn/dialects.hpp"
#include "settings/options.hpp"

namespace plumbline::drawn {
namespace {

// How a program is compensated, apart from what its text needs.
void draw_options(settings::Options& options, Draws& draws) {
  compensate::Settings& settings = options.compensation;
  settings.step.length_mm = draws.between(1.5, 12);
  settings.step.angle_deg = draws.between(0.8, 6);
  settings.friction = !draws.chance(30);
  if (draws.chance(10)) settings.method = compensate::Method::first_order;
  if (draws.chance(8)) settings.dynamic = true;
  if (draws.chance(8)) settings.touch_off = AxisWords{{5, -3, -1000, 0, 1, 0}};
  if (draws.chance(10)) options.emit.time_tolerance = draws.between(0, 0.01);
  settings.cycle_tolerance_mm = 0.02;
  options.undo = draws.chance(50);
  options.guard = draws.chance(15) && options.dialect != "okuma";
  options.program.max_blocks = 100'000;
}

}  // namespace

DrawnProgram draw(std::string_view dialect, std::uint64_t seed, const Scene& scene) {
  const auto writer = dialect == "fanuc"     ? fanuc_writer(seed, scene)
                      : dialect == "okuma"   ? okuma_writer(seed, scene)
                      : dialect == "siemens" ? siemens_writer(seed, scene)
                                             : linuxcnc_writer(seed, scene);
  DrawnProgram program = writer->write();
  Draws draws(~seed);
  draw_options(program.options, draws);
  return program;
}

}  // namespace plumbline::drawn
