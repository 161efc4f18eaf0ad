// The model file of a machine, from what is stated of it.
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <plumbline/plumbline.hpp>

#include "api/given_options.hpp"
#include "api/guarded.hpp"
#include "api/inside.hpp"
#include "base/text/nearest_name.hpp"
#include "base/text/number_text.hpp"
#include "base/units.hpp"
#include "jobs/new_model/new_model.hpp"
#include "machine/model_keys.hpp"
#include "report/program/new_model_text.hpp"

namespace plumbline::api {
namespace {

std::string name_of(const machine::KeySpec& spec) {
  return spec.table.empty() ? std::string(spec.key) : fmt::format("{}.{}", spec.table, spec.key);
}

std::vector<double> numbers_of(const Options::Given& given) {
  std::vector<double> numbers;
  for (std::size_t at = 0; at <= given.value.size();) {
    const std::size_t end = std::min(given.value.find(',', at), given.value.size());
    const std::optional<double> number = parse_number(std::string_view(given.value).substr(at, end - at));
    if (!number) wrong_usage(fmt::format("{} {}: expected numbers between commas", given.name, given.value));
    numbers.push_back(*number);
    at = end + 1;
  }
  return numbers;
}

std::vector<double> numbers_of(const Options::Given& given, std::size_t count) {
  std::vector<double> numbers = numbers_of(given);
  if (numbers.size() != count) {
    wrong_usage(fmt::format("{}: expected {} numbers, not {}", given.name, count, numbers.size()));
  }
  return numbers;
}

double positive_in(const Options::Given& given) {
  const double number = numbers_of(given, 1).front();
  if (!(number > 0)) wrong_usage(fmt::format("{} {}: expected a positive number", given.name, given.value));
  return number;
}

// Whether the option states a part of the ring.
bool set_ring(jobs::JointRing& ring, const std::string& prefix, const Options::Given& given) {
  if (given.name == prefix + "-radius") {
    ring.radius_mm = positive_in(given);
  } else if (given.name == prefix + "-angles") {
    ring.angles_deg = numbers_of(given, machine::kStruts);
  } else if (given.name == prefix + "-height") {
    ring.height_mm = numbers_of(given, 1).front();
  } else if (given.name == prefix + "-joints") {
    ring.joints_mm = numbers_of(given, std::size_t{3} * machine::kStruts);
  } else {
    return false;
  }
  return true;
}

// Whether the option is a key of a model file that holds numbers.
bool state_key(jobs::NewModelJob& job, const Options::Given& given) {
  for (const machine::KeySpec& spec : machine::kKeys) {
    if (spec.shape == machine::Shape::text || name_of(spec) != given.name) continue;
    const std::vector<double> values = numbers_of(given);
    const bool one_for_all = spec.shape == machine::Shape::six && values.size() == 1;
    if (values.size() != machine::count_of(spec.shape) && !one_for_all) {
      wrong_usage(
          fmt::format("{}: expected {} numbers, not {}", given.name, machine::count_of(spec.shape), values.size()));
    }
    job.stated.push_back({std::string(spec.table), std::string(spec.key), values, "", "", false, {}});
    return true;
  }
  return false;
}

[[noreturn]] void unknown(const std::string& name) {
  std::vector<std::string> names{"name", "provenance", "rotation", "ini", "hal", "home"};
  for (const std::string prefix : {"base", "platform"}) {
    for (const std::string what : {"radius", "angles", "height", "joints"}) names.push_back(prefix + "-" + what);
  }
  for (const machine::KeySpec& spec : machine::kKeys) {
    if (spec.shape != machine::Shape::text) names.push_back(name_of(spec));
  }
  wrong_usage(fmt::format("there is no option {}", name), suggestion(name, {names.begin(), names.end()}));
}

jobs::NewModelJob job_of(const Options& options) {
  jobs::NewModelJob job;
  jobs::ControlFiles control;
  for (const Options::Given& given : options.given()) {
    if (given.input) wrong_usage(fmt::format("{} is given as an Input", given.name));
    if (given.name == "name") {
      job.name = given.value;
    } else if (given.name == "provenance") {
      job.provenance = given.value;
    } else if (given.name == "rotation") {
      job.stated.push_back({"", "rotation", {}, given.value, "", false, {}});
    } else if (given.name == "ini") {
      control.ini = given.value;
    } else if (given.name == "hal") {
      control.hal.push_back(given.value);
    } else if (given.name == "home") {
      job.home_mm = numbers_of(given, 3);
    } else if (!set_ring(job.base, "base", given) && !set_ring(job.platform, "platform", given) &&
               !state_key(job, given)) {
      unknown(given.name);
    }
  }
  if (!control.hal.empty() && control.ini.empty()) {
    wrong_usage("hal needs ini: the unit of its lengths stands in the INI file");
  }
  if (!control.ini.empty()) job.control = control;
  return job;
}

std::string json_of(const jobs::NewModel& made) {
  nlohmann::ordered_json assumed = nlohmann::ordered_json::array();
  for (const jobs::DraftValue& value : made.assumed) {
    assumed.push_back(value.table.empty() ? value.key : fmt::format("{}.{}", value.table, value.key));
  }
  const nlohmann::ordered_json json{{"plumbline", "new model 1"},
                                    {"name", made.model.name},
                                    {"assumed", assumed},
                                    {"notes", made.notes},
                                    {"home_condition", made.home_condition},
                                    {"home_error_um", made.home_error / kUm},
                                    {"corners_reached", made.corners.reached}};
  return json.dump(2) + "\n";
}

}  // namespace

inline namespace v1 {

Result new_model(const Options& options) {
  return guarded([&] {
    const jobs::NewModel made = jobs::make_new_model(job_of(options));
    Inside::Found found;
    found.json = json_of(made);
    found.words = report::new_model_text(made);
    found.model = made.text;
    return Inside::result(std::move(found));
  });
}

}  // namespace v1
}  // namespace plumbline::api
