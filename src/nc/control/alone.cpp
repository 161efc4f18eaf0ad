// Codes that stand alone in their block: a dwell where the control says so, calls of cycles.
#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "nc/control/execution.hpp"
#include "nc/language/codes.hpp"

namespace plumbline::nc {
namespace {

bool calls(Action action) {
  return action == Action::modal_call || action == Action::called_cycle || action == Action::swivel;
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

// The blocks by which the control brings modes back overwrite the one that it is reading: what should act after M72 in
// its block is lost then, even M2 [LinuxCNC, measured].
void check_restoring_alone(const Execution& run) {
  if (run.chosen_row(Action::restore_modes) == nullptr) return;
  for (const Word& word : run.block->words) {
    const CodeRow* const row = run.dialect.row_of(word);
    if (row != nullptr && row->action == Action::restore_modes) continue;
    run.refuse(word, codes::kNotInterpreted,
               "what stands beside M72 is lost at the control wherever M72 brings a mode back",
               "put the other words into a block of their own");
  }
}

}  // namespace

void check_extended(const Execution& run, const CodeRow& row, const Word& word) {
  const std::string_view text = run.block->at(word.span);
  if (text.find('=') == std::string_view::npos) return;
  const std::vector<CodeRow>& rows = run.dialect.m_codes;
  const bool of_spindle = std::any_of(rows.begin(), rows.end(), [&](const CodeRow& other) {
    return other.action == Action::spindle && other.step == row.step;
  });
  if (of_spindle) return;
  run.refuse(word, codes::kNotInterpreted, fmt::format("{} is a code of the machine's builder", text),
             "of M1=.. the codes of the spindle are known: M1=3, M1=4, M1=5 and their like");
}

void check_alone(const Execution& run) {
  check_call_alone(run);
  check_restoring_alone(run);
}

}  // namespace plumbline::nc
