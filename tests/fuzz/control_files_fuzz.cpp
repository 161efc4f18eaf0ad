// Any bytes as a control's INI file, "=====" and its HAL file joints.hal. A model that is made of them is read as every
// model is, has the name and joints that the files state, and stands in the middle of its travel.
#include <algorithm>
#include <cmath>

#include "fuzz/fuzz.hpp"
#include "jobs/new_model/new_model.hpp"
#include "machine/limits.hpp"
#include "machine/model_file.hpp"

using namespace plumbline;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const fuzz::Two input = fuzz::split(fuzz::text_of(data, size));
  // files of its own are not for the input to name
  for (const std::string_view elsewhere : {"INCLUDE", "source", "/", ".."}) {
    if (fuzz::text_of(data, size).find(elsewhere) != std::string_view::npos) return 0;
  }
  jobs::NewModelJob job;
  job.control = jobs::ControlFiles{fuzz::folder().file("hexapod.ini", input.first), {}};
  fuzz::folder().file("joints.hal", input.second);
  fuzz::is_taken([&] {
    const jobs::NewModel made = jobs::make_new_model(job);
    const machine::MachineModel again = machine::parse_model(made.text, "again.toml");
    FUZZ_CHECK(again.name == made.model.name);
    FUZZ_CHECK(again.geometry.base_joints_W == made.model.geometry.base_joints_W);
    FUZZ_CHECK(machine::check_compensated(again.limits, again.geometry, machine::home_pose(again)).empty());
    FUZZ_CHECK(std::isfinite(made.home_error) && std::isfinite(made.home_condition));
    FUZZ_CHECK(made.corners.reached >= 0 && made.corners.reached <= 8);
    FUZZ_CHECK(std::all_of(made.assumed.begin(), made.assumed.end(),
                           [](const jobs::DraftValue& value) { return !value.note.empty(); }));
  });
  return 0;
}
