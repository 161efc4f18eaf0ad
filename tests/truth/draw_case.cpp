// plumbline_draw_case: draws a machine, its measurements and what is hidden in them from a seed, and writes them.
#include <cstdio>
#include <exception>
#include <map>

#include <CLI/CLI.hpp>

#include "truth/drawn_case.hpp"

namespace {

int draw(int argc, char** argv) {
  CLI::App app("Draws a blind case: a machine whose model misses something that its measurements hold.");
  truth::CaseOptions options;
  std::string machine = "pm";
  std::string out;
  double radial_um = 0.5;
  bool quick = false;
  app.add_option("--seed", options.seed, "everything follows from it")->capture_default_str();
  app.add_option("--machine", machine, "pm, wide, tall, heavy, small, or a model file")->capture_default_str();
  app.add_option("--effect", options.effect, "a name, none, any, outside, outside:NAME, two, two:A,B")
      ->capture_default_str();
  app.add_option("--snr", options.snr, "how strongly each effect shows after the nuisances took their part");
  app.add_option("--plan", options.plan, "eight-pose, paper or figures")->capture_default_str();
  app.add_option("--samples", options.samples, "of a run")->capture_default_str();
  app.add_option("--noise", options.colour, "white, mixed or red")
      ->transform(CLI::CheckedTransformer(std::map<std::string, truth::Colour>{
          {"white", truth::Colour::white}, {"mixed", truth::Colour::mixed}, {"red", truth::Colour::red}}));
  app.add_option("--memory", options.memory, "what a sample of coloured noise keeps of the one before")
      ->capture_default_str();
  app.add_option("--radial-noise-um", radial_um)->capture_default_str();
  app.add_option("--torque-noise-Nm", options.torque_noise)->capture_default_str();
  app.add_option("--friction", options.law, "tanh, root, dahl or stribeck")
      ->transform(CLI::CheckedTransformer(
          std::map<std::string, truth::FrictionLaw>{{"tanh", truth::FrictionLaw::tanh},
                                                    {"root", truth::FrictionLaw::root},
                                                    {"dahl", truth::FrictionLaw::dahl},
                                                    {"stribeck", truth::FrictionLaw::stribeck}}));
  app.add_option(
      "--programs", options.programs,
      "folder with ID.jsonl for each run of the plan: what plumbline trace says of the program to run instead");
  app.add_flag("--quick", quick, "do not look for effects that look alike");
  app.add_option("-o", out, "folder")->required();
  CLI11_PARSE(app, argc, argv);
  const bool named = machine.find('/') == std::string::npos && machine.find(".toml") == std::string::npos;
  options.machine = named ? std::string(PLUMBLINE_TRUTH_MACHINES) + "/" + machine + ".toml" : machine;
  options.radial_noise = radial_um * 1e-6;
  options.look_alikes = !quick;
  if (options.effect != "none" && options.snr <= 0) throw std::runtime_error("an effect needs --snr");
  truth::write_case(truth::draw_case(options), out);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return draw(argc, argv);
  } catch (const std::exception& problem) {
    std::fputs(problem.what(), stderr);
    std::fputc('\n', stderr);
    return 1;
  }
}
