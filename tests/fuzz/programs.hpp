// How the targets that take a whole program run it.
#pragma once

#include "fuzz/fuzz.hpp"
#include "nc/sequence/program.hpp"

namespace plumbline::fuzz {

inline constexpr std::uint64_t kMostBlocks = 2000;  // a program that does not end is no finding

/// Everything is given: offsets, tools, where the axes stand.
inline nc::ProgramSettings everything_known() {
  nc::ProgramSettings settings;
  settings.max_blocks = kMostBlocks;
  settings.work_offsets[0] = nc::WorkOffset{{{0, 0, -1008, 0, 0, 0}}, 0};
  settings.work_offsets[1] = nc::WorkOffset{{{10, -5, -1000, 1, 0, 0.5}}, 30};
  settings.start.fill(0.0);
  nc::Tool long_one{1, 85, 16, 1.4, 22};
  nc::Tool short_one{2, 40, {}, {}, {}, "MILL8"};
  settings.tools = nc::ToolTable({long_one, short_one});
  settings.variables = {{100, 1.5}, {5161, 0}, {5162, 0}, {5163, 50}};
  settings.block_delete = true;
  return settings;
}

/// Nothing is given, and whoever asks is told zero: as trace does.
inline nc::ProgramSettings empty_tables() {
  nc::ProgramSettings settings;
  settings.max_blocks = kMostBlocks;
  settings.as_with_empty_tables = true;
  settings.position_may_be_read = true;
  settings.block_delete = false;
  return settings;
}

/// Nothing is given, and whoever asks is refused.
inline nc::ProgramSettings nothing_known() {
  nc::ProgramSettings settings;
  settings.max_blocks = kMostBlocks;
  return settings;
}

}  // namespace plumbline::fuzz
