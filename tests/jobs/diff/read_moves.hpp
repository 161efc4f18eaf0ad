// Two programs as a diff reads them.
#pragma once

#include "jobs/diff/moves.hpp"
#include "support/scratch.hpp"

namespace plumbline::testing {

/// The moves of a text of LinuxCNC, offsets and start at zero.
class ReadMoves {
 public:
  explicit ReadMoves(std::string_view text)
      : file_(scratch_.file("p.ngc", text)), queue_(file_, nc::dialect("linuxcnc"), settings()) {}
  jobs::MoveQueue& queue() { return queue_; }

 private:
  static nc::ProgramSettings settings() {
    nc::ProgramSettings settings;
    settings.as_with_empty_tables = true;
    return settings;
  }
  Scratch scratch_;
  InputFile file_;
  jobs::MoveQueue queue_;
};

}  // namespace plumbline::testing
