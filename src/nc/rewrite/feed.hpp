// Which length a feed is the speed along.
#pragma once

#include <cmath>
#include <optional>
#include <span>

#include "base/axes.hpp"
#include "nc/language/dialect.hpp"

namespace plumbline::nc {

/// Length that the control divides by the feed for a move whose X, Y, Z path has length `linear_mm` and whose rotary
/// axes turn by `delta` (deg). In mm; in deg where X, Y and Z stand still. `mm_per_unit`: 25.4 under G20, where a
/// degree may count as an inch. Nothing where the rule is not known and the move turns so much beside its way in
/// X, Y, Z that every rule would count another length, or where it says nothing of a turn alone.
std::optional<double> feed_length(double linear_mm, const AxisWords& delta, FeedRule rule, double mm_per_unit);

/// Of a way from `start` through `ends`: whether F counts none of its degrees or all as millimetres, it lasts as long,
/// but for this share. Pieces of a micrometre may turn as much as they move where the whole hardly turns.
bool turns_count_little(const AxisWords& start, std::span<const AxisWords> ends, double mm_per_unit, double share);

/// True where the length counts in degrees: the F of such a block does not change with the length unit.
inline bool feed_length_is_angle(double linear_mm) { return linear_mm == 0; }

/// F is the speed of X, Y and Z, whatever turns beside them; of a turn alone it says nothing.
inline bool counts_linear_axes(FeedRule rule) { return rule == FeedRule::tool_tip || rule == FeedRule::path_group; }

/// True if `a` is off `b` by more than this share of it.
inline bool differs(double a, double b, double tolerance) { return std::abs(a - b) > tolerance * std::abs(b); }

}  // namespace plumbline::nc
