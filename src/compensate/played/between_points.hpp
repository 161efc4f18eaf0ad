// How far the deformed tip is from the path that the original asks for, between the written points as well: blocks are
// played on the model where they promise to be worst.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/axes.hpp"
#include "compensate/bound/distance.hpp"
#include "compensate/corrector.hpp"
#include "compensate/move.hpp"
#include "compensate/played/first_looks.hpp"
#include "compensate/played/piece_ranking.hpp"
#include "compensate/summary.hpp"

namespace plumbline::compensate {

/// A piece of the output, in the order of the block.
struct SentPiece {
  AxisWords end;                    // of what the control is told, as it keeps it: pose in W, mm and deg
  AxisWords wanted;                 // before it was rounded
  double share = 1;                 // of the block's time
  machine::PerStrut<double> sign;   // of the struts' speeds, as the correction of its end has them
  std::optional<nc::Arc> arc = {};  // that the control keeps, in the work system; nothing: straight
  Deviation proven = {};            // of an arc: how far the tip may be off on it
};

/// A move that cuts, and what became of it.
struct SentMove {
  const MovePath* path = nullptr;
  std::optional<double> seconds;      // its time
  AxisWords begin;                    // where the control stood, pose in W
  std::span<const SentPiece> pieces;  // of a move that was left as it stands its end alone
  bool as_it_stands = false;
};

class BetweenPoints {
 public:
  /// The corrector must outlive it, with the tool that the moves are made with: leave() before it changes.
  explicit BetweenPoints(const Corrector& corrector) : corrector_(corrector), first_looks_(corrector) {}

  /// What comes next, as far as it is known, up to a change of the tool: what is surely looked at of it is played in
  /// packs. Need not be called.
  void foresee(std::span<const SentMove> moves);
  void cut(const SentMove& move);
  /// A rapid, which is no path that the tip must keep to: `sign` of the struts as the correction of its end has them.
  void rapid(const machine::PerStrut<double>& sign);
  /// To be called before the tool changes or the machine goes where nobody follows it, and at the end.
  void leave();

  const Worst& tip_mm() const { return tip_.found; }
  const Worst& turned_deg() const { return turned_.found; }
  std::uint64_t plays() const { return plays_; }
  /// Where a played machine gave way, if it did.
  std::size_t gave_way_line() const { return gave_way_line_; }

 private:
  struct Part {  // a piece that is to be played
    AxisWords begin, end;
    double from = 0, share = 1;  // of the block's time
    bool along_curve = false;
    std::optional<nc::Arc> arc = {};
    PieceGuess tip, turned;

    double on_path(double fraction) const { return std::clamp(from + fraction * share, 0.0, 1.0); }
    Target told(const MovePath& path, std::optional<double> seconds, double fraction) const;
  };
  struct Look {  // at a place of a part
    double fraction = 0;
    double tip_mm = 0, turned_deg = 0;  // off the path: at most, until it is measured
    std::optional<PlayedTip> played;    // nothing: the machine gives way

    machine::PerStrut<double> speed() const {
      return played ? played->speed : machine::PerStrut<double>(machine::PerStrut<double>::Zero());
    }
  };
  struct Enough {  // what is found up to here changes nothing
    double tip_mm = 0, turned_deg = 0;
  };
  void find_guesses(const SentMove& move);
  void choose(const SentMove& move);
  void choose_from(PieceRanking& ranking, const SentMove& move);
  static bool must_play(std::uint64_t block) { return block <= kAllBlocks || block % kEvery == 0; }
  void play_waiting(const MovePath* next);
  void play(const Part& part, const MovePath* next);
  std::span<Look> look(const Part& part, std::span<const double> fractions);
  std::vector<double> beside_turns() const;
  void refine(const Part& part, double Look::*figure, const MovePath* next);
  void measure(const Part& part, const Enough& enough, Look& look, const MovePath* next);
  std::span<Look> sample(const Part& part, std::span<const double> fractions);

  static constexpr std::uint64_t kAllBlocks = 256;  // at the begin: played whatever is guessed of them
  static constexpr std::uint64_t kEvery = 16;       // after them, likewise

  const Corrector& corrector_;
  FirstLooks first_looks_;
  std::array<MovePath, 2> paths_;
  const MovePath* before_ = nullptr;  // of these: the move before the one that waits, and that one; null: none
  MovePath* here_ = nullptr;
  std::optional<double> seconds_;  // of that one
  std::vector<Part> waiting_;
  std::vector<Look> looked_;   // of the part that is played
  std::vector<Look> sampled_;  // the last of these
  std::vector<Target> told_;   // for them
  Plays played_;
  PieceRanking tip_, turned_;
  machine::PerStrut<double> sign_ = machine::PerStrut<double>::Zero();  // where the control stands
  Corrector::FrictionTurns friction_;
  std::uint64_t blocks_ = 0;
  std::uint64_t pieces_ = 0;  // since the effect of a strut's friction was worked out
  double credit_ = 0;         // plays that may be spent
  std::uint64_t plays_ = 0;
  std::size_t gave_way_line_ = 0;
};

}  // namespace plumbline::compensate
