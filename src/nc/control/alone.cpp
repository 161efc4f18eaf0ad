// Codes that stand alone in their block: a dwell where the control says so, calls of cycles.
#include <algorithm>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "nc/control/execution.hpp"
#include "nc/language/codes.hpp"

namespace plumbline::nc {
namespace {

bool calls(Action action) {
  return action == Action::modal_call || action == Action::called_cycle || action == Action::swivel;
}

bool restores(Action action) { return action == Action::restore_modes; }

// Refuses the first word beside a code of such an action.
void refuse_beside(const Execution& run, bool (*stands_alone)(Action), std::string_view why) {
  const bool any = std::any_of(run.chosen.begin(), run.chosen.end(),
                               [&](const Chosen& chosen) { return stands_alone(chosen.row->action); });
  if (!any) return;
  for (const Word& word : run.block->words) {
    const CodeRow* const row = run.dialect.row_of(word);
    if (row != nullptr && stands_alone(row->action)) continue;
    run.refuse(word, codes::kNotInterpreted, std::string(why), "put the other words into a block of their own");
  }
}

}  // namespace

void check_extended(const Execution& run, const CodeRow& row, const Word& word) {
  const std::string_view text = run.block->at(word.span);
  const std::size_t equals = text.find('=');
  if (equals == std::string_view::npos) return;
  if (run.dialect.syntax.statements == Statements::user_task) {
    run.refuse(word, codes::kNotInterpreted, fmt::format("whether {} is a code was found in no source", text),
               "write the code itself, as in M8");
  }
  const std::vector<CodeRow>& rows = run.dialect.m_codes;
  const bool of_spindle = std::any_of(rows.begin(), rows.end(), [&](const CodeRow& other) {
    return other.action == Action::spindle && other.step == row.step;
  });
  if (of_spindle) return;
  if (text.find_first_of("0123456789") > equals) return;  // M=8 is M8: all addresses but N, G and L take values [D]
  run.refuse(word, codes::kNotInterpreted, fmt::format("{} is a code of the machine's builder", text),
             "of M1=.. the codes of the spindle are known: M1=3, M1=4, M1=5 and their like");
}

void check_alone(const Execution& run) {
  // what the control does with other words beside a call is in no source
  refuse_beside(run, calls, "the call of a cycle stands alone in its block");
  // the blocks by which the control brings modes back overwrite the one that it is reading: what should act after M72
  // in its block is lost then, even M2 [LinuxCNC, measured]
  refuse_beside(run, restores, "what stands beside M72 is lost at the control wherever M72 brings a mode back");
}

}  // namespace plumbline::nc
