#include "nc/control/families/called_after.hpp"

namespace plumbline::nc {
// It stands after boring [C 2.1.8 to 2.1.10], and does what SDAC says after tapping [C 2.1.5], with a floating tap
// where SDR is not 0 [C 2.1.6; X p. 2-86]. What another SDAC leaves is in no source: as if it stood.
void leave_spindle(Control& control, const CalledValues& given, int code) {
  const bool bores = code >= kCalledBore && code <= kCalledBoreByHand;
  const bool taps = code == kCalledTap || code == kCalledFloatingTap;
  if (!bores && !taps) return;
  const double after = taps ? given.number(code == kCalledTap ? 6 : 7) : kSpindleStands;
  if (code == kCalledFloatingTap && given.number(6) == 0 && after != kSpindleStands) return;
  const bool turns = after == kClockwise || after == kCounterClockwise;
  control.turn_spindle(turns ? static_cast<int>(after) : kSpindleStands);
}

// Codes and frames are after a cycle as they were before it [C 2.1.1]; of F and S no source says so.
void leave_own_feeds(Control& control, const CalledValues& given, const CycleCall& call, double last_share) {
  const auto is_other = [&](double rate) { return rate > 0 && rate * control.length_unit() != control.feed_linear; };
  const int code = call.row->value;
  bool taken = last_share != 1;
  if (code == kCalledReam) taken = is_other(given.number(kFeedDown)) || is_other(given.number(kFeedUp));
  if (code == kCalledFloatingTap) taken = given.number(9) != 0 || given.number(10) != 0;
  if (code == kCalledTap) {
    taken = true;
    for (const int place : {10, 11}) {
      if (given.number(place) != 0 && given.number(place) != control.spindle_speed) control.spindle_speed = 0;
    }
  }
  if (taken) control.feed_taken = call.row;
}

}  // namespace plumbline::nc
