// Any bytes as each of the small files of the user: tools, settings, variables, poses.
#include <cmath>

#include "fuzz/fuzz.hpp"
#include "jobs/pose_table.hpp"
#include "nc/language/tool_table.hpp"
#include "settings/options.hpp"
#include "settings/settings_file.hpp"
#include "settings/variables_file.hpp"

using namespace plumbline;

namespace {

void check_tools(const std::string& path) {
  const nc::ToolTable table = nc::read_tool_table(path);
  for (const nc::Tool& tool : table.all()) {
    FUZZ_CHECK(table.find(tool.number) != nullptr);
    FUZZ_CHECK(tool.name.empty() || table.find(tool.name) != nullptr);
    FUZZ_CHECK(std::isfinite(tool.length_mm));
    FUZZ_CHECK(!tool.mass_kg || std::isfinite(*tool.mass_kg));
    FUZZ_CHECK(!tool.centre_of_mass_mm || std::isfinite(*tool.centre_of_mass_mm));
  }
}

void check_settings(const std::string& path) {
  const settings::SettingsFile file = settings::read_settings_file(path);
  FUZZ_CHECK(file.path == path);
  settings::Options options;
  for (const settings::StatedOption& stated : file.options) settings::set_option(options, *stated.row, stated.text);
  for (const auto& [machine, all] : file.machines) {
    for (const settings::StatedOption& stated : all) settings::set_option(options, *stated.row, stated.text);
  }
  for (const auto& offset : options.program.work_offsets) {
    for (const Axis axis : kAllAxes) FUZZ_CHECK(!offset || std::isfinite(offset->origin[axis]));
  }
}

void check_variables(const std::string& path) {
  const std::map<int, double> variables = settings::read_variables(path);
  for (const auto& [number, value] : variables) FUZZ_CHECK(number >= 1 && std::isfinite(value));
  for (const auto& offset : settings::work_offsets_of(variables)) {
    for (const Axis axis : kAllAxes) FUZZ_CHECK(!offset || std::isfinite(offset->origin[axis]));
  }
}

void check_poses(const std::string& path) {
  for (const jobs::PoseRow& row : jobs::read_poses(path)) {
    for (const Axis axis : kAllAxes) FUZZ_CHECK(std::isfinite(row.pose[axis]));
  }
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string path = fuzz::folder().file("table", fuzz::text_of(data, size));
  for (const auto check : {check_tools, check_settings, check_variables, check_poses}) {
    fuzz::is_taken([&] { check(path); });
  }
  return 0;
}
