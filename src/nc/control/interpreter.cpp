#include "nc/control/interpreter.hpp"

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "nc/control/passed_values.hpp"
#include "nc/language/active_comments.hpp"
#include "nc/language/codes.hpp"
#include "nc/language/refusal.hpp"

namespace plumbline::nc {
namespace {

constexpr int kChangeCode = 6;  // of --keeps-position: M6

// Comments and coolant: whether they are executed makes no difference to motion. A jump that leads to such a block
// looks at its / itself.
bool is_harmless(const Block& block, const Dialect& dialect) {
  if (!block.settings.empty() || block.flow.word != FlowWord::none) return false;
  for (const Word& word : block.words) {
    const bool may_be = word.letter == kNamedCode || (word.letter == 'M' && word.expression == kLiteral);
    const CodeRow* const row = may_be ? dialect.row_of(word) : nullptr;
    if (row == nullptr || !row->harmless) return false;
  }
  return true;
}

}  // namespace

Interpreter::Interpreter(const Dialect& dialect, const ProgramSettings& settings)
    : control_(dialect, settings),
      run_{dialect, settings, control_},
      changes_at_start_(control_.parameters.changes()),
      values_(run_) {}

const Step& Interpreter::pass(const Block& block) {
  begin(block);
  finish();
  return run_.step;
}

// (ABORT, text): the control ends the program there with an error; (py,...), and ;py,... in these very letters, is
// executed. Of several comments the last one acts [LinuxCNC, measured].
void Interpreter::check_last_comment(const Block& block) const {
  if (block.comments.empty() || run_.dialect.syntax.system_variables != SystemVariables::rs274) return;
  const Span span = block.comments.back().span;
  if (is_active_comment(block.at(span), "py") || block.at(span).starts_with(";py,")) {
    refuse_at(block, span, codes::kNotInterpreted,
              "the control executes what stands in this comment as a program in Python, which is not interpreted",
              "take it out, or put another word before it");
  }
  if (run_.settings.as_with_empty_tables || !is_active_comment(block.at(span), "abort")) return;
  refuse_at(block, span, codes::kNotInterpreted, "the control ends the program here with an error",
            "look why the program comes here, or end it with M2");
}

const Step& Interpreter::execute(Block& block) {
  begin(block);
  run_.block_in_machine_system = false;
  if (block.block_delete && deleted(block)) {
    run_.step.block_delete = BlockDelete::left_out;
    for (const Word& word : block.words) {
      if (!is_code(word)) run_.words.add(word);
    }
    run_.axes = run_.words.axes();
    finish();
    return run_.step;
  }
  check_last_comment(block);
  values_.evaluate(block);
  if (run_.dialect.behaviour.increment_mm > 0) count_increments(run_, block);
  resolve_codes(run_);
  if (run_.dialect.syntax.names) note_passed(block);
  values_.apply(block);
  if (main_begins_again()) second_pass_.note_codes(run_);
  bool moved = run_.motion == nullptr || run_.motion_word != nullptr;
  for (const Chosen& chosen : run_.chosen) {
    // The motion in force takes its turn before the codes after it.
    if (!moved && chosen.row->step > run_.motion->step) {
      make_motion(run_);
      moved = true;
    }
    if (!act_on_saved_modes(chosen)) act(run_, chosen);
  }
  if (!moved) make_motion(run_);
  if (run_.chosen_row(Action::modal_call) != nullptr) saved_.back().sets_call = control_.modal_call.row != nullptr;
  control_.moved_on_selected |= control_.edge_of_selected && !run_.motions.empty();
  // Whether the change of tools comes before the move or after it is the builder's choice.
  const bool where_unknown =
      run_.dialect.behaviour.change_beside_move_unknown && run_.step.tool_change != ToolChange::none;
  if (where_unknown && run_.motion != nullptr && !run_.settings.keeps_position.contains(kChangeCode)) {
    lose_position(run_, AxisSet::all());
  }
  if (run_.work_system_before == 0) {
    finish();
    return run_.step;
  }
  frame_of_block_ = control_.frame;
  nc::choose_work_system(run_, std::exchange(run_.work_system_before, 0));
  finish();
  run_.step.frame = &frame_of_block_;
  return run_.step;
}

// On LinuxCNC too, but not where its interpreter runs alone [2.9, emctask.cc].
bool Interpreter::main_begins_again() const {
  const Statements statements = run_.dialect.syntax.statements;
  return statements == Statements::macro_b ||
         (statements == Statements::o_words && !run_.settings.as_with_empty_tables);
}

void Interpreter::check_begins_again(const Block& block) const {
  if (!main_begins_again()) return;
  std::string differs = second_pass_.differs(control_, run_.settings);
  const bool keeps_names = run_.dialect.syntax.statements == Statements::o_words;
  if (differs.empty() && keeps_names && control_.parameters.changes() > changes_at_start_) {
    differs = "other values of the parameters that it set";
  }
  if (differs.empty()) {
    const std::string changed = values_.changed_since_read();
    if (!changed.empty()) differs = fmt::format("another {}", changed);
  }
  if (differs.empty()) return;
  refuse_at(
      block, {0, static_cast<std::uint32_t>(block.text.size())}, codes::kNotInterpreted,
      fmt::format("M99 begins the main program again, then under {}, which it does not state at its begin", differs),
      "end the shift, turn or length, state the mode before the first move (G90, G21, G17, G94, G54, G49), or end "
      "the program with M30");
}

void Interpreter::note_passed(const Block& block) {
  PassedValues passed = passed_values(run_, block);
  run_.step.passes_variables = passed.unknown;
  if (passed.values.empty()) return;
  run_.step.passed = std::make_shared<const std::vector<PassedValue>>(std::move(passed.values));
}

void Interpreter::begin(const Block& block) {
  before_ = control_.modal;
  run_.block = &block;
  run_.motions.clear();
  run_.holes.clear();
  run_.axes = AxisSet{};
  run_.words.clear();
  run_.step = Step{};
  run_.step.block = &block;
  run_.call = ProgramCall{};
}

void Interpreter::finish() {
  Step& step = run_.step;
  if (main_begins_again()) second_pass_.note_motions(run_);
  step.motions = run_.motions;
  step.before = &before_;
  step.after = &control_.modal;
  step.frame = &control_.frame;
  step.position = control_.position;
  step.known = control_.known;
  step.shifted = control_.shifted;
  step.named = run_.axes;
}

bool Interpreter::deleted(const Block& block) {
  if (run_.settings.block_delete.value_or(false)) return true;
  const bool harmless = is_harmless(block, run_.dialect);
  if (!harmless && may_leave_out_skipped()) {
    refuse_at(block, block.slash, codes::kBlockDelete,
              "whether this block is executed depends on a switch of the control",
              "say how it stands: --block-delete on leaves the block out, off executes it");
  }
  if (!harmless) run_.step.block_delete = BlockDelete::executed;
  return false;
}

void Interpreter::enter_o_word(LocalNumbers numbers, const std::vector<double>& arguments) {
  control_.parameters.enter(numbers);
  for (std::size_t i = 0; i < arguments.size(); ++i)
    control_.parameters.set(static_cast<int>(i) + 1, {arguments[i], true});
  saved_.emplace_back();
}

void Interpreter::enter_with_own(int variables) {
  control_.parameters.enter_with_own(variables);
  saved_.emplace_back();
}

void Interpreter::enter_sharing() {
  control_.parameters.enter_sharing();
  saved_.emplace_back();
}

void Interpreter::set_macro_arguments() {
  for (const auto& [number, value] : run_.arguments) control_.parameters.set(number, value);
}

void Interpreter::end_pass(const Block& block) {
  const ModesOfCall modes = std::exchange(saved_.back(), {});
  if (modes.sets_call && saved_.size() > 1) {
    refuse_at(block, {0, static_cast<std::uint32_t>(block.text.size())}, codes::kNotInterpreted,
              "MCALL is in force at the end of the subprogram that set it, and whether it stays so behind it was found "
              "in no source",
              "write MCALL alone before the end of the subprogram, or set it in the program that calls");
  }
  if (modes.saved && modes.come_back) restore_modes(run_, *modes.saved, block);
}

void Interpreter::leave_subprogram(const Block& block) {
  control_.parameters.leave();
  end_pass(block);
  saved_.pop_back();
}

// M70 to M73; false: another code.
bool Interpreter::act_on_saved_modes(const Chosen& chosen) {
  const Action action = chosen.row->action;
  const bool saves = action == Action::save_modes || action == Action::save_modes_of_call;
  if (!saves && action != Action::forget_modes && action != Action::restore_modes) return false;
  run_.step.saves_modes = true;
  switch (action) {
    case Action::forget_modes:
      saved_.back().saved.reset();
      return true;
    case Action::restore_modes:
      if (!saved_.back().saved) {
        run_.refuse(*chosen.word, codes::kModesNotSaved, "no modes were saved here", "save them with M70 before");
      }
      restore_modes(run_, *saved_.back().saved, *run_.block);
      return true;
    default:
      saved_.back().saved = save_modes(control_);
      saved_.back().come_back |= action == Action::save_modes_of_call;
      return true;
  }
}

}  // namespace plumbline::nc
