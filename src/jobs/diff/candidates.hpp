// How many moves of the second program may be one move of the first, and how well each number fits.
#pragma once

#include <optional>
#include <vector>

#include "base/axes.hpp"
#include "jobs/diff/moves.hpp"

namespace plumbline::jobs {

/// So many moves of B.
struct Candidate {
  std::size_t count = 0;
  double cost = 0;       // 0: fits in every way; what rounding and friction do stays below about 3
  bool in_time = false;  // takes the time of the move
};

/// Where both programs stand before a move.
struct Standing {
  AxisWords b;             // where B stands
  AxisWords shift;         // of B against A there
  bool has_shift = false;  // some moves were matched
  double usual = 0;        // how large shifts are thereabouts, mm and deg together: at least this one
};

class Candidates {
 public:
  /// `time_tolerance`: the share of a block's time that B may have changed.
  Candidates(MoveQueue& a, MoveQueue& b, double time_tolerance) : a_(a), b_(b), time_tolerance_(time_tolerance) {}

  /// Of the move of A that is `i` ahead, from the move of B that is `j` ahead on; the best first. None: B does not make
  /// that move there.
  std::vector<Candidate> of(std::size_t i, std::size_t j, const Standing& standing);

  /// What the shift may change along a move, mm and deg.
  static double slack(const DiffMove& move, const Standing& standing);

 private:
  std::vector<Candidate> of_cut(const DiffMove& move, std::size_t i, std::size_t j, const Standing& standing);
  std::vector<Candidate> pieces_of_cut(const DiffMove& move, std::size_t i, std::size_t j, const Standing& standing);
  std::size_t tiny_rapids(std::size_t j, const Standing& standing);
  std::vector<Candidate> of_rapid(const DiffMove& move, std::size_t j, const Standing& standing);
  double cost_of_codes(std::size_t i, std::size_t j);
  bool corresponds(const DiffMove& move, std::size_t ahead);
  const DiffMove* piece(const DiffMove& move, std::size_t j, std::size_t count);
  std::optional<std::size_t> count_by_number(const DiffMove& move, std::size_t i, std::size_t j,
                                             const Standing& standing);
  double time_share(const DiffMove& move) const;

  MoveQueue& a_;
  MoveQueue& b_;
  double time_tolerance_;
};

/// Whether both have numbers, and not the same.
bool numbers_differ(const DiffMove& a, const DiffMove& b);

}  // namespace plumbline::jobs
