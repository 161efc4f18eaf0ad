// The moves of a program as a diff looks at them: where each ends in W, how long it is, how long it takes.
#pragma once

#include <deque>
#include <optional>
#include <string>

#include "base/files/files.hpp"
#include "compensate/move_reader.hpp"
#include "path/curve.hpp"

namespace plumbline::jobs {

/// One move, dwells left out.
struct DiffMove {
  std::size_t line = 0;
  std::string number;  // the N word as it stands; empty: none
  nc::MotionKind kind = nc::MotionKind::rapid;
  bool in_machine_coordinates = false;
  AxisWords end;                  // tool tip in W, mm and deg; in machine coordinates: the control's display
  double length = 0;              // mm of path and deg of turn together
  std::optional<double> effort;   // seconds, or revolutions under G95; rapids: not known
  std::optional<double> seconds;  // rapids and G95: not known; nor where it turns and nobody says whether F counts that
  nc::Frame frame;
  path::Curve curve;                  // in the work system
  std::optional<bool> states_code{};  // the block says how it moves: G1; nothing: one of several moves of a cycle
  bool begins_numbered = false;       // an N stands after the move before it, maybe in a block that does not move
  std::string text;                   // of its block, where it is kept

  bool cuts() const { return kind == nc::MotionKind::feed || kind == nc::MotionKind::arc; }
  /// The point at a fraction of the move, in W.
  AxisWords at(double fraction) const { return frame.to_pose(curve.at(fraction)); }
};

/// Distance of two positions: mm and deg together.
double distance(const AxisWords& a, const AxisWords& b);

/// Reads a program move by move and can look ahead.
class MoveQueue {
 public:
  /// References must outlive it.
  MoveQueue(const InputFile& file, const nc::Dialect& dialect, const nc::ProgramSettings& settings);

  /// From here on the moves have the texts of their blocks.
  void keep_texts() { keeps_texts_ = true; }

  /// The move `ahead` places from here; null after the last one. Valid until the next drop().
  const DiffMove* peek(std::size_t ahead);
  /// Goes on after the next `count` moves, which were looked at before.
  void drop(std::size_t count);

  std::uint64_t moves() const { return moves_; }        // read so far
  double dwell_seconds() const { return dwell_s_; }     // read so far
  std::uint64_t bytes_read() const { return offset_; }  // of the file

 private:
  bool read_more();
  const nc::Dialect& dialect_;
  compensate::MoveReader reader_;
  std::deque<DiffMove> moves_ahead_;
  bool keeps_texts_ = false;
  bool numbered_ = false;  // an N was read after the last move
  std::uint64_t moves_ = 0;
  std::uint64_t offset_ = 0;
  double dwell_s_ = 0;
};

}  // namespace plumbline::jobs
