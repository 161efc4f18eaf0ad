// How a block is written: as it stands, with its end in other words, or in pieces.
#include <algorithm>

#include "compensate/pass.hpp"

namespace plumbline::compensate {

// Where one block has A, B and C in place of its vector, or its code says that they follow, all behind it have.
bool Pass::writes_vector(const nc::Step& step) const {
  if (!step.tool_vector) return false;
  return emitter_.changed() ||
         std::any_of(step.block->words.begin(), step.block->words.end(), [&](const nc::Word& word) {
           const nc::CodeRow* const row = nc::is_code(word) ? dialect_.row_of(word) : nullptr;
           return row != nullptr && !row->written_as.empty();
         });
}

void Pass::copy(const nc::Step& step, bool counts, std::optional<double> seconds) {
  if (writes_vector(step)) {
    emitter_.begin_group(step);
    emitter_.copy(*plain_.plain(step, true));
    emitter_.end_group(step);
  } else {
    emitter_.copy(step);
  }
  intention_.keep(step, counts, seconds);
}

// In text order a block with @ and ^, or with a direction of the tool, gets X and Y, or A, B and C, only where it must
// change.
nc::EmittedMove Pass::write_move(const nc::Step& step, std::optional<double> duration) {
  nc::EmittedMove move;
  const bool in_other_words =
      (step.polar || step.tool_vector) && (writes_vector(step) || !emitter_.stays(step, points_, writable()));
  if (in_other_words) {
    emitter_.begin_group(step);
    move = emitter_.move(*plain_.plain(step, true), points_, writable(), duration);
    emitter_.end_group(step);
  } else {
    move = emitter_.move(step, points_, writable(), duration);
  }
  if (move.changed) {
    intention_.divide(step, points_, writable(), duration);
  } else {
    intention_.keep(step, true, duration);
  }
  return move;
}

}  // namespace plumbline::compensate
