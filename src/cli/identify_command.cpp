#include <map>
#include <memory>

#include "cli/command_files.hpp"
#include "cli/identified_output.hpp"
#include "cli/options/accept.hpp"
#include "cli/options/with.hpp"

namespace plumbline::cli {
namespace {

struct IdentifyArguments {
  std::string model, dataset;
  IdentifiedOutput output;
  identify::IdentifyOptions options;
  std::vector<std::string> accepted, with;
};

int identify_model(const IdentifyArguments& arguments) {
  return write_identified(inputs_of(arguments.dataset, {arguments.model}, arguments.with), arguments.output, [&] {
    return jobs::identify_model(arguments.model, arguments.dataset, arguments.options, arguments.accepted,
                                arguments.with);
  });
}

}  // namespace

void add_identify(CLI::App& app, Run& run) {
  CLI::App* const command = app.add_subcommand(
      "identify",
      "Learn the model's parameters from circular tests: masses, friction, compliance, where the joints really are");
  const auto arguments = std::make_shared<IdentifyArguments>();
  command->add_option("-m,--model", arguments->model, "the machine's model file")->type_name("MODEL")->required();
  command->add_option("-d,--dataset", arguments->dataset, "the measurements: a dataset.toml")
      ->type_name("DATASET")
      ->required();
  add_with(*command, arguments->with);
  add_identified_output(*command, arguments->output);
  const std::map<std::string, identify::Stages> stages{{"joint", identify::Stages::joint},
                                                       {"paper", identify::Stages::paper}};
  command
      ->add_option("--stages", arguments->options.stages,
                   "joint (the default): all that [uncertainty] lists, with its priors, from bar and torques together; "
                   "paper: masses and friction from torques, then K1 and K2 from the bar, without priors")
      ->type_name("joint|paper")
      ->transform(CLI::CheckedTransformer(stages).description(""));
  command
      ->add_option("--free", arguments->options.free,
                   "fit these keys, too, without a prior: table.key of the model file, or effect.key, as "
                   "strut.motor_mass_kg,level.tilt_mrad")
      ->type_name("KEY,...")
      ->delimiter(',');
  add_accept(*command, arguments->accepted);
  command->callback([arguments, &run] { run = [arguments] { return identify_model(*arguments); }; });
}

}  // namespace plumbline::cli
