#include <algorithm>
#include <array>
#include <filesystem>
#include <list>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/files/path_of.hpp"
#include "base/units.hpp"
#include "cli/command.hpp"
#include "cli/command_files.hpp"
#include "cli/options/number_check.hpp"
#include "cli/options/number_list.hpp"
#include "cli/options/report_file.hpp"
#include "cli/options/test_dialect.hpp"
#include "cli/options/with.hpp"
#include "jobs/plan.hpp"
#include "jobs/test_program.hpp"
#include "machine/model_file.hpp"
#include "report/measured/plan_text.hpp"
#include "report/page/plan_page.hpp"

namespace plumbline::cli {
namespace {

// Readings of a bar come in steps of 0.1 um at best, those of torques in thousandths of what a motor gives: less noise
// than a hundredth of that makes errors of nothing, and so does more than what is measured.
constexpr double kLeastNoise = 1e-3, kMostNoise = 1e3;  // um, N m
constexpr double kMostPayload = 1000;                   // kg, as a dataset takes it

// As the command line says it, in its units.
struct PlanArguments {
  jobs::PlanJob job;
  std::string folder, json, report, programs;
  std::string dialect = "linuxcnc";
  std::vector<double> radii_mm{144}, feeds_mm_min{1000}, payloads_kg{0};
  std::string box_mm;
  std::vector<double> tilts_deg{0};
  double bar_mm = 150;
  double radial_um = 0.5;
  std::string channels = "both";
  bool for_given = false;
};

// "X0:X1,Y0:Y1,Z0:Z1"
std::array<std::optional<machine::Range>, 3> box_of(const std::string& text) {
  std::string flat = text;
  std::replace(flat.begin(), flat.end(), ':', ',');
  const auto wrong = [&] { return UsageError(fmt::format("--box {}: expected X0:X1,Y0:Y1,Z0:Z1 in mm", text)); };
  std::string marks;
  for (const char c : text) {
    if (c == ':' || c == ',') marks += c;
  }
  if (marks != ":,:,:") throw wrong();
  const std::vector<double> ends = numbers_between_commas(flat, "--box " + text);
  std::array<std::optional<machine::Range>, 3> box;
  for (std::size_t a = 0; a < 3; ++a) box[a] = machine::Range{ends[2 * a] * kMm, ends[2 * a + 1] * kMm};
  return box;
}

// What the plan is for, as the job has it.
void take_aim(const PlanArguments& arguments, jobs::PlanJob& job) {
  if (!job.separate.empty() && job.separate.size() != 2) throw UsageError("--separate names two effects, as in A,B");
  if (job.separate.size() == 2 && job.separate[0] == job.separate[1]) {
    throw UsageError(
        fmt::format("--separate {0},{0}: an effect cannot be told from itself; name two", job.separate[0]));
  }
  if (!job.separate.empty() && arguments.for_given) {
    throw UsageError("--separate is in place of --for: say one of them");
  }
  const bool tip = std::find(job.asked.begin(), job.asked.end(), "tip") != job.asked.end();
  if (tip && job.asked.size() > 1) throw UsageError("--for tip goes by itself: it asks for what the tip needs of all");
  if (tip && job.separate.empty()) {
    if (!arguments.box_mm.empty()) job.box.box = box_of(arguments.box_mm);
    job.box.tilts.clear();
    for (const double tilt : arguments.tilts_deg) job.box.tilts.push_back(tilt * kDeg);
  } else if (!arguments.box_mm.empty() || arguments.tilts_deg != std::vector<double>{0}) {
    throw UsageError("--box and --tilts say where --for tip is to be certain, and the plan is for something else");
  }
}

jobs::PlanJob job_of(const PlanArguments& arguments) {
  jobs::PlanJob job = arguments.job;
  take_aim(arguments, job);
  identify::CandidateOptions& candidates = job.candidates;
  candidates.radii.clear();
  for (const double mm : arguments.radii_mm) candidates.radii.push_back(mm * kMm);
  candidates.feeds.clear();
  for (const double feed : arguments.feeds_mm_min) candidates.feeds.push_back(feed * kMmPerMin);
  candidates.payloads = arguments.payloads_kg;
  candidates.bar = arguments.bar_mm * kMm;
  candidates.bar_readings = arguments.channels != "torques";
  candidates.torques = arguments.channels != "bar";
  job.radial_noise = arguments.radial_um * kUm;
  return job;
}

struct NamedProgram {
  std::string path, text;
};

std::vector<NamedProgram> programs_of(const PlanArguments& arguments, const machine::MachineModel& machine,
                                      const measure::Dataset& dataset) {
  const nc::Dialect& dialect = nc::dialect(arguments.dialect);
  std::vector<NamedProgram> programs;
  for (const measure::Run& run : dataset.runs) {
    const std::filesystem::path path = path_of(arguments.programs) / path_of(jobs::test_program_name(run.id, dialect));
    programs.push_back({path.generic_string(), jobs::test_program(machine, run, dialect)});
  }
  return programs;
}

report::Page page_of(const jobs::PlannedTests& planned, const machine::MachineModel& machine,
                     const std::vector<NamedProgram>& programs) {
  std::vector<std::string> texts;
  for (const NamedProgram& program : programs) texts.push_back(program.text);
  const jobs::RunsAndModels predicted{{}, jobs::run_profiles(planned.dataset.runs, {}), "predicted"};
  return report::plan_page(planned, machine, texts, predicted);
}

int plan(const PlanArguments& arguments) {
  const jobs::PlanJob job = job_of(arguments);
  const std::vector<std::string> inputs = inputs_of(job.measured, {job.model}, job.with);
  check_outputs(inputs, {arguments.json, arguments.report});
  JsonResult json(arguments.json);
  ReportFile page(arguments.report);
  const jobs::PlannedTests planned = jobs::plan_tests(job);
  const machine::MachineModel machine = machine::read_model(job.model);
  const std::vector<NamedProgram> programs = programs_of(arguments, machine, planned.dataset);
  OutputSet files;
  std::optional<NewFolder> folder;
  std::list<OutputFile> outputs;
  if (!arguments.programs.empty()) {
    std::vector<std::string> names{arguments.json, arguments.report};
    for (const NamedProgram& program : programs) names.push_back(program.path);
    check_outputs(inputs, names);
    folder.emplace(arguments.programs);
    for (const NamedProgram& program : programs) {
      outputs.emplace_back(program.path).write(program.text);
      files.add(outputs.back());
    }
  }
  json.add_to(files, report::plan_json(planned));
  page.add_to(files, [&] { return page_of(planned, machine, programs); });
  if (!arguments.folder.empty()) jobs::write_plan(planned, arguments.folder);
  files.commit();
  if (folder) folder->keep();
  if (!json.takes_standard_output() && !page.takes_standard_output()) print_result(report::plan_text(planned));
  return kDone;
}

void add_aim(CLI::App& command, PlanArguments& arguments) {
  command
      .add_option(
          "--for", arguments.job.asked,
          "what the plan is to tell: geometry, elasticity, friction, masses, centre-of-mass, level, all, or keys "
          "as strut.motor_mass_kg and cyclic.amplitude_um; or tip: where the tip is, over --box")
      ->type_name("NAME,...")
      ->delimiter(',')
      ->capture_default_str();
  command
      .add_option("--box", arguments.box_mm,
                  "of --for tip: from and to of the tool tip in X, Y and Z of W, mm; default the middle half of the "
                  "model's travel")
      ->type_name("X0:X1,Y0:Y1,Z0:Z1");
  command
      .add_option("--tilts", arguments.tilts_deg,
                  "of --for tip: how far the platform is tilted there, to all four sides, about A and about B")
      ->type_name("DEG,...")
      ->delimiter(',')
      ->check(CLI::Range(0.0, 90.0).description(""))
      ->capture_default_str();
  command
      .add_option("--separate", arguments.job.separate,
                  "two effects of the catalogue that the plan is to tell apart, in place of --for")
      ->type_name("A,B")
      ->delimiter(',');
  command.add_option("-n,--runs", arguments.job.design.runs, "how many circular tests")
      ->type_name("N")
      ->check(CLI::Range(1, 200))
      ->capture_default_str();
  command.add_option("-d,--dataset", arguments.job.measured, "what was measured already: the plan adds to it")
      ->type_name("DATASET");
  add_with(command, arguments.job.with);
}

void add_circles(CLI::App& command, PlanArguments& arguments) {
  const auto list = [&](const char* name, std::vector<double>& values, const CLI::Validator& check, const char* type,
                        const char* help) {
    command.add_option(name, values, help)->type_name(type)->delimiter(',')->check(check)->capture_default_str();
  };
  // as a dataset takes them
  list("--radius", arguments.radii_mm, number_between(1, 2000), "MM,...", "radii of circles to choose from");
  list("--feed", arguments.feeds_mm_min, number_between(1, 2e5), "MM/MIN,...", "feeds to choose from");
  list("--payload", arguments.payloads_kg, number_between(0, kMostPayload), "KG,...",
       "known masses at the tool tip to choose from");
  command.add_option("--bar", arguments.bar_mm, "length of the bar, mm; it lies in the plane of larger circles")
      ->type_name("MM")
      ->check(number_between(1, 3000))
      ->capture_default_str();
  command.add_option("--channels", arguments.channels, "what will be measured")
      ->type_name("bar|torques|both")
      ->check(CLI::IsMember({"bar", "torques", "both"}).description(""))
      ->capture_default_str();
  command.add_option("--samples", arguments.job.samples, "samples of a run")
      ->type_name("N")
      ->check(CLI::Range(8, 100000))
      ->capture_default_str();
}

void add_noise(CLI::App& command, PlanArguments& arguments) {
  command.add_option("--bar-noise", arguments.radial_um, "1 sigma of a reading of the bar, um")
      ->type_name("UM")
      ->check(number_between(kLeastNoise, kMostNoise))
      ->capture_default_str();
  command.add_option("--torque-noise", arguments.job.torque_noise, "1 sigma of a torque, N m")
      ->type_name("NM")
      ->check(number_between(kLeastNoise, kMostNoise))
      ->capture_default_str();
  command.add_option("--candidates", arguments.job.candidates.most, "how many circles are drawn to choose from")
      ->type_name("N")
      ->check(CLI::Range(1, 20000))
      ->capture_default_str();
  command.add_option("--seed", arguments.job.candidates.seed, "of the random numbers that draw them")
      ->check(whole_number())
      ->capture_default_str();
}

}  // namespace

void add_plan(CLI::App& app, Run& run) {
  CLI::App* const command = app.add_subcommand(
      "plan", "Propose the circular tests that tell most of what is asked for, within the machine's limits");
  const auto arguments = std::make_shared<PlanArguments>();
  command->add_option("-m,--model", arguments->job.model, "the machine's model file")->type_name("MODEL")->required();
  add_aim(*command, *arguments);
  add_circles(*command, *arguments);
  add_noise(*command, *arguments);
  command->add_option("-o,--output", arguments->folder, "write the plan as a dataset into this folder")
      ->type_name("DIR");
  command->add_option("--json", arguments->json, "write runs and standard errors as JSON, too")->type_name("FILE");
  add_report_option(*command, arguments->report);
  command->add_option("--programs", arguments->programs, "write an NC program of each circle into this folder")
      ->type_name("DIR");
  add_test_dialect(*command, arguments->dialect);
  command->callback([arguments, command, &run] {
    arguments->for_given = command->count("--for") > 0;
    run = [arguments] { return plan(*arguments); };
  });
}

}  // namespace plumbline::cli
