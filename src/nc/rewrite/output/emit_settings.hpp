// What a user asks of the numbers and the comments of an output.
#pragma once

#include <string>
#include <vector>

namespace plumbline::nc {

/// How numbers are written and what the control keeps of them.
struct EmitSettings {
  int digits_mm = 4;
  int digits_deg = 5;
  int digits_inch = 6;
  double increment_mm = 0;  // what the control resolves; 0: whatever is written
  double increment_deg = 0;
  double increment_ratio = 1;    // --input-increment over the dialect's own
  double time_tolerance = 1e-3;  // F is written only where a block's time would change by more than this share
  /// A piece takes its share of the block's time, not only all of them together the whole.
  bool keep_piece_times = false;
  std::vector<std::string> stamp;       // texts of the comments that mark the output
  std::vector<std::string> guard = {};  // whole lines after the stamp
};

}  // namespace plumbline::nc
