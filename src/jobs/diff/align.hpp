// Which moves of one program correspond to which of another.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "jobs/diff/candidates.hpp"
#include "jobs/diff/diff.hpp"
#include "jobs/diff/moves.hpp"

namespace plumbline::jobs {

class Aligner {
 public:
  /// `time_tolerance`: the share of a block's time that B may have changed. `record` gets where B's moves end and where
  /// A has them; it may be null.
  Aligner(MoveQueue& a, MoveQueue& b, double time_tolerance, compensate::PathRecord* record = nullptr)
      : a_(a), b_(b), candidates_(a, b, time_tolerance), record_(record) {}

  /// Handles the next moves of both programs; false when both have ended.
  bool next();
  /// What was found, to be taken once next() says that both have ended.
  DiffSummary take();

 private:
  bool align(const DiffMove& move);
  double usual_after(const AxisWords& shift) const;
  Standing standing(std::size_t i, std::size_t j);
  double cost_ahead(std::size_t i, std::size_t j, std::size_t depth);
  bool lies_along(const DiffMove& move, std::size_t count);
  void take_match(const DiffMove& move, std::size_t count);
  void find_way_back();
  bool find_way_back(double tolerance);
  void leave_out(std::size_t count_a, std::size_t count_b);
  void note_shift(const AxisWords& shift, std::size_t line_a, std::size_t line_b);
  void note_time(const DiffMove& move, std::size_t count);
  void record(const DiffMove& move, std::size_t count);

  MoveQueue& a_;
  MoveQueue& b_;
  Candidates candidates_;
  compensate::PathRecord* record_;
  double recorded_s_ = 0;                                        // of B, so far
  std::map<std::pair<std::size_t, std::size_t>, double> ahead_;  // costs that were worked out
  DiffSummary summary_;
  AxisWords shift_;               // of B against A where the last moves ended
  bool has_shift_ = false;        // some moves were matched
  double usual_shift_ = 0;        // how large shifts were lately
  AxisWords at_b_;                // where B stands
  std::vector<AxisWords> found_;  // shifts along a move, end last
  std::array<double, kAxes> squares_{};
};

}  // namespace plumbline::jobs
