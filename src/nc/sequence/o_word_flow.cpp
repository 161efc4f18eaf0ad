#include "nc/sequence/o_word_flow.hpp"

#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/diagnostic.hpp"
#include "nc/language/codes.hpp"
#include "nc/sequence/flow_block.hpp"
#include "nc/sequence/subprogram_file.hpp"

namespace plumbline::nc {
namespace {

std::string label_of(const Block& block, Interpreter& interpreter) {
  const Flow& flow = block.flow;
  if (flow.label == kLiteral) return std::string(interpreter.control().parameters.plain(block.at(flow.name)));
  return std::to_string(number_of(interpreter, block, flow.label, "the label of an O word"));
}

// The label of a line that is left out may depend on what only the subprogram around it sets: it is no other one's
// then.
std::string label_of_skipped(const Block& block, Interpreter& interpreter) {
  try {
    return label_of(block, interpreter);
  } catch (const Refusal& refusal) {
    if (refusal.diagnostic().code != codes::kParameterUnset) throw;
    return {};
  }
}

// o<subs/deep> CALL calls o<deep>, of the file subs/deep.ngc where none was met so far [LinuxCNC, measured].
std::string without_folder(const std::string& name) { return name.substr(name.rfind('/') + 1); }

bool is_of_subprogram(FlowWord word) {
  return word == FlowWord::program || word == FlowWord::sub || word == FlowWord::end_sub || word == FlowWord::call ||
         word == FlowWord::give_back;
}

}  // namespace

OWordFlow::OWordFlow(const InputFile& program, const Dialect& dialect, Interpreter& interpreter)
    : interpreter_(interpreter), files_(program, dialect), loops_(files_, interpreter) {}

bool OWordFlow::next(Line& line) {
  if (files_.next(line)) return true;
  end_of_text();
  if (!called()) return false;
  Place place;
  place.file = file();
  refuse(codes::kFlowOpen, fmt::format("the file ends inside subprogram {}", calls_.top().name),
         "end it with O<name> ENDSUB, or with M99 if M98 calls it", std::move(place));
}

void OWordFlow::end_of_text() {
  if (!left_out_) return;
  refuse(codes::kFlowOpen, fmt::format("the file ends before {} was found", left_out_->what),
         "add it, or put the subprogram into a file of its name beside the program; the control reads nothing after "
         "the % that ends a program, and no % around a file that a program with % calls",
         left_out_->from);
}

// Loops and branches of a subprogram have labels of their own.
std::string OWordFlow::scoped(const std::string& label) const {
  return called() ? calls_.top().name + '#' + label : label + '#';
}

bool OWordFlow::take(const Block& block) {
  const FlowWord word = block.flow.word;
  const bool ends = word == FlowWord::end_sub && !skipping() && called();  // of any label [LinuxCNC, measured]
  std::string label = ends         ? calls_.top().name
                      : skipping() ? label_of_skipped(block, interpreter_)
                                   : label_of(block, interpreter_);
  if (!is_of_subprogram(word)) label = scoped(label);
  if (leaves_out(LeftOut::Until::end_sub)) check_not_nested(block);
  if (left_out_ && !left_out_->ends_at(word, label)) return false;
  switch (word) {
    case FlowWord::program:
    case FlowWord::sub:
      define(block, label);
      return true;
    case FlowWord::end_sub:
    case FlowWord::give_back:
      give_back(block);
      return true;
    case FlowWord::call:
      enter(block, {.name = without_folder(label), .back = files_.here()}, label);
      return true;
    default:
      used_ = true;
      entry_ = loops_.steer(block, label, left_out_);
      return true;
  }
}

// "Nested subroutine definition" [LinuxCNC, measured], of any label.
void OWordFlow::check_not_nested(const Block& block) {
  if (block.flow.word != FlowWord::sub && block.flow.word != FlowWord::program) return;
  refuse_flow(block, codes::kFlowLabel,
              fmt::format("a subprogram begins here, inside that of line {}", left_out_->from.line),
              "end that one with ENDSUB before it");
}

// Met on the way: a definition, passed over; looked for: the begin of the call.
void OWordFlow::define(const Block& block, const std::string& label) {
  const bool is_sought = leaves_out(LeftOut::Until::subprogram);
  const CalledBy by = block.flow.word == FlowWord::program ? CalledBy::code : CalledBy::statement;
  if (called() && (is_sought || by == CalledBy::code) && by != calls_.top().by) {
    refuse_flow(block, codes::kFlowLabel,
                by == CalledBy::code ? "this program begins with O and a number, and O CALL calls it"
                                     : "this subprogram begins with SUB, and M98 calls it",
                "M98 calls programs that begin with O100 and end with M99, O100 CALL those between SUB and ENDSUB");
  }
  if (by == CalledBy::code && !is_sought) return;
  used_ = true;
  if (is_sought || !called()) {
    if (!subprograms_.try_emplace(label, FilePlace{files_.current(), place_of_line(block)}).second) {
      refuse_flow(block, codes::kFlowLabel, "this subprogram was called or defined before",
                  "define it once, before the first move or after the end of the program (M2)");
    }
  }
  left_out_.reset();
  if (is_sought || called()) return;
  left_out_ = {LeftOut::Until::end_sub, label, "the ENDSUB of this subprogram", steering_place(block)};
}

void OWordFlow::enter(const Block& block, Call call, const std::string& file) {
  used_ = true;
  calls_.check_room(block);
  std::vector<double> arguments;
  for (const std::uint32_t code : block.flow.values) {  // M98 has none
    arguments.push_back(interpreter_.value_of(block, code, block.flow.span));
  }
  if (arguments.size() > static_cast<std::size_t>(kLocalParameters)) {
    refuse_flow(block, codes::kFlowControl, "a call takes 30 arguments at most", "set global parameters instead");
  }
  left_out_.reset();
  interpreter_.enter_o_word(call.by == CalledBy::statement ? LocalNumbers::own : LocalNumbers::callers, arguments);
  call.line = block.line;
  calls_.push(std::move(call));
  go_to_subprogram(block, calls_.top().name, file);
  entry_ = calls_.entry(files_);
}

void OWordFlow::go_to_subprogram(const Block& block, const std::string& name, const std::string& file) {
  if (const auto at = subprograms_.find(name); at != subprograms_.end()) return files_.go_to(at->second);
  if (!is_below(file)) {
    refuse_flow(block, codes::kFlowOpen,
                fmt::format("{} stands in a folder that is not below that of the program, where nothing is read", file),
                "put the file beside the program, or into a folder there, and call it by that");
  }
  left_out_ = {LeftOut::Until::subprogram, name, fmt::format("subprogram {}", name), steering_place(block)};
  if (const std::optional<std::size_t> opened = files_.open_beside(file)) files_.go_to({*opened, {}});
}

void OWordFlow::call_program(const Block& block, const ProgramCall& call) {
  const std::string name = std::to_string(call.number);
  enter(block, {.name = name, .by = CalledBy::code, .back = files_.here(), .remaining = call.count - 1}, name);
  if (call.count > 0) {
    announced_ = static_cast<std::uint64_t>(call.count);
    return;
  }
  left_out_.reset();  // L0: the control stays here, and the next M99 returns to here [LinuxCNC, measured]
  files_.go_to(calls_.top().back);
}

bool OWordFlow::end_program(const Block& block, const ProgramCall& /*call*/) {
  if (!called()) return false;
  if (calls_.top().by == CalledBy::statement) {
    refuse_flow(block, codes::kFlowLabel, "M99 inside a subprogram that began with SUB", "end it with ENDSUB");
  }
  keep_value(false, {0, true});
  if (calls_.begins_again()) {
    interpreter_.end_pass(block);
    interpreter_.control().parameters.forget_own_names();  // each pass has names of its own [LinuxCNC, measured]
    files_.go_to(subprograms_.at(calls_.top().name));
    entry_ = calls_.entry(files_);
  } else {
    leave(block);
  }
  return true;
}

// ENDSUB and RETURN, with a value or without; either may bear any label [LinuxCNC, measured].
void OWordFlow::give_back(const Block& block) {
  if (leaves_out(LeftOut::Until::end_sub)) {
    keep_value_passed_over(block);
    return left_out_.reset();
  }
  if (!called() || calls_.top().by == CalledBy::code) {
    refuse_flow(block, codes::kFlowLabel, "no subprogram is being executed that this could end",
                "a subprogram that M98 calls ends with M99");
  }
  const bool gives = !block.flow.values.empty();
  keep_value(gives, {gives ? interpreter_.value_of(block, block.flow.values.front(), block.flow.span) : 0.0, true});
  leave(block);
}

void OWordFlow::keep_value(bool given, Value value) {
  Parameters& parameters = interpreter_.control().parameters;
  parameters.set("_value_returned", {given ? 1.0 : 0.0, true});
  parameters.set("_value", value);
}

// The control evaluates the value behind ENDSUB of a definition that it passes over, too [LinuxCNC, measured].
void OWordFlow::keep_value_passed_over(const Block& block) {
  const bool gives = !block.flow.values.empty();
  Value value{0.0, true};
  try {
    if (gives) value.number = interpreter_.value_of(block, block.flow.values.front(), block.flow.span);
  } catch (const Refusal& refusal) {
    if (refusal.diagnostic().code != codes::kParameterUnset && refusal.diagnostic().code != codes::kValueUnknown) throw;
    value.known = false;
  }
  keep_value(gives, value);
}

void OWordFlow::leave(const Block& block) {
  left_out_.reset();
  interpreter_.leave_subprogram(block);
  files_.go_to(calls_.top().back);
  calls_.pop();
}

}  // namespace plumbline::nc
