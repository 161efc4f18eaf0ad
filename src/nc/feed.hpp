// Which length a feed is the speed along.
#pragma once

#include <optional>

#include "base/axes.hpp"
#include "nc/dialect.hpp"

namespace plumbline::nc {

/// Length that the control divides by the feed for a move whose X, Y, Z path has length `linear_mm` and whose rotary
/// axes turn by `delta` (deg). In mm, or in deg where the rule takes a purely rotary move so. Nothing where the rule is
/// not known and the move turns so much beside its way in X, Y, Z that every rule would count another length.
std::optional<double> feed_length(double linear_mm, const AxisWords& delta, FeedRule rule);

/// The same for a straight move by `delta`.
std::optional<double> feed_length(const AxisWords& delta, FeedRule rule);

/// True where the length counts in degrees: the F of such a block does not change with the length unit.
bool feed_length_is_angle(double linear_mm, FeedRule rule);

}  // namespace plumbline::nc
