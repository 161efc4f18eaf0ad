// A path as it is drawn: at each of its points how the machine stands, what it carries, and what its tip does.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "compensate/recorded/path_record.hpp"

namespace plumbline::compensate {

struct DrawnPoint {
  RecordedPoint recorded;
  machine::Vector6<double> uncorrected;  // error at the tip of a machine that is told what the original says: m, rad
  machine::Vector6<double> left;         // the same, told what the output says: from the pose of the original
  machine::PerStrut<double> lengths;     // as commanded, m
  machine::PerStrut<double> tension;     // of the nuts, N
  double condition = 0;                  // of the Jacobian
  Pose<double> stands;                   // as commanded, of the tip in W
  double tip_z = 0;                      // of the tool in P, m
  bool gives_way = false;                // the model does not say where it stands
};

struct DrawnPath {
  std::vector<DrawnPoint> points;
  std::uint64_t of_points = 0;  // that the path has
  bool has_machine = true;      // else a point holds what was recorded, and nothing more
};

/// The text of the output from one byte up to another one.
using OutputText = std::function<std::string(std::uint64_t begin, std::uint64_t end)>;

/// What a record kept, played on the model. `text` reads the output, where there is one.
DrawnPath drawn_path(PathRecord& record, const machine::MachineModel& model, const Settings& settings,
                     const OutputText& text = {});
/// The same of a record without a machine.
DrawnPath drawn_path(PathRecord& record);

}  // namespace plumbline::compensate
