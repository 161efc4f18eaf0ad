#include "nc/control/interpreter.hpp"

#include <algorithm>
#include <span>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "base/text/characters.hpp"
#include "nc/language/codes.hpp"
#include "nc/language/refusal.hpp"

namespace plumbline::nc {
namespace {

constexpr int kNamed = -1;  // in place of the number of a named parameter

constexpr int kChangeCode = 6;  // of --keeps-position: M6

bool may_be_unknown(char letter) { return letter == 'S'; }

// Reads what nothing sets among the block's first settings: whether that gives the value before or behind stands in no
// source but RS274/NGC's.
class ParametersOfBlock final : public ParameterReader {
 public:
  ParametersOfBlock(SystemParameters& readings, Parameters& parameters, std::span<const int> set)
      : system_parameters_(readings), parameters_(parameters), set_(set) {}
  Value read(const Block& block, int number, Span span) override {
    if (std::find(set_.begin(), set_.end(), number) != set_.end()) refuse_set(block, span);
    return system_parameters_.read(block, number, span);
  }
  Value read(const Block& block, std::string_view name, Span span) override {
    const std::string plain(parameters_.plain(name));
    for (std::size_t i = 0; i < set_.size(); ++i) {
      if (set_[i] != kNamed) continue;
      if (parameters_.plain(block.at(block.names[block.settings[i].name])) == plain) refuse_set(block, span);
    }
    return system_parameters_.read(block, name, span);
  }
  Value exists(std::string_view name) override { return system_parameters_.exists(name); }
  ParameterLimits limits() const override { return system_parameters_.limits(); }

