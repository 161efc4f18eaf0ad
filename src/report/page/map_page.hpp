// The page of a map of the workspace.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "jobs/workspace_map.hpp"
#include "report/page/page.hpp"

namespace plumbline::report {

/// More poses than a page is drawn from.
inline constexpr std::uint64_t kMostPosesOfPage = 200000;

/// Collects the cells of a map, and makes the page: a map of colours for each plane and tilt, the worst of each, how
/// much of the reach is within what, the worst places, and why poses are out of reach.
class MapPage {
 public:
  /// For a grid of at most kMostPosesOfPage poses. Refuses with map-page a larger one.
  MapPage(const machine::MachineModel& model, const jobs::MapOptions& options);
  /// In the order of map_workspace.
  void add(const jobs::MapCell& cell);
  Page page(const jobs::MapSummary& summary) const;

 private:
  Json colours(const jobs::MapSummary& summary) const;
  Json planes(const jobs::MapSummary& summary) const;
  std::string plane_name(std::size_t plane) const;

  std::string machine_;
  jobs::WorkspaceGrid grid_;
  std::vector<std::vector<double>> columns_;  // error, uncertainty, stiffness, condition, force; NaN: out of reach
  std::vector<int> reasons_;                  // of each cell, -1: in reach
  std::vector<std::string> reason_texts_;
  std::map<std::string, int> reason_of_;
};

}  // namespace plumbline::report
