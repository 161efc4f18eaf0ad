#include <deque>
#include <filesystem>
#include <memory>
#include <system_error>

#include <fmt/format.h>

#include "base/diagnostic.hpp"
#include "base/files/files.hpp"
#include "base/files/path_of.hpp"
#include "base/text/nearest_name.hpp"
#include "cli/command.hpp"
#include "cli/command_files.hpp"
#include "cli/messages.hpp"
#include "cli/options/number_list.hpp"
#include "jobs/new_model/new_model.hpp"
#include "machine/model_keys.hpp"
#include "report/program/new_model_text.hpp"

namespace plumbline::cli {
namespace {

// An option that states a key of the model file.
struct KeyOption {
  const char* name;
  const char* table;
  const char* key;
};

constexpr KeyOption kTipOptions[] = {{"--tool-tip", "platform", "tool_tip_mm"}};
constexpr KeyOption kLimitOptions[] = {
    {"--strut-min", "strut", "length_min_mm"}, {"--strut-max", "strut", "length_max_mm"},
    {"--travel-x", "limits", "x_mm"},          {"--travel-y", "limits", "y_mm"},
    {"--travel-z", "limits", "z_mm"},          {"--tilt", "limits", "tilt_deg"}};
constexpr KeyOption kPartOptions[] = {{"--platform-mass", "platform", "mass_kg"},
                                      {"--centre-of-mass", "platform", "centre_of_mass_mm"},
                                      {"--screw-mass", "strut", "screw_mass_kg"},
                                      {"--joint-mass", "strut", "joint_mass_kg"},
                                      {"--motor-mass", "strut", "motor_mass_kg"},
                                      {"--motor-arm", "strut", "motor_arm_mm"},
                                      {"--joint-length", "strut", "joint_length_mm"},
                                      {"--screw-length", "strut", "screw_length_mm"},
                                      {"--compliance-per-length", "strut", "compliance_per_length_um_N_m"},
                                      {"--compliance", "strut", "compliance_um_N"},
                                      {"--friction", "strut", "coulomb_friction_N"},
                                      {"--lead", "strut", "lead_mm"}};

struct NewModelArguments {
  struct Given {
    const machine::KeySpec* spec;
    std::string option;
    std::vector<double> values;
  };

