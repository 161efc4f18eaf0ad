// Reading tests/golden/pm600-like-static.csv.
#pragma once

#include <array>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "base/text/number_text.hpp"
#include "machine/axis_words.hpp"
#include "machine/machines.hpp"

namespace plumbline::testing {

struct GoldenRow {
  AxisWords words;  // mm, deg
  std::array<double, 6> length_mm;
  std::array<double, 6> nut_tension;  // N
  std::array<double, 6> stretch_um;
  std::array<double, 6> displacement;  // um, urad
};

inline std::vector<GoldenRow> golden_rows() {
  std::ifstream in(source_path("tests/golden/pm600-like-static.csv"));
  std::vector<GoldenRow> rows;
  std::string line;
  std::getline(in, line);
  while (std::getline(in, line)) {
    std::array<double, 30> numbers{};
    std::istringstream cells(line);
    for (double& number : numbers) {
      std::string cell;
      std::getline(cells, cell, ',');
      number = parse_number(cell).value();
    }
    const auto six = [&](std::size_t at) {
      std::array<double, 6> values{};
      std::copy_n(numbers.begin() + static_cast<std::ptrdiff_t>(at), 6, values.begin());
      return values;
    };
    rows.push_back({{six(0)}, six(6), six(12), six(18), six(24)});
  }
  return rows;
}

}  // namespace plumbline::testing
