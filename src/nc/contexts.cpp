// A code beside others of its block, or in a mode, where no source says what a control makes of it: refused.
#include <algorithm>

#include <fmt/format.h>

#include "nc/codes.hpp"
#include "nc/execution.hpp"

namespace plumbline::nc {
namespace {

constexpr double kSameValue = 1e-9;

const Chosen* find_code(const Execution& run, Action action) {
  const auto found = std::find_if(run.chosen.begin(), run.chosen.end(),
                                  [&](const Chosen& code) { return code.row->action == action; });
  return found == run.chosen.end() ? nullptr : &*found;
}

// G5.1 Q2 X0 Y0 Z0: the axes that the function works on.
void check_named_axes(const Execution& run, const Chosen& code) {
  for (const Axis axis : kAllAxes) {
    if (!code.row->takes_axes || !run.axes.contains(axis) || run.words.find(axis)->value == 0) continue;
    run.refuse(*run.words.find(axis), codes::kNotInterpreted,
               fmt::format("{} names the axes that it works on, by 0", run.block->at(code.word->span)),
               "write 0 behind the axis, or put the move into a block of its own");
  }
}

// G5 P10001 is another function than G5 P10000.
void check_values(const Execution& run) {
  for (const Chosen& code : run.chosen) {
    const CodeRow& row = *code.row;
    if (row.only.empty()) continue;
    const Word& word = run.need(row.only_letter, run.block->at(code.word->span));
    const bool known = std::any_of(row.only.begin(), row.only.end(), [&](double value) {
      return word.value > value - kSameValue && word.value < value + kSameValue;
    });
    if (known) {
      check_named_axes(run, code);
      continue;
    }
    run.refuse(word, codes::kNotInterpreted, fmt::format("{} {}", run.block->at(code.word->span), row.why),
               "write it out in G0, G1, G2 and G3, with the control's simulator or the CAM system");
  }
}

void check_moves_beside(const Execution& run) {
  if (run.motion == nullptr || run.axes.empty()) return;
  for (const Chosen& code : run.chosen) {
    if (!code.row->alone) continue;
    run.refuse(*code.word, codes::kNotInterpreted,
               fmt::format("{} beside a move is not interpreted: the control takes it in a block of its own",
                           run.block->at(code.word->span)),
               "put the move into the block behind it");
  }
}

bool counts_increments(const Execution& run) {
  if (find_code(run, Action::incremental) != nullptr) return true;
  return run.control.modal.incremental && find_code(run, Action::absolute) == nullptr;
}

void check_m_codes(const Execution& run) {
  const int most = run.dialect.habits.most_m_codes;
  int count = 0;
  for (const Word& word : run.block->words) {
    if (word.letter != 'M' || ++count <= most || most == 0) continue;
    run.refuse(word, codes::kSameGroup, fmt::format("more than {} M codes in one block", most),
               "put them into blocks of their own");
  }
}

// Whether the increment counts from where the tip stood before the length changed, or behind that.
void check_length_under_increments(const Execution& run) {
  if (!run.dialect.habits.tool_length_increments_unknown || run.motion == nullptr || !run.axes.contains(Axis::Z))
    return;
  for (const Chosen& code : run.chosen) {
    const Action action = code.row->action;
    const bool sets = action == Action::tool_length || action == Action::tool_edge;
    const bool ends = action == Action::tool_length_off && run.control.frame.tool != AxisWords{};
    if ((!sets && !ends) || !counts_increments(run)) continue;
    run.refuse(*code.word, codes::kNotInterpreted,
               fmt::format("{} beside an increment of Z (G91) is not interpreted: where the tool ends depends on "
                           "whether the length counts for it",
                           run.block->at(code.word->span)),
               "write G90 and the position, or put the move into a block of its own behind an absolute one");
  }
}

// In which unit the words of such a block count stands in no source.
void check_words_beside_unit(const Execution& run) {
  if (!run.dialect.habits.unit_change_stands_alone) return;
  const Chosen* code = find_code(run, Action::inches);
  if (code == nullptr) code = find_code(run, Action::millimetres);
  if (code == nullptr || (code->row->action == Action::inches) == run.control.modal.inches) return;
  constexpr std::string_view kLengths = "XYZIJKRQF";
  for (const Word& word : run.block->words) {
    if (kLengths.find(word.letter) == std::string_view::npos) continue;
    run.refuse(word, codes::kNotInterpreted,
               fmt::format("{} beside {}, which changes the unit: in which of the two it counts is not known",
                           run.block->at(word.span), run.block->at(code->word->span)),
               "put the change of units into a block of its own before");
  }
}

}  // namespace

void check_contexts(const Execution& run) {
  check_values(run);
  check_moves_beside(run);
  check_m_codes(run);
  check_length_under_increments(run);
  check_words_beside_unit(run);
}

// Of G1 and G81 in one block the control makes what its series does: one group or two [B-62764EN 13.1].
void check_cycle_beside_motion(const Execution& run) {
  const Chosen* const cycle = find_code(run, Action::cycle);
  if (cycle == nullptr) return;
  for (const Chosen& code : run.chosen) {
    const bool moves = code.word->letter == 'G' && code.row->group == kMotionGroup &&
                       code.row->action != Action::cycle && code.row->action != Action::motion_off;
    if (!moves) continue;
    run.refuse(*code.word, codes::kSameGroup, fmt::format("{} beside a canned cycle", run.block->at(code.word->span)),
               "put them into blocks of their own");
  }
}

void check_words_before_call(const Execution& run) {
  for (const Word& word : run.block->words) {
    const CodeRow* const row = word.letter == 'G' ? run.dialect.row_of(word) : nullptr;
    if (row != nullptr && row->action == Action::call_macro) return;
    run.refuse(word, codes::kNotInterpreted,
               fmt::format("{} before the call of a macro is no argument of it", run.block->at(word.span)),
               "put it into a block of its own before, or, as an argument, behind the call");
  }
}

}  // namespace plumbline::nc
