// Any bytes as a machine model. One that is taken must serve: its struts can be worked out at home, its effects set up,
// and what they say of the machine at home is finite or "did not converge".
#include <cmath>

#include "fuzz/fuzz.hpp"
#include "machine/axis_words.hpp"
#include "machine/inverse.hpp"
#include "machine/model_file.hpp"
#include "physics/error.hpp"
#include "physics/force_model.hpp"

using namespace plumbline;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::is_taken([&] {
    const machine::MachineModel model = machine::parse_model(std::string(fuzz::text_of(data, size)), "model.toml");
    const physics::ForceModel forces(model);
    physics::Motion<double> motion;
    motion.pose = machine::pose_of(model.rotation, AxisWords{{0, 0, -1008, 0, 0, 0}});
    const auto lengths = machine::strut_lengths<double>(model.geometry, motion.pose);
    FUZZ_CHECK(lengths.allFinite());
    const auto error = physics::tip_error(forces, forces.environment(), motion);
    FUZZ_CHECK(!error.converged() || error.displacement.allFinite());
  });
  return 0;
}
