// plumbline_play_case: runs programs on the machine of a drawn case, and says how far its tip is from the path meant.

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "truth/case_options.hpp"
#include "truth/played.hpp"
#include "truth/run_main.hpp"

namespace {

nlohmann::ordered_json in_um(const truth::Vec& off) { return {1e6 * off.x(), 1e6 * off.y(), 1e6 * off.z()}; }

nlohmann::ordered_json points_of(const truth::Offs& offs) {
  nlohmann::ordered_json along = nlohmann::ordered_json::array();
  for (const truth::Off& off : offs.along) along.push_back({{"time_s", off.time}, {"off_um", in_um(off.off)}});
  return {{"zero_um", in_um(offs.zero)}, {"points", std::move(along)}};
}

int play(int argc, char** argv) {
  CLI::App app("Plays programs, as plumbline trace lists them, on the machine that a case was drawn from.");
  truth::CaseOptions options;
  std::string meant;
  std::vector<std::string> programs;
  double step = 0.25;
  std::string at_rest;
  truth::add_case_options(app, options);
  options.look_alikes = false;
  app.add_option("--meant", meant, "trace of the program whose path is meant")->required();
  app.add_option("--step", step, "s from one look at the tip to the next")->capture_default_str();
  app.add_option(
      "--points", at_rest,
      "say of each look where the tip is beside the path, um, and of a machine at rest where this trace begins");
  app.add_option("programs", programs, "traces of programs to run")->required();
  CLI11_PARSE(app, argc, argv);
  truth::check_case_options(options);
  const truth::Truth machine = truth::draw_truth(options);
  const truth::Program path = truth::read_program(meant);
  nlohmann::ordered_json results = nlohmann::ordered_json::array();
  for (const std::string& program : programs) {
    const truth::Played played = truth::play(machine, path, truth::read_program(program), options.law, step);
    results.push_back({{"rms_um", 1e6 * played.rms},
                       {"most_um", 1e6 * played.most},
                       {"probed_rms_um", 1e6 * played.probed_rms},
                       {"probed_most_um", 1e6 * played.probed_most},
                       {"samples", played.samples}});
    if (at_rest.empty()) continue;
    const truth::Offs offs =
        truth::offs(machine, path, truth::read_program(program), truth::read_program(at_rest), options.law, step);
    results.back().update(points_of(offs));
  }
  fmt::print("{}\n", results.dump(1));
  return 0;
}

}  // namespace

int main(int argc, char** argv) { return truth::run_main(play, argc, argv); }
