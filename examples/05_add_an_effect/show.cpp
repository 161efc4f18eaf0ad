// add_an_effect MODEL: what each motor pulls as the platform goes down, at rest, for a model that may name bellows.
#include <exception>
#include <iostream>

#include <fmt/format.h>

#include "base/diagnostic.hpp"
#include "machine/model_file.hpp"
#include "physics/strut_stretch.hpp"

using namespace plumbline;

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: add_an_effect MODEL\n";
    return 2;
  }
  try {
    const physics::ForceModel forces(machine::read_model(argv[1]));
    std::cout << "z_mm,length1_mm,drive1_N,length2_mm,drive2_N\n";
    for (const double z_mm : {-900.0, -1000.0, -1100.0}) {
      physics::Motion<double> motion;
      motion.pose.p_WT = {0, 0, z_mm * kMm};
      const auto struts = physics::strut_stretch(forces, forces.environment(), motion);
      std::cout << fmt::format("{},{:.6f},{:.6f},{:.6f},{:.6f}\n", z_mm, struts.struts.length[0] / kMm,
                               struts.drive_tension[0], struts.struts.length[1] / kMm, struts.drive_tension[1]);
    }
  } catch (const Refusal& refusal) {
    std::cerr << to_text(refusal.diagnostic());
    return 1;
  }
  return 0;
}
