// The tools that a program uses: length for the geometry, mass and centre of mass for the load.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/files/source.hpp"

namespace plumbline::nc {

struct Tool {
  int number = 0;
  double length_mm = 0;  // from the gauge point to the tip, along -Z of P
  std::optional<double> diameter_mm;
  std::optional<double> mass_kg;
  std::optional<double> centre_of_mass_mm;  // from the gauge point towards the tip
  std::string name;                         // as in T="MILL10"; empty: called by its number alone
};

/// True where a tool's name in a program, as in T="12", is its number; T="012" is a name, letter for letter.
bool is_tool_number(std::string_view name);

class ToolTable {
 public:
  ToolTable() = default;
  explicit ToolTable(std::vector<Tool> tools) : tools_(std::move(tools)) {}
  const Tool* find(int number) const;
  const Tool* find(std::string_view name) const;  // letter for letter
  bool empty() const { return tools_.empty(); }
  const std::vector<Tool>& all() const { return tools_; }

 private:
  std::vector<Tool> tools_;
};

/// Reads a tool table (`plumbline = "tools 1"`, [[tool]] rows), or LinuxCNC's own. Refuses with tools-... and the
/// place.
ToolTable read_tool_table(const Source& source);

}  // namespace plumbline::nc
