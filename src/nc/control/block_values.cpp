#include "nc/control/block_values.hpp"

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "base/text/characters.hpp"
#include "nc/control/user_function.hpp"
#include "nc/language/codes.hpp"
#include "nc/language/refusal.hpp"

namespace plumbline::nc {
namespace {

constexpr int kNamed = -1;  // in place of the number of a named parameter

// "#5" of "#5=3" or X#5, not "[#5]" or "-#5".
bool is_variable_alone(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t");
  return begin != std::string_view::npos && text[begin] == '#';
}

bool may_be_unknown(char letter) { return letter == 'S'; }

// Reads what nothing sets among the block's first settings: whether that gives the value before or after stands in no
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
  Value exists(const Block& block, std::string_view name, Span span) override {
    return system_parameters_.exists(block, name, span);
  }
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

// A misread address would be a word left out: what is set must be a variable beyond doubt.
void check_variable(const Execution& run, const Block& block, const Setting& place) {
  const Syntax& syntax = run.dialect.syntax;
  if (!syntax.declared && !syntax.settings_alone) return;
  const std::string_view name = block.at(block.names[place.name]);
  if (syntax.declared && block.flow.word != FlowWord::define && run.control.parameters.find(name) == nullptr) {
    constexpr std::string_view kExtended = "MSTHD";
    const bool extended = kExtended.find(upper(name.front())) != std::string_view::npos &&
                          std::all_of(name.begin() + 1, name.end(), is_digit);
    if (extended && upper(name.front()) == 'H')
      refuse_at(block, place.span, codes::kUserCode, user_function_text(block.at(place.span)),
                std::string(kUserFunctionHelp));
    if (extended) {
      refuse_at(block, place.span, codes::kNotInterpreted,
                fmt::format("{}= speaks to a spindle or a tool holder of its own, which is not interpreted", name),
                upper(name.front()) == 'T' ? "write T alone, as in T=1 or T=\"MILL10\": there is one spindle"
                                           : "of spindles the first is known: S1= and M1=, or S and M alone");
    }
    if (run.control.parameters.was_local_elsewhere(name)) refuse_of_other_program(block, place.span, name);
    refuse_at(block, place.span, codes::kUnknownCode,
              fmt::format("{} is neither declared nor a word of this control that is known here", name),
              fmt::format("if it is a variable, declare it: DEF REAL {}; a word of the control stays one, and is not "
                          "interpreted",
                          name));
  }
  const bool like_an_axis = std::all_of(name.begin() + 1, name.end(), is_digit);
  const bool alone = std::all_of(block.words.begin(), block.words.end(), [&](const Word& word) {
    return word.letter == kNamedCode && run.dialect.named_codes[static_cast<std::size_t>(word.value)].alone;  // NOEX
  });
  if (!syntax.settings_alone || (alone && !like_an_axis)) return;
  refuse_at(block, place.span, codes::kUnknownCode,
            fmt::format("{} is no word of this control that is known here", name),
            alone ? "a variable needs a name that begins with two letters"
                  : fmt::format("a word of the control is not interpreted: leave {} out if no move depends on it; a "
                                "variable needs a block of its own, and a name that begins with two letters",
                                name));
}

// Tables of offsets [B-63944EN 16.2]; below #1000 what a control has by its option.
[[noreturn]] void refuse_macro_variable(const Block& block, const Setting& setting, int number) {
  constexpr int kFirstOfControl = 1000;
  const auto is_within = [&](int first, int last) { return number >= first && number <= last; };
  const bool holds_offsets = is_within(2001, 2999) || is_within(5201, 5340) || is_within(7001, 7960) || number > 10000;
  const std::string_view own = "the program's own variables are #1 to #33, #100 to #199 and #500 to #999";
  const std::string name(block.at(setting.span));
  refuse_at(block, setting.span, codes::kParameterReadOnly,
            number < kFirstOfControl
                ? fmt::format("{} is no variable that each control has", name)
                : fmt::format("{} is a variable of the control itself, which is not interpreted", name),
            holds_offsets              ? fmt::format("change offsets with G10 or G92; {}", own)
            : number < kFirstOfControl ? fmt::format("choose another number: {}", own)
                                       : fmt::format("leave it out, if no move depends on it; {}", own));
}

// #5=[#3]: whether the variable is vacant then or 0 was found in no source.
[[noreturn]] void refuse_bracketed(const Block& block, const Setting& setting) {
  refuse_at(block, setting.whole, codes::kParameterUnset,
            fmt::format("{} is set to what was never given a value: whether this counts as 0 in brackets was found in "
                        "no source",
                        block.at(setting.span)),
            "write the variable without brackets, or set it before");
}

void check_declared_once(Execution& run, const Block& block, const Setting& place) {
  if (block.flow.word != FlowWord::define && block.flow.word != FlowWord::sub) return;
  const std::string_view name = block.at(block.names[place.name]);
  if (run.control.parameters.declare_once(name, block.offset + place.span.begin)) return;
  refuse_at(block, place.span, codes::kAssignment, fmt::format("{} is declared twice in this program", name),
            "leave one of the declarations, or rename one of the variables");
}

// The first name of which EXISTS asks and only the machine knows, since a program before this one may have made it.
std::string_view name_left_open(const Block& block, std::uint32_t code, ParameterReader& parameters) {
  for (const Instruction* step = &block.code[code]; step->operation != Operation::end; ++step) {
    if (step->operation != Operation::exists) continue;
    const std::string_view name = block.at(block.names[step->name]);
    if (!parameters.exists(block, name, step->span).known) return name;
  }
  return {};
}

[[noreturn]] void refuse_unknown(const Execution& run, const Block& block, std::uint32_t code, Span span,
                                 ParameterReader& parameters, std::string_view message) {
  if (run.dialect.syntax.statements == Statements::high_level) {
    refuse_at(block, span, codes::kValueUnknown,
              "a FOR that has ended counted by a variable of this, and what is left in it then was found in no source",
              "set the variable anew after ENDFOR, or count by WHILE");
  }
  if (const std::string_view name = name_left_open(block, code, parameters); !name.empty()) {
    const bool of_machine = name.find('[') != std::string_view::npos;  // an entry of its INI file, a pin of its HAL
    refuse_at(block, span, codes::kValueUnknown,
              fmt::format("whether #<{}> exists is known only to the machine{}", name,
                          of_machine ? "" : ": a program before this one may have made it"),
              of_machine ? "keep only the branch that the machine takes"
                         : "give it a value in this program before, or keep only the branch that the machine takes");
  }
  refuse_at(block, span, codes::kValueUnknown, std::string(message),
            "a program that depends on a probe or an input cannot be compensated beforehand");
}

// "SIN[30]" of SIN30 or X=SIN30, which the control reads as the name of a variable; empty: it is none such.
std::string function_meant(const Dialect& dialect, std::string_view text) {
  text.remove_prefix(text.find('=') + 1);
  const std::size_t digits = std::min(text.find_first_of("0123456789"), text.size());
  if (digits == text.size() || text.find_first_not_of("0123456789.", digits) != std::string_view::npos) return {};
  const NameMeaning* const meaning = dialect.meaning(text.substr(0, digits));
  if (meaning == nullptr || meaning->kind != NameMeaning::Kind::function || meaning->arguments != 1) return {};
  return fmt::format("{}[{}]", text.substr(0, digits), text.substr(digits));
}

// EMPTY and a variable that was never set are compared; what else comes of them was found in no source.
[[noreturn]] void refuse_empty(const Dialect& dialect, const Block& block, Span span) {
  const std::string function = function_meant(dialect, block.at(span));
  refuse_at(block, span, codes::kParameterUnset,
            fmt::format("a value of {} is EMPTY, or a variable that was never set: what comes of that but a comparison "
                        "was found in no source",
                        block.at(span)),
            function.empty() ? "set the variable before, or ask with EQ EMPTY or NE EMPTY"
                             : fmt::format("if the function is meant, write {}", function));
}

}  // namespace

BlockValues::BlockValues(Execution& run)
    : run_(run),
      system_parameters_(run.control, run.settings, run.dialect),
      evaluator_(run.dialect.syntax.equal_within, !run.dialect.syntax.empty_names, run.dialect.syntax.doubtful_within,
                 run.dialect.syntax.unsourced_values, run.dialect.syntax.relative_within) {}

double BlockValues::value_of(const Block& block, std::uint32_t code, Span span) {
  const Value value = evaluator_.run(block, code, system_parameters_);
  if (value.vacant && run_.dialect.syntax.empty_names) refuse_empty(run_.dialect, block, span);
  if (value.known) return value.number;
  refuse_unknown(run_, block, code, span, system_parameters_,
                 "where the program goes on is known only when the machine runs");
}

void BlockValues::evaluate(Block& block) {
  if (block.code.empty()) return;
  number_settings(block);
  bool vacant = false;
  for (Word& word : block.words) {
    if (word.expression == kLiteral) continue;
    const Value value = value_before(block, word.expression, block.settings.size(), rounding_of(run_, block, word));
    word.vacant = value.vacant;
    word.rounded = value.rounded;
    vacant = vacant || value.vacant;
    if (!value.known && !may_be_unknown(word.letter)) {
      refuse_unknown(run_, block, word.expression, word.span, system_parameters_,
                     "this value is known only when the machine runs");
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
void BlockValues::leave_out_vacant_words(Block& block) {
  for (const Word& word : block.words) {
    if (!word.vacant || run_.dialect.syntax.drops_vacant_words) continue;
    const std::string function = function_meant(run_.dialect, block.at(word.span));
    run_.refuse(word, codes::kParameterUnset, fmt::format("{} was never given a value", block.at(word.span)),
                function.empty() ? "set the variable before, or ask with EQ EMPTY"
                                 : fmt::format("if the function is meant, write {}", function));
  }
  for (const Word& word : block.words) {
    if (!word.vacant) continue;
    std::string_view value = block.at(word.span).substr(1);
    if (value.find_first_of("+-") == 0) value.remove_prefix(1);
    if (run_.dialect.syntax.drops_vacant_words && !is_variable_alone(value)) {
      run_.refuse(word, codes::kParameterUnset,
                  fmt::format("{} was never given a value: whether it counts as 0 in brackets, or the word as not "
                              "written, was found in no source",
                              block.at(word.span)),
                  "write the variable without brackets, or set it before");
    }
    block.left_out.push_back(word.span);
  }
  std::erase_if(block.words, [](const Word& word) { return word.vacant; });
}

int BlockValues::setting_number(const Block& block, const Setting& setting) {
  int number = kNamed;
  if (setting.target != kLiteral) {
    number = parameter_number(block, setting.span, evaluator_.run(block, setting.target, system_parameters_),
                              system_parameters_.limits());
  }
  if (number == kNamed ? system_parameters_.is_read_only(block.at(block.names[setting.name]))
                       : system_parameters_.is_read_only(number)) {
    if (run_.dialect.syntax.system_variables == SystemVariables::macro_b) refuse_macro_variable(block, setting, number);
    refuse_at(block, setting.span, codes::kParameterReadOnly, "this parameter shows the control's own state",
              "change offsets with G10 or G92, tools with G10 L1, stored positions with G28.1 and G30.1");
  }
  return number;
}

void BlockValues::number_settings(const Block& block) {
  setting_numbers_.clear();
  for (const Setting& setting : block.settings) setting_numbers_.push_back(setting_number(block, setting));
}

void BlockValues::evaluate_settings(const Block& block) {
  setting_values_.clear();
  for (std::size_t i = 0; i < block.settings.size(); ++i) {
    const Setting& setting = block.settings[i];
    if (run_.dialect.syntax.statements == Statements::user_task) check_set_once(block, i);
    Value value = value_before(block, setting.value, i);
    if (value.vacant && run_.dialect.syntax.empty_names) refuse_empty(run_.dialect, block, setting.whole);
    // #2=#1 alone hands on that there is none: in an expression it counts as 0 [V 13.5; N 20.11.3].
    const std::string_view whole = block.at(setting.whole);
    if (value.bracketed) refuse_bracketed(block, setting);
    if (value.vacant && !is_variable_alone(whole.substr(whole.find('=') + 1))) value.vacant = false;
    setting_values_.push_back(value);
  }
}

// In RS274/NGC all values of a block are found before any is set.
Value BlockValues::value_before(const Block& block, std::uint32_t code, std::size_t settings,
                                const Rounding& rounding) {
  if (settings == 0 || run_.dialect.syntax.settings_at_once)
    return evaluator_.run(block, code, system_parameters_, rounding);
  ParametersOfBlock readings(system_parameters_, run_.control.parameters, {setting_numbers_.data(), settings});
  return evaluator_.run(block, code, readings, rounding);
}

void BlockValues::assign(const Block& block) {
  number_settings(block);
  evaluate_settings(block);
  apply(block);
}

// Of the settings of a block before this one.
void BlockValues::check_set_once(const Block& block, std::size_t setting) {
  const auto name = [&](std::size_t of) {
    return std::string(run_.control.parameters.plain(block.at(block.names[block.settings[of].name])));
  };
  for (std::size_t before = 0; before < setting; ++before) {
    if (setting_numbers_[before] != setting_numbers_[setting]) continue;
    if (setting_numbers_[setting] == kNamed && name(before) != name(setting)) continue;
    const Span span = block.settings[setting].span;
    refuse_at(block, span, codes::kNotInterpreted,
              fmt::format("{} is set twice in this block, and no source says which value it has then", block.at(span)),
              "leave one of the two");
  }
}

std::vector<Value> BlockValues::values_of_call(const Block& block) {
  number_settings(block);
  std::vector<Value> values;
  for (std::size_t i = 0; i < block.settings.size(); ++i) {
    const Setting& setting = block.settings[i];
    check_set_once(block, i);
    values.push_back(value_before(block, setting.value, i));
    if (values.back().vacant && run_.dialect.syntax.empty_names) refuse_empty(run_.dialect, block, setting.whole);
  }
  return values;
}

Value BlockValues::variable(const Block& block, std::size_t setting) {
  const Setting& place = block.settings[setting];
  const int number = setting_number(block, place);
  return number == kNamed ? system_parameters_.read(block, block.at(block.names[place.name]), place.span)
                          : system_parameters_.read(block, number, place.span);
}

void BlockValues::set_variable(const Block& block, std::size_t setting, Value value) {
  const Setting& place = block.settings[setting];
  const int number = setting_number(block, place);
  set_parameter(block, place, number, value);
  if (number == kNamed) run_.control.parameters.note_argument(block.at(block.names[place.name]));
}

void BlockValues::set_counted(const Block& block, std::size_t setting, double last) {
  const Setting& place = block.settings[setting];
  const int number = setting_number(block, place);
  set_parameter(block, place, number, {last, false});
  if (number != kNamed && system_parameters_.is_lasting(number)) run_.control.handed.note_counted(number, last);
}

void BlockValues::set_parameter(const Block& block, const Setting& place, int number, Value value) {
  if (run_.control.modal_call.by_variables) {
    refuse_at(block, place.span, codes::kNotInterpreted,
              "a variable is set while a cycle with variables in its brackets is called after each move, and no source "
              "says whether the call takes the new value",
              "end the call with MCALL before, and call it anew after");
  }
  if (number == kNamed) {
    if (run_.dialect.syntax.declared) check_declared_once(run_, block, place);
    if (place.type != VariableType::real) {
      run_.control.parameters.declare(block.at(block.names[place.name]), place.type);
    }
    if (run_.dialect.syntax.unsourced_values && run_.control.parameters.is_whole(block.at(block.names[place.name]))) {
      check_half(block, place.span, value);
      check_range(block, place.span, value);
    }
    run_.control.parameters.set(block.at(block.names[place.name]), value);
    note_handed_name(block, place, value);
  } else if (number == run_.dialect.syntax.alarm_variable) {
    run_.control.ended = true;
    run_.step.stop = StopByVariable::alarm;
  } else if (number == run_.dialect.syntax.message_variable) {
    if (run_.step.stop == StopByVariable::none) run_.step.stop = StopByVariable::message;
    if (!run_.settings.keeps_position.contains(0)) lose_position(run_, AxisSet::all());  // as after M0
  } else {
    run_.step.sets_kept_variable = run_.step.sets_kept_variable || system_parameters_.is_kept(number);
    if (system_parameters_.goes_to_next_pass(number)) {
      run_.control.of_main.note_set(number, block.at(place.span), block.line, value);
    }
    if (system_parameters_.is_lasting(number)) {
      run_.control.handed.note_set(number, block.at(place.span), block.line, value);
    }
    run_.control.parameters.set(number, value);
  }
}

// #<_name>, which all programs see
void BlockValues::note_handed_name(const Block& block, const Setting& place, Value value) {
  if (run_.dialect.syntax.system_variables != SystemVariables::rs274) return;
  const std::string_view name = run_.control.parameters.plain(block.at(block.names[place.name]));
  if (name.starts_with('_')) run_.control.handed.note_set(name, block.line, value);
}

void BlockValues::apply(const Block& block) {
  for (std::size_t i = 0; i < block.settings.size(); ++i) {
    if (setting_numbers_[i] == kNamed) check_variable(run_, block, block.settings[i]);
    set_parameter(block, block.settings[i], setting_numbers_[i], setting_values_[i]);
  }
}

}  // namespace plumbline::nc
