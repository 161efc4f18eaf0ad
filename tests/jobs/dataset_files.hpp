// Small datasets for the tests of the jobs.
#pragma once

#include <filesystem>
#include <sstream>
#include <string>

#include <fmt/format.h>

#include "base/text/number_text.hpp"
#include "support/scratch.hpp"

namespace plumbline::testing {

/// A [[run]] of the paper's kind, its table NAME.csv, after `before`.
inline std::string run_text(const std::string& name, const std::string& direction, const std::string& before = "") {
  return before + fmt::format(
                      "\n[[run]]\nid = \"{0}\"\nfile = \"{0}.csv\"\ncentre_mm = [0, 100, -1008]\n"
                      "radius_mm = 144\nbar_mm = 150\ntilt_deg = [-25, 0, 0]\ndirection = \"{1}\"\n"
                      "feed_mm_min = 1000\nstart_s = 0.0\npayload_kg = 0\n",
                      name, direction);
}

/// Two runs, a counterclockwise and b clockwise, their tables full of zeros in the folder plan.
inline std::string plan_text(const Scratch& scratch) {
  std::filesystem::create_directories(scratch.path("plan"));
  const std::string header = "angle_deg,radial_um,torque1_Nm,torque2_Nm,torque3_Nm,torque4_Nm,torque5_Nm,torque6_Nm\n";
  std::string ccw = header;
  std::string cw = header;
  for (int i = 0; i < 120; ++i) {
    ccw += fmt::format("{}.000,0.0,0.00,0.00,0.00,0.00,0.00,0.00\n", 3 * i);
    cw += fmt::format("{}.000,0.0,0.00,0.00,0.00,0.00,0.00,0.00\n", (360 - 3 * i) % 360);
  }
  scratch.file("plan/a.csv", ccw);
  scratch.file("plan/b.csv", cw);
  return run_text("b", "cw", run_text("a", "ccw", "plumbline = \"dataset 1\"\nmachine = \"pm600-like\"\n"));
}

/// A table with every number of a column (1: the second) changed.
template <class Change>
std::string changed(const std::string& table, int column, const Change& change) {
  std::istringstream lines(table);
  std::string line;
  std::getline(lines, line);
  std::string text = line + "\n";
  while (std::getline(lines, line)) {
    std::istringstream cells(line);
    std::string cell;
    for (int i = 0; std::getline(cells, cell, ','); ++i) {
      text += i == 0 ? "" : ",";
      text += i == column ? fmt::format("{:.6f}", change(*parse_number(cell))) : cell;
    }
    text += "\n";
  }
  return text;
}

/// With `by` added, or times `by`.
inline std::string shifted(const std::string& table, double by, int column = 1) {
  return changed(table, column, [by](double number) { return number + by; });
}
inline std::string scaled(const std::string& table, double by, int column) {
  return changed(table, column, [by](double number) { return number * by; });
}

}  // namespace plumbline::testing
