// The option that joins further datasets with the first one.
#pragma once

#include <string>
#include <vector>

#include "cli/command.hpp"

namespace plumbline::cli {

inline void add_with(CLI::App& command, std::vector<std::string>& with) {
  command
      .add_option("--with", with,
                  "a further dataset of the same machine, joined with that of -d; may be given several times. A run "
                  "whose id an earlier dataset has is called ID@2, ID@3, ...")
      ->type_name("DATASET")
      ->expected(1)
      ->type_size(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

}  // namespace plumbline::cli
