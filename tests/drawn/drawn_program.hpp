// A program drawn from a seed, with all that its control would know besides.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/axes.hpp"
#include "settings/options.hpp"

namespace plumbline::drawn {

/// One line, or a few that belong together: a loop, a subprogram with its calls.
struct DrawnBlock {
  std::string text;               // without the last line end
  std::optional<AxisWords> ends;  // where the axes stand after it, in the work system then active: mm and deg
};

struct DrawnProgram {
  std::string dialect;
  std::uint64_t seed = 0;
  settings::Options options;
  std::vector<DrawnBlock> blocks;
  AxisWords start;  // where the machine stands at first, in W

  std::string text() const {
    std::string all;
    for (const DrawnBlock& block : blocks) all += block.text + "\n";
    return all;
  }
};

/// Files that options name.
struct Scene {
  std::string model, zero_model, tools;
};

/// Everything follows from dialect, seed and scene.
DrawnProgram draw(std::string_view dialect, std::uint64_t seed, const Scene& scene);

/// The tools of the scene: lengths in mm.
inline constexpr std::size_t kTools = 3;
inline constexpr double kToolLengths[kTools] = {50.8, 88.9, 101.6};

/// Where the zero of the box lies that programs stay in, in W.
inline constexpr AxisWords kBox{{0, 0, -1008, 0, 0, 0}};

}  // namespace plumbline::drawn
