// Codes that stand alone in their block: a dwell where the control says so, calls of cycles.
#include <algorithm>

#include "nc/codes.hpp"
#include "nc/execution.hpp"

namespace plumbline::nc {
namespace {

// What the control does with other words beside G4 is in no source.
void check_dwell_alone(const Execution& run) {
  const CodeRow* const dwell = run.dialect.habits.dwell_alone ? run.chosen_row(Action::dwell) : nullptr;
  if (dwell == nullptr) return;
  for (const Word& word : run.block->words) {
    if (run.dialect.row_of(word) == dwell || (!is_code(word) && (letter_bit(word.letter) & dwell->word_mask))) continue;
    run.refuse(word, codes::kNotInterpreted, "a dwell stands alone in its block on this control",
               "put the other words into a block of their own");
  }
}

bool calls(Action action) {
  return action == Action::modal_call || action == Action::called_cycle || action == Action::end_swivel;
}

// What the control does with other words beside a call is in no source.
void check_call_alone(const Execution& run) {
  const bool any =
      std::any_of(run.chosen.begin(), run.chosen.end(), [](const Chosen& chosen) { return calls(chosen.row->action); });
  if (!any) return;
  for (const Word& word : run.block->words) {
    const CodeRow* const row = run.dialect.row_of(word);
    if (row != nullptr && calls(row->action)) continue;
    run.refuse(word, codes::kNotInterpreted, "the call of a cycle stands alone in its block",
               "put the other words into a block of their own");
  }
}

}  // namespace

void check_alone(const Execution& run) {
  check_dwell_alone(run);
  check_call_alone(run);
}

}  // namespace plumbline::nc
