#include "truth/case_options.hpp"

#include <map>
#include <stdexcept>

namespace truth {
namespace {

std::string file_of(const std::string& machine) {
  const bool named = machine.find('/') == std::string::npos && machine.find(".toml") == std::string::npos;
  return named ? std::string(PLUMBLINE_TRUTH_MACHINES) + "/" + machine + ".toml" : machine;
}

}  // namespace

void add_case_options(CLI::App& app, CaseOptions& options) {
  options.machine = file_of("pm");
  app.add_option("--seed", options.seed, "everything follows from it")->capture_default_str();
  app.add_option_function<std::string>(
      "--machine", [&options](const std::string& machine) { options.machine = file_of(machine); },
      "pm, wide, tall, heavy, small, or a model file");
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
  app.add_option_function<double>("--radial-noise-um", [&options](double um) { options.radial_noise = um * 1e-6; });
  app.add_option("--torque-noise-Nm", options.torque_noise)->capture_default_str();
  app.add_option("--friction", options.law, "tanh, root, dahl or stribeck")
      ->transform(CLI::CheckedTransformer(
          std::map<std::string, truth::FrictionLaw>{{"tanh", truth::FrictionLaw::tanh},
                                                    {"root", truth::FrictionLaw::root},
                                                    {"dahl", truth::FrictionLaw::dahl},
                                                    {"stribeck", truth::FrictionLaw::stribeck}}));
}

void check_case_options(const CaseOptions& options) {
  if (options.effect != "none" && options.snr <= 0) throw std::runtime_error("an effect needs --snr");
}

}  // namespace truth
