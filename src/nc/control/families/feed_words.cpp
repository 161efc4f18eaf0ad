// F, and the three meanings of it: G93, G94, G95.
#include "nc/control/execution.hpp"
#include "nc/language/codes.hpp"

namespace plumbline::nc {

void set_feed(Execution& run, const Word& word) {
  Control& control = run.control;
  if (word.value < 0) run.refuse(word, codes::kNegative, "the feed is negative", "write a feed of zero or more");
  if (control.modal.feed_mode == FeedMode::inverse_time) return;  // it belongs to this block's move alone
  control.feed_taken = nullptr;
  control.modal.feed = word.value;
  control.feed_linear = run.length(word);
  control.modal.feed_rotary = word.value;
}

// The F before it is dropped, on some controls even if the mode stays.
void set_feed_mode(Execution& run, FeedMode mode) {
  Control& control = run.control;
  if (control.modal.feed_mode == mode && !run.dialect.behaviour.feed_mode_drops_feed) return;
  if (control.modal.feed_mode != FeedMode::inverse_time) control.feed_kept = control.modal.feed_rotary;
  control.feed_taken = nullptr;
  control.modal.feed_mode = mode;
  control.modal.feed = control.feed_linear = control.modal.feed_rotary = 0;
}

}  // namespace plumbline::nc
