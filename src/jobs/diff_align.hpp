// Which moves of one program correspond to which of another.
#pragma once

#include <optional>
#include <vector>

#include "jobs/diff.hpp"
#include "jobs/diff_moves.hpp"

namespace plumbline::jobs {

class Aligner {
 public:
  Aligner(MoveReader& a, MoveReader& b) : a_(a), b_(b) {}

  /// Handles the next moves of both programs; false when both have ended.
  bool next();
  /// What was found, to be taken once next() says that both have ended.
  DiffSummary take();

 private:
  bool align_rapid(const DiffMove& move);
  bool corresponds(const DiffMove& move, std::size_t ahead);
  bool align_cut(const DiffMove& move);
  double slack(const DiffMove& move) const;
  const DiffMove* piece(const DiffMove& move, std::size_t count);
  std::optional<std::size_t> count_by_number(const DiffMove& move);
  std::optional<std::size_t> count_by_time(const DiffMove& move);
  std::optional<std::size_t> count_by_distance(const DiffMove& move);
  bool lies_along(const DiffMove& move, std::size_t count);
  void take_match(const DiffMove& move, std::size_t count);
  void find_way_back();
  bool find_way_back(double tolerance);
  void leave_out(std::size_t count_a, std::size_t count_b);
  void note_shift(const AxisWords& shift, std::size_t line_a, std::size_t line_b);
  void note_time(const DiffMove& move, std::size_t count);

  MoveReader& a_;
  MoveReader& b_;
  DiffSummary summary_;
  AxisWords shift_;               // of B against A where the last moves ended
  bool has_shift_ = false;        // some moves were matched
  AxisWords at_b_;                // where B stands
  std::vector<AxisWords> found_;  // shifts along a move, end last
  std::array<double, kAxes> squares_{};
};

}  // namespace plumbline::jobs
