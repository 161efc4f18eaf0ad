// plumbline_play_joints: plays the strut lengths that a control asked for on a machine, and says how far its tip is
// from the path meant.
#include <fstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "truth/case_options.hpp"
#include "truth/run_main.hpp"
#include "truth/sampled.hpp"

namespace {

int play(int argc, char** argv) {
  CLI::App app(
      "Plays sampled strut lengths on the machine of a model, and says how far its tip is from the path meant.");
  truth::CaseOptions options;
  std::string meant;
  std::string recording;
  std::string table;
  bool without_friction = false;
  truth::add_case_options(app, options);
  app.add_option("--meant", meant, "trace of the program whose path is meant")->required();
  app.add_option("--table", table, "CSV: time of each period in which the control cuts (s), the tip off the path (um)");
  app.add_flag("--no-friction", without_friction, "the screws have no friction");
  app.add_option("RECORDING", recording, "what halsampler -t printed: counter, six lengths (mm), motion type")
      ->required();
  CLI11_PARSE(app, argc, argv);
  truth::Truth machine{truth::read_model(options.machine).machine, {}};
  if (without_friction) machine.machine.friction = {};
  const truth::Followed followed =
      truth::follow(machine, truth::read_program(meant), truth::read_recording(recording), options.law);
  if (!table.empty()) {
    std::ofstream rows(table);
    rows << "time_s,off_um\n";
    for (const truth::OffPath& row : followed.cutting) rows << fmt::format("{:.3f},{:.4f}\n", row.time, 1e6 * row.off);
    rows.close();
    if (!rows) throw std::runtime_error("cannot write " + table);
  }
  fmt::print("{}\n", nlohmann::ordered_json{{"seconds", followed.seconds},
                                            {"samples", followed.cutting.size()},
                                            {"most_um", 1e6 * followed.most},
                                            {"rms_um", 1e6 * followed.rms}}
                         .dump());
  return 0;
}

}  // namespace

int main(int argc, char** argv) { return truth::run_main(play, argc, argv); }