  jobs::NewModelJob job;
  std::string output = std::string(kStandardStream);
  std::string ini, rotation;
  std::vector<std::string> hal, settings;
  bool force = false;
  std::deque<Given> given;  // their places stay
};

std::string numbers_of(machine::Shape shape) {
  switch (shape) {
    case machine::Shape::six:
      return "one number for all struts or six";
    case machine::Shape::vector:
      return "three numbers";
    case machine::Shape::range:
      return "two numbers, the lower first";
    case machine::Shape::six_vectors:
      return "18 numbers, x y z of each joint";
    default:
      return "one number";
  }
}

void state(jobs::NewModelJob& job, const machine::KeySpec& spec, const std::string& option,
           const std::vector<double>& values) {
  const bool one_for_all = spec.shape == machine::Shape::six && values.size() == 1;
  if (values.size() != machine::count_of(spec.shape) && !one_for_all)
    throw UsageError(fmt::format("{}: expected {}, not {}", option, numbers_of(spec.shape), values.size()));
  job.stated.push_back({std::string(spec.table), std::string(spec.key), values, "", "", false, {}});
}

// TABLE.KEY=NUMBER,...
void apply_setting(jobs::NewModelJob& job, const std::string& setting) {
  const std::size_t equals = setting.find('=');
  const std::string name = setting.substr(0, equals);
  std::vector<std::string> names;
  const machine::KeySpec* found = nullptr;
  for (const machine::KeySpec& spec : machine::kKeys) {
    if (spec.shape == machine::Shape::text) continue;
    names.push_back(spec.table.empty() ? std::string(spec.key) : fmt::format("{}.{}", spec.table, spec.key));
    if (names.back() == name) found = &spec;
  }
  if (found == nullptr) {
    const std::vector<std::string_view> known(names.begin(), names.end());
    throw UsageError(
        fmt::format("--set: {} is no key of a model file that holds numbers: {}", name, suggestion(name, known)));
  }
  if (equals == std::string::npos) throw UsageError(fmt::format("--set: expected {}=NUMBER,...", name));
  const std::vector<double> values =
      numbers_between_commas(std::string_view(setting).substr(equals + 1), "--set " + name);
  state(job, *found, "--set " + name, values);
}

jobs::NewModelJob job_of(const NewModelArguments& arguments) {
  jobs::NewModelJob job = arguments.job;
  if (arguments.output != kStandardStream) job.file = arguments.output;
  if (!arguments.ini.empty()) job.control = jobs::ControlFiles{arguments.ini, arguments.hal};
  if (!arguments.hal.empty() && arguments.ini.empty())
    throw UsageError("--hal needs --ini: the unit of its lengths stands in the INI file");
  for (const jobs::JointRing* const ring : {&job.base, &job.platform}) {
    if (ring->radius_mm && !(*ring->radius_mm > 0))
      throw UsageError("--base-radius, --platform-radius: expected a positive number of mm");
  }
  if (!job.home_mm.empty() && job.home_mm.size() != 3)
    throw UsageError(fmt::format("--home: expected three numbers, not {}", job.home_mm.size()));
  if (!arguments.rotation.empty()) job.stated.push_back({"", "rotation", {}, arguments.rotation, "", false, {}});
  for (const NewModelArguments::Given& given : arguments.given) {
    if (!given.values.empty()) state(job, *given.spec, given.option, given.values);
  }
  for (const std::string& setting : arguments.settings) apply_setting(job, setting);
  return job;
}

// A model file is worked on by hand.
void refuse_to_write_over(const std::string& file, const std::string& text) {
  std::error_code none;
  if (!std::filesystem::is_regular_file(path_of(file), none) || read_text(file) == text) return;
  refuse("model-exists", "there is another file of this name already",
         "give another name with -o, or --force to write over it", {file, 0});
}

int new_model(const NewModelArguments& arguments) {
  const jobs::NewModelJob job = job_of(arguments);
  std::vector<std::string> inputs = arguments.hal;
  inputs.push_back(arguments.ini);
  check_outputs(inputs, {arguments.output});
  OutputFile out(arguments.output);
  const jobs::NewModel made = jobs::make_new_model(job);
  if (out.is_file() && !arguments.force) refuse_to_write_over(arguments.output, made.text);
  out.write(made.text);
  out.commit();
  say_note(report::new_model_text(made));
  return kDone;
}

std::string type_of(const machine::KeySpec& spec) {
  std::string unit = spec.unit.name.empty() ? "NUMBER" : std::string(spec.unit.name);
  for (char& c : unit) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  switch (spec.shape) {
    case machine::Shape::vector:
      return "X,Y,Z";
    case machine::Shape::range:
      return "FROM,TO";
    case machine::Shape::six:
      return unit + "[,...]";
    default:
      return unit;
  }
}

template <std::size_t N>
void add_keys(CLI::App& command, NewModelArguments& arguments, const KeyOption (&options)[N], const char* group) {
  for (const KeyOption& option : options) {
    const machine::KeySpec& spec = machine::key_spec(option.table, option.key);
    auto& given = arguments.given.emplace_back(NewModelArguments::Given{&spec, option.name, {}});
    command.add_option(option.name, given.values, std::string(spec.meaning))
        ->delimiter(',')
        ->type_name(type_of(spec))
        ->group(group);
  }
}

void add_ring(CLI::App& command, jobs::JointRing& ring, const std::string& name, const char* frame) {
  const char* const group = "Joints";
  command
      .add_option("--" + name + "-radius", ring.radius_mm, fmt::format("radius of the circle of the {}'s joints", name))
      ->type_name("MM")
      ->group(group);
  command
      .add_option("--" + name + "-angles", ring.angles_deg,
                  "where they lie on it, strut by strut, from +X towards +Y: six angles")
      ->type_name("DEG,...")
      ->delimiter(',')
      ->group(group);
  command.add_option("--" + name + "-height", ring.height_mm, fmt::format("Z of this circle in {}, else 0", frame))
      ->type_name("MM")
      ->group(group);
  command
      .add_option("--" + name + "-joints", ring.joints_mm,
                  fmt::format("in place of the circle: x,y,z of the six joints in {}, 18 numbers", frame))
      ->type_name("MM,...")
      ->delimiter(',')
      ->check(CLI::Number.description(""))
      ->group(group);
}

void add_files(CLI::App& command, NewModelArguments& arguments) {
  command.add_option("-o,--output", arguments.output, "the model file to write; default standard output")
      ->type_name("FILE");
  command.add_flag("--force", arguments.force, "write over a model file that is there");
  command.add_option("--name", arguments.job.name, "of the machine; default MACHINE of the INI file, or hexapod")
      ->type_name("NAME");
  command.add_option("--provenance", arguments.job.provenance, "where what you state comes from, for the file's head")
      ->type_name("TEXT");
  command.add_option("--ini", arguments.ini, "the INI file of LinuxCNC with the kinematics genhexkins")
      ->type_name("FILE");
  command
      .add_option("--hal", arguments.hal, "the HAL file that sets the joints; default those that the INI file names")
      ->type_name("FILE")
      ->expected(1)
      ->type_size(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

}  // namespace

void add_new_model(CLI::App& app, Run& run) {
  CLI::App* const command = app.add_subcommand(
      "new-model", "Write the model file of a machine from its dimensions or from its control's files, and check it");
  const auto arguments = std::make_shared<NewModelArguments>();
  add_files(*command, *arguments);
  add_ring(*command, arguments->job.base, "base", "W");
  add_ring(*command, arguments->job.platform, "platform", "P");
  command->add_option("--home", arguments->job.home_mm, "where the tool tip stands in the middle of its work, in W")
      ->type_name("X,Y,Z")
      ->delimiter(',')
      ->group("Joints");
  add_keys(*command, *arguments, kTipOptions, "Joints");
  add_keys(*command, *arguments, kLimitOptions, "Limits");
  add_keys(*command, *arguments, kPartOptions, "Masses, elasticity, friction");
  command
      ->add_option("--rotation", arguments->rotation, "the order in which A, B, C turn; ZYX is R = Rz(C) Ry(B) Rx(A)")
      ->type_name("ORDER");
  command->add_option("--set", arguments->settings, "any other key of the model file, as control.block_time_ms=2")
      ->type_name("TABLE.KEY=NUMBER[,...]")
      ->expected(1)
      ->type_size(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command->footer("What is neither stated nor in the control's files is assumed; such lines of the model say so.");
  command->callback([arguments, &run] { run = [arguments] { return new_model(*arguments); }; });
}

}  // namespace plumbline::cli
