// The option with which data that look spoiled are taken as they are.
#pragma once

#include <string>
#include <vector>

#include "cli/command.hpp"

namespace plumbline::cli {

inline void add_accept(CLI::App& command, std::vector<std::string>& accepted) {
  command
      .add_option(
          "--accept", accepted,
          "take these runs as they are, though plumbline inspect says that something is wrong with them: ids, or "
          "all for what is wrong alike with all runs")
      ->type_name("RUN,...")
      ->delimiter(',');
}

}  // namespace plumbline::cli
