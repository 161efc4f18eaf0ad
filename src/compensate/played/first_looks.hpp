// Where blocks are looked at first, played before the blocks come.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "compensate/corrector.hpp"

namespace plumbline::compensate {

/// Of one block these are three poses, of all that are known to be played soon they fill packs.
class FirstLooks {
 public:
  static constexpr double kEdge = 1e-6;                                      // of a piece: beside its ends
  static constexpr std::array<double, 3> kFractions{kEdge, 0.5, 1 - kEdge};  // of a piece, at which it is looked at

  /// The corrector must outlive it.
  explicit FirstLooks(const Corrector& corrector) : corrector_(corrector) {}

  /// Of a block, in their order: what the control is told at kFractions of its one piece.
  void add(std::uint64_t block, const std::array<Target, kFractions.size()>& told);
  /// Plays those that were added, with the tool that the corrector has now.
  void play();
  /// At kFractions; nothing of a block that was not added. Holds until the next call of forget_before().
  std::span<const std::optional<PlayedTip>> of(std::uint64_t block) const;
  void forget_before(std::uint64_t block);

 private:
  const Corrector& corrector_;
  std::vector<std::uint64_t> blocks_;
  std::vector<std::optional<PlayedTip>> played_;  // kFractions.size() of each
  std::vector<Target> told_;                      // of the last of these, not played yet
  Plays plays_;
};

}  // namespace plumbline::compensate
