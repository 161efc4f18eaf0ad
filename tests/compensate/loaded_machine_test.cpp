#include "compensate/loaded_machine.hpp"

#include <catch2/catch.hpp>

#include "compensate/corrector.hpp"
#include "compensate/play.hpp"

using namespace plumbline;

TEST_CASE("the loaded machine has the errors and the condition number of the correction") {
  const machine::MachineModel model = Job().model;
  const compensate::Settings settings;
  compensate::LoadedMachine machine(model, settings);
  compensate::Corrector corrector(model, settings);
  compensate::Target target;
  target.pose = {{30, -20, -1000, 8, -5, 3}};
  target.slope = {{1, 0.5, 0, 0.1, 0, 0}};
  target.seconds = 0.05;
  for (const double length : {0.0, 0.12}) {
    if (length > 0) {
      machine.set_tool({length, 2.5, 0.05});
      corrector.set_tool({length, 2.5, 0.05});
    }
    const physics::Motion<double> motion = machine.motion(target);
    const physics::TipError<double> error = machine.error(motion);
    REQUIRE(error.converged());
    const std::optional<AxisWords> of_corrector = corrector.error(target);
    REQUIRE(of_corrector);
    CHECK(error.displacement[2] / kMm == Approx((*of_corrector)[Axis::Z]).epsilon(1e-6));
    CHECK(machine.condition(motion.pose) == Approx(corrector.condition(target)).epsilon(1e-6));
  }
}