 private:
  [[noreturn]] static void refuse_set(const Block& block, Span span) {
    refuse_at(block, span, codes::kNotInterpreted,
              fmt::format("{} is set and used in one block, and no source says which value that gives", block.at(span)),
              "set it in a block of its own");
  }
  SystemParameters& system_parameters_;
  Parameters& parameters_;
  std::span<const int> set_;  // their numbers, kNamed of names
};

// Comments and coolant: whether they are executed makes no difference to motion.
bool is_harmless(const Block& block, const Dialect& dialect) {
  if (!block.settings.empty()) return false;
  for (const Word& word : block.words) {
    if (word.letter != 'M' || word.expression != kLiteral) return false;
    const CodeRow* const row = dialect.m_code(static_cast<int>(word.value * 10));
    if (row == nullptr || !row->harmless) return false;
  }
  return true;
}

}  // namespace

Interpreter::Interpreter(const Dialect& dialect, const ProgramSettings& settings)
    : control_(dialect, settings),
      system_parameters_(control_, settings, dialect),
      evaluator_(dialect.syntax.equal_within),
      run_{dialect, settings, control_} {}

const Step& Interpreter::pass(const Block& block) {
  begin(block);
  finish();
  return run_.step;
}

const Step& Interpreter::execute(Block& block) {
  begin(block);
  run_.block_in_machine_system = false;
  if (block.block_delete && deleted(block)) {
    run_.step.skipped = true;
    for (const Word& word : block.words) {
      if (!is_code(word)) run_.words.add(word);
    }
    run_.axes = run_.words.axes();
    finish();
    return run_.step;
  }
  evaluate(block);
  if (run_.dialect.behaviour.increment_mm > 0) count_increments(run_, block);
  resolve_codes(run_);
  run_.step.passes_variables = run_.dialect.syntax.names && passes_variables(block);
  apply_settings(block);
  bool moved = run_.motion == nullptr || run_.motion_word != nullptr;
  for (const Chosen& chosen : run_.chosen) {
    // The motion in force takes its turn before the codes behind it.
    if (!moved && chosen.row->step > run_.motion->step) {
      move();
      moved = true;
    }
    act(chosen);
  }
  if (!moved) move();
  // Whether the change of tools comes before the move or after it is the builder's choice.
  const bool where_unknown = run_.dialect.behaviour.change_beside_move_unknown && run_.step.changes_tool;
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
  step.motions = run_.motions;
  step.before = &before_;
  step.after = &control_.modal;
  step.frame = &control_.frame;
  step.position = control_.position;
  step.known = control_.known;
  step.named = run_.axes;
}

bool Interpreter::deleted(const Block& block) {
  if (run_.settings.block_delete.value_or(false)) return true;
  const bool harmless = is_harmless(block, run_.dialect);
  if (!harmless && !run_.settings.block_delete && !run_.settings.as_with_empty_tables) {
    refuse_at(block, block.slash, codes::kBlockDelete,
              "whether this block is executed depends on a switch of the control",
              "say how it stands: --block-delete on leaves the block out, off executes it");
  }
  run_.step.executed_delete = !harmless;
  return false;
}

double Interpreter::value_of(const Block& block, std::uint32_t code, Span span) {
  const Value value = evaluator_.run(block, code, system_parameters_);
  if (value.known) return value.number;
  refuse_at(block, span, codes::kValueUnknown, "where the program goes on is known only when the machine runs",
            "a program that depends on a probe or an input cannot be compensated beforehand");
}

void Interpreter::evaluate(Block& block) {
  if (block.code.empty()) return;
  number_settings(block);
  bool vacant = false;
  for (Word& word : block.words) {
    if (word.expression == kLiteral) continue;
    const Value value = value_before(block, word.expression, block.settings.size());
    word.vacant = value.vacant;
    vacant = vacant || value.vacant;
    if (!value.known && !may_be_unknown(word.letter)) {
      run_.refuse(word, codes::kValueUnknown, "this value is known only when the machine runs",
                  "a program that depends on a probe or an input cannot be compensated beforehand");
    }
    word.value = value.number;
    word.unknown = !value.known;
  }
  if (vacant) leave_out_vacant_words(block);
  for (Argument& argument : block.arguments) {
    if (argument.expression == kLiteral) continue;
    argument.value = value_of(block, argument.expression, argument.span);
  }
  evaluate_settings(block);
}

// A word whose value is a vacant variable is as if not written [B-63174EN 13]; the control with EMPTY stops there.
void Interpreter::leave_out_vacant_words(Block& block) {
  for (const Word& word : block.words) {
    if (!word.vacant || run_.dialect.syntax.drops_vacant_words) continue;
    run_.refuse(word, codes::kParameterUnset, fmt::format("nobody gave {} a value", block.at(word.span)),
                "set the variable before, or ask with EQ EMPTY");
  }
  for (const Word& word : block.words) {
    if (word.vacant) block.left_out.push_back(word.span);
  }
  std::erase_if(block.words, [](const Word& word) { return word.vacant; });
}

int Interpreter::setting_number(const Block& block, const Setting& setting) {
  int number = kNamed;
  if (setting.target != kLiteral) {
    number = parameter_number(block, setting.span, evaluator_.run(block, setting.target, system_parameters_),
                              system_parameters_.limits());
  }
  if (number == kNamed ? system_parameters_.is_read_only(block.at(block.names[setting.name]))
                       : system_parameters_.is_read_only(number)) {
    refuse_at(block, setting.span, codes::kParameterReadOnly, "this parameter shows the control's own state",
              "change offsets with G10 or G92, tools with G10 L1, stored positions with G28.1 and G30.1");
  }
  return number;
}

void Interpreter::number_settings(const Block& block) {
  setting_numbers_.clear();
  for (const Setting& setting : block.settings) setting_numbers_.push_back(setting_number(block, setting));
}

void Interpreter::evaluate_settings(const Block& block) {
  setting_values_.clear();
  for (std::size_t i = 0; i < block.settings.size(); ++i) {
    setting_values_.push_back(value_before(block, block.settings[i].value, i));
  }
}

// In RS274/NGC all values of a block are found before any is set.
Value Interpreter::value_before(const Block& block, std::uint32_t code, std::size_t settings) {
  if (settings == 0 || run_.dialect.syntax.settings_at_once) return value(block, code);
  ParametersOfBlock readings(system_parameters_, control_.parameters, {setting_numbers_.data(), settings});
  return evaluator_.run(block, code, readings);
}

void Interpreter::assign(const Block& block) {
  number_settings(block);
  evaluate_settings(block);
  apply_settings(block);
}

Value Interpreter::value(const Block& block, std::uint32_t code) {
  return evaluator_.run(block, code, system_parameters_);
}

Value Interpreter::variable(const Block& block, std::size_t setting) {
  const Setting& place = block.settings[setting];
  const int number = setting_number(block, place);
  return number == kNamed ? system_parameters_.read(block, block.at(block.names[place.name]), place.span)
                          : system_parameters_.read(block, number, place.span);
}

void Interpreter::set_variable(const Block& block, std::size_t setting, Value value) {
  const Setting& place = block.settings[setting];
  set_parameter(block, place, setting_number(block, place), value);
}

void Interpreter::set_parameter(const Block& block, const Setting& place, int number, Value value) {
  if (control_.modal_call.by_variables) {
    refuse_at(block, place.span, codes::kNotInterpreted,
              "a variable is set while a cycle with variables in its brackets is called after each move, and no source "
              "says whether the call takes the new value",
              "end the call with MCALL before, and call it anew after");
  }
  if (number == kNamed) {
    if (place.type != VariableType::real) {
      control_.parameters.declare(block.at(block.names[place.name]), place.type);
    }
    control_.parameters.set(block.at(block.names[place.name]), value);
  } else if (number == run_.dialect.syntax.alarm_variable) {
    control_.ended = run_.step.alarms = true;
  } else if (number == run_.dialect.syntax.message_variable) {
    run_.step.shows_message = true;
    if (!run_.settings.keeps_position.contains(0)) lose_position(run_, AxisSet::all());  // as behind M0
  } else {
    control_.parameters.set(number, value);
  }
}

// A misread address would be a word left out: what is set must be a variable beyond doubt.
void Interpreter::check_variable(const Block& block, const Setting& place) {
  const Syntax& syntax = run_.dialect.syntax;
  if (!syntax.declared && !syntax.settings_alone) return;
  const std::string_view name = block.at(block.names[place.name]);
  if (syntax.declared && block.flow.word != FlowWord::define && control_.parameters.find(name) == nullptr) {
    constexpr std::string_view kExtended = "MSTHD";
    const bool extended = kExtended.find(upper(name.front())) != std::string_view::npos &&
                          std::all_of(name.begin() + 1, name.end(), is_digit);
    if (extended) {
      refuse_at(block, place.span, codes::kNotInterpreted,
                fmt::format("{}= speaks to a spindle or a tool holder of its own, which is not interpreted", name),
                "of spindles the first is known: S1= and M1=, or S and M alone");
    }
    refuse_at(block, place.span, codes::kUnknownCode,
              fmt::format("{} is neither declared nor a word of this control that is known here", name),
              fmt::format("if it is a variable, declare it: DEF REAL {}", name));
  }
  const bool like_an_axis = std::all_of(name.begin() + 1, name.end(), is_digit);
  if (!syntax.settings_alone || (block.words.empty() && !like_an_axis)) return;
  refuse_at(block, place.span, codes::kUnknownCode,
            fmt::format("{} is no word of this control that is known here", name),
            "a variable needs a block of its own, and a name that begins with two letters");
}

namespace {

bool belongs_to_name(char c) { return is_letter(c) || is_digit(c) || c == '_'; }

}  // namespace

// SPOS=R1*90, CYCLE832(TOLERANCE,1)
bool Interpreter::passes_variables(const Block& block) {
  for (const Word& word : block.words) {
    if (word.letter != kNamedCode) continue;
    const CodeRow& row = run_.dialect.named_codes[static_cast<std::size_t>(word.value)];
    const std::string_view text = block.at(word.span);
    bool in_text = false;
    for (std::size_t at = row.has_arguments ? row.name.size() : text.size(); at < text.size();) {
      const std::size_t begin = at++;
      if (text[begin] == '"') in_text = !in_text;
      if (in_text || !belongs_to_name(text[begin]) || is_digit(text[begin])) continue;
      while (at < text.size() && belongs_to_name(text[at])) ++at;
      const std::string_view name = text.substr(begin, at - begin);
      const bool is_r = upper(name.front()) == 'R' && std::all_of(name.begin() + 1, name.end(), is_digit);
      if (is_r || control_.parameters.find(name) != nullptr) return true;
    }
  }
  return false;
}

void Interpreter::apply_settings(const Block& block) {
  for (std::size_t i = 0; i < block.settings.size(); ++i) {
    if (setting_numbers_[i] == kNamed) check_variable(block, block.settings[i]);
    set_parameter(block, block.settings[i], setting_numbers_[i], setting_values_[i]);
  }
}

// Splines, probing and what the spindle leads; false: some other motion.
bool Interpreter::moves_specially(Action action) {
  const bool spline = action == Action::cubic_spline || action == Action::quadratic_spline;
  const bool nurbs = action == Action::nurbs_point || action == Action::nurbs_end;
  const bool spindle_leads = action == Action::synchronised || action == Action::rigid_tap;
  if (!spline && !nurbs && !spindle_leads && action != Action::probe) return false;
  if (run_.machine_word != nullptr) {
    run_.refuse(*run_.machine_word, codes::kMachineMove, "G53 needs G0 or G1",
                "write the motion code into the block of G53");
  }
  if (spline) move_spline(run_);
  if (!spline) control_.spline_end.reset();
  if (action == Action::nurbs_point) add_nurbs_point(run_);
  if (action == Action::nurbs_end) move_nurbs(run_);
  if (spindle_leads) move_synchronised(run_);
  if (action == Action::probe) move_probe(run_);
  if (spline) return true;  // in force for its own block alone; the motion before goes on [LinuxCNC, measured]
  control_.nurbs_ended = action == Action::nurbs_end;
  control_.motion_off = false;
  control_.motion_row = control_.nurbs_ended ? nullptr : run_.motion;
  control_.modal.motion = control_.nurbs_ended ? MotionMode::none : MotionMode::special;
  return true;
}

void Interpreter::set_motion_mode(const CodeRow& row) {
  control_.cycle.begun = false;
  control_.motion_row = row.action == Action::arc_through_point ? nullptr : &row;  // CIP is stated anew in each block
  control_.modal.motion = row.action == Action::rapid    ? MotionMode::rapid
                          : row.action == Action::feed   ? MotionMode::feed
                          : row.action == Action::arc_cw ? MotionMode::arc_cw
                                                         : MotionMode::arc_ccw;
}

// On an OSP G1 and a cycle are of different groups: whether the one ends the other was found in no source; posts write
// G0 or G80.
void Interpreter::check_ends_cycle(Action action) const {
  const bool in_cycle = control_.motion_row != nullptr && control_.motion_row->action == Action::cycle;
  if (!run_.dialect.behaviour.return_levels || !in_cycle || action == Action::rapid) return;
  run_.refuse(run_.motion_code(), codes::kNotInterpreted,
              "whether this ends the drilling cycle that is in force was found in no source",
              "write G80 (which stops the spindle) or a block with G0 before it");
}

void Interpreter::move() {
  const Action action = run_.motion->action;
  if (action == Action::cycle) return move_in_cycle(run_);
  check_ends_cycle(action);
  if (run_.machine_word != nullptr && run_.dialect.behaviour.machine_move_is_rapid) {
    move_straight(run_);
    if (run_.motion_word != nullptr) set_motion_mode(*run_.motion);  // G53 G0: G0 is the mode from here on
    return;
  }
  control_.cycle.begun = false;
  if (moves_specially(action)) return;
  control_.spline_end.reset();
  set_motion_mode(*run_.motion);
  if (action != Action::rapid && action != Action::feed) {
    move_arc(run_);
  } else {
    move_straight(run_);
  }
  drill_after_move(run_);
}

}  // namespace plumbline::nc
