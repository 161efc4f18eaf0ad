#include "nc/sequence/statement_flow.hpp"

#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/diagnostic.hpp"
#include "nc/language/codes.hpp"
#include "nc/language/refusal.hpp"
#include "nc/sequence/flow_block.hpp"
#include "nc/sequence/program_ends.hpp"
#include "nc/sequence/sections/called_section.hpp"
#include "nc/syntax/line_head.hpp"

namespace plumbline::nc {
namespace {

const LinePlace* find_label(const Block& block, LabelIndex& labels, const Interpreter& interpreter,
                            const std::string& label, std::size_t line, Direction direction) {
  const LinePlace* const place = labels.find_label(label, line, direction);
  if (place != nullptr) labels.check_once(block, label, line, direction);
  if (place == nullptr || !labels.is_behind_slash(place->line)) return place;
  if (interpreter.may_leave_out_skipped()) {
    refuse_flow(block, codes::kBlockDelete,
                fmt::format("{} stands behind / in line {}: whether the control finds it there depends on a switch of "
                            "the control",
                            label, place->line),
                "say how it stands: --block-delete on leaves the block out, off executes it");
  }
  if (!interpreter.leaves_out_skipped()) return place;
  refuse_flow(block, codes::kNotInterpreted,
              fmt::format("{} stands in line {}, which is left out because of its /, and whether the control finds it "
                          "there was found in no source",
                          label, place->line),
              "put the label into a line of its own, without /");
}

// N010 is N10 to who compares numbers, and another label to who compares texts.
void check_zeros(const Block& block, LabelIndex& labels, std::string_view label, const LinePlace& place) {
  if (zeros_of_label(label) == labels.zeros_at(place.line)) return;
  refuse_flow(block, codes::kNotInterpreted,
              fmt::format("{} stands in line {} with other zeros before its number, and whether the control takes it "
                          "for the same was found in no source",
                          label, place.line),
              "write the label as it stands there");
}

// M97: the block with that number, in the program that calls.
LinePlace part_called(const Block& block, const std::string& number, LabelIndex& labels,
                      const Interpreter& interpreter) {
  const LinePlace* const place = find_label(block, labels, interpreter, number, block.line, Direction::both);
  if (place != nullptr) return *place;
  refuse_flow(block, codes::kFlowLabel, fmt::format("there is no {} in this program to call", number),
              "M97 calls a part of its own program: check its P, or write M98 for another program");
}

}  // namespace

StatementFlow::StatementFlow(const InputFile& program, const Dialect& dialect, Interpreter& interpreter)
    : dialect_(dialect),
      interpreter_(interpreter),
      files_(program, dialect),
      labels_(files_, dialect),
      loops_(files_, labels_, interpreter),
      ways_(files_, labels_, dialect, interpreter) {}

bool StatementFlow::next(Line& line) {
  while (true) {
    const bool is_line = files_.next(line);
    if (const auto there = sections_.after(is_line ? line.place.line : kEndOfFile, calls_.depth())) {
      go_on(*there);
      continue;
    }
    if (!is_line) break;
    if (reading_ == Reading::head || !definitions_.closed()) {
      const LineHead head = head_of(line.text, dialect_);
      if (!head.empty && head.program.empty()) {
        const bool begins = reading_ == Reading::head && called() && head.word != FlowWord::sub;
        if (begins) refuse_without_head(line.text, line.place.line, calls_.top(), files_);
        reading_ = Reading::body;
      }
      definitions_.note(head, line.place.line);
    }
    return true;
  }
  if (!called()) return false;
  Place place;
  place.file = file();
  refuse(codes::kFlowOpen, fmt::format("the file ends inside subprogram {}", calls_.top().name),
         how_programs_end(dialect_), std::move(place));
}

bool StatementFlow::take(const Block& block) {
  if (loops_.ends_left_out(block)) return true;
  switch (block.flow.word) {
    case FlowWord::program:
    case FlowWord::sub:
      definitions_.check(block);
      head(block);
      return true;
    case FlowWord::define:
      definitions_.check(block);
      interpreter_.assign(block);
      return true;
    case FlowWord::choose:
      choose(block);
      return true;
    case FlowWord::call:
      call(block);
      return true;
    case FlowWord::give_back:
      if (called()) {
        leave(block);
      } else {
        reading_ = Reading::after_end;
        returned_ = true;
      }
      return true;
    case FlowWord::end_if:
      loops_.branch(block);
      return true;
    case FlowWord::end_while:
    case FlowWord::end_for:
    case FlowWord::end_loop:
    case FlowWord::until:
      entry_ = loops_.end(block);
      if (entry_.kind == FlowEntry::Kind::pass) ways_.check_way_back(block);
      return true;
    default:
      used_ = true;
      steer(block);
      return true;
  }
}

// Statements that make the steps be no longer in the order of the text.
void StatementFlow::steer(const Block& block) {
  switch (block.flow.word) {
    case FlowWord::go_to:
      if (!block.flow.values.empty() && !condition_holds(interpreter_, block)) return;
      if (block.flow.label == kLiteral) return jump(block, block.at(block.flow.name), block.flow.direction);
      return jump(block, block_name(block, number_of(interpreter_, block, block.flow.label, "the number to go on at")),
                  Direction::both);
    case FlowWord::repeat_section:
    case FlowWord::repeat_line:
      return repeat(block);
    case FlowWord::if_then:
      if (condition_holds(interpreter_, block)) interpreter_.assign(block);
      return;
    case FlowWord::begin_if:
    case FlowWord::otherwise:  // reached from above: the branch before it was executed
      return loops_.branch(block);
    case FlowWord::begin_for:
      announced_ = loops_.begin_for(block);
      return;
    default:
      ways_.check_loop(block);
      return loops_.begin(block);
  }
}

// The name of a program: of the one that begins here, or of the one after it.
void StatementFlow::head(const Block& block) {
  if (reading_ == Reading::head || block.flow.word == FlowWord::sub) {
    reading_ = Reading::body;
    if (!called()) begun_.insert(block.line);
    const bool may_be_sub = dialect_.syntax.archive_heads && !called() && block.flow.word == FlowWord::program;
    if (may_be_sub && !head_of(block.text, dialect_).is_main) check_first_of_archive(labels_);
    const std::vector<Value> none;
    const std::vector<Value>& arguments = called() ? calls_.top().arguments : none;
    if (block.flow.word == FlowWord::sub && called()) take_values(block, calls_.top(), files_);
    Value left_out;
    left_out.of_caller = !called();
    for (std::size_t i = 0; i < block.settings.size(); ++i) {
      interpreter_.set_variable(block, i, i < arguments.size() ? arguments[i] : left_out);
    }
    return;
  }
  if (called()) {
    refuse_flow(block, codes::kFlowOpen, fmt::format("subprogram {} runs into the next program", calls_.top().name),
                how_programs_end(dialect_));
  }
  refuse_unended(block, dialect_.syntax.statements);
  reading_ = Reading::after_end;
}

void StatementFlow::check_others() {
  check_other_programs(labels_, begun_, dialect_, interpreter_.leaves_out_skipped(), returned_);
}

// It ends the file, but where it stands before all else.
void StatementFlow::pass_percent(const Block& block) {
  if (reading_ == Reading::head) return;
  const auto at = static_cast<std::uint32_t>(block.text.find('%'));
  refuse_at(block, {at, at + 1}, codes::kFlowOpen,
            fmt::format("the file ends here, inside subprogram {}", calls_.top().name), how_programs_end(dialect_));
}

void StatementFlow::jump(const Block& block, std::string_view written, Direction direction) {
  used_ = true;
  const std::string label = canonical_label(written);
  const LinePlace* const place = find_label(block, labels_, interpreter_, label, block.line, direction);
  if (place == nullptr) {
    refuse_flow(block, codes::kFlowLabel, fmt::format("there is no label {} to go on at", label),
                direction == Direction::both ? "add it to this program, or check its name"
                                             : "it is looked for in one direction alone: check that as well");
  }
  if (dialect_.syntax.statements != Statements::macro_b) check_zeros(block, labels_, written, *place);
  sections_.check_jump(block, *place, calls_.depth());
  loops_.check_jump(block, block.line, place->line);
  if (place->line <= block.line) ways_.check_way_back(block);
  loops_.leave_by_jump(place->line);
  files_.seek(*place);
}

void StatementFlow::choose(const Block& block) {
  const double value = chosen_by(interpreter_, block, block.flow.values.front());
  for (const Choice& choice : block.flow.choices) {
    const bool is_default = choice.value == kLiteral;
    if (!is_default && chosen_by(interpreter_, block, choice.value) != value) continue;
    return jump(block, block.at(choice.label), choice.direction);
  }
}

void StatementFlow::go_on(const RepeatedSections::GoesOn& there) {
  ways_.forget();
  if (there.entry) entry_ = *there.entry;
  files_.seek(there.at);
}

void StatementFlow::repeat(const Block& block) {
  const int count =
      block.flow.count == kLiteral ? 1 : number_of(interpreter_, block, block.flow.count, "how often this repeats");
  const bool is_called = calls_part(block);
  RepeatedSection section =
      is_called ? section_called(block, files_, labels_, dialect_, interpreter_.has_names()) : section_of(block);
  section.level = calls_.depth();
  section.calling_line = is_called ? block.line : 0;
  if (count <= 0) {
    refuse_flow(block, codes::kOutOfRange, "P asks for no repetition at all",
                "write P=1 or more, or jump over the REPEAT");
  }
  section.remaining = count;
  announced_ = static_cast<std::uint64_t>(count);
  loops_.check_part(block, section.begin.line, section.end - 1);
  go_on(sections_.begin(block, section));
}

// From the label to this line, to ENDLABEL: or to the second label; or the line of the label alone.
RepeatedSection StatementFlow::section_of(const Block& block) {
  const std::vector<Choice>& labels = block.flow.choices;
  const auto place_of_label = [&](const Choice& choice) -> LinePlace {
    const std::string label = canonical_label(block.at(choice.label));
    const LinePlace* const place = find_label(block, labels_, interpreter_, label, block.line, Direction::backward);
    if (place != nullptr) return *place;
    const bool behind = labels_.find_label(label, block.line, Direction::forward) != nullptr;
    refuse_flow(block, behind ? codes::kNotInterpreted : codes::kFlowLabel,
                behind ? label + " stands behind this line, and whether the control looks there was found in no source"
                       : fmt::format("there is no label {} before this line", label),
                "write REPEAT after the part that it repeats, or the part as a subprogram");
  };
  RepeatedSection section;
  section.begin = place_of_label(labels.front());
  section.end = block.line;
  section.back = files_.here().line;
  if (block.flow.word == FlowWord::repeat_line) {
    section.end = section.begin.line + 1;
  } else if (labels.size() == 2) {
    section.end = place_of_label(labels.back()).line + 1;
  } else if (const LinePlace* const end =
                 find_label(block, labels_, interpreter_, "ENDLABEL", section.begin.line, Direction::forward)) {
    if (end->line < block.line) section.end = end->line + 1;
  }
  if (section.end <= section.begin.line || block.line < section.end - 1) {
    refuse_flow(block, codes::kFlowLabel, "the part to repeat ends before it begins", "put its labels in order");
  }
  return section;
}

// CALL OSUB, SUB(1,2): what the arguments are worth is found before the subprogram has variables of its own.
void StatementFlow::call(const Block& block) {
  Call call;
  call.name = program_name(block.at(block.flow.name), dialect_);
  if (block.flow.count != kLiteral) {
    call.remaining = number_of(interpreter_, block, block.flow.count, "the count of calls") - 1;
  }
  if (call.remaining < 0 && dialect_.syntax.zero_calls_unknown) {
    refuse_flow(block, codes::kNotInterpreted, "whether a CALL with Q0 calls once or not at all was found in no source",
                "write Q1 or more, or leave the call out");
  }
  for (const std::uint32_t code : block.flow.values) {
    call.arguments.push_back({interpreter_.value_of(block, code, block.flow.span), true});
  }
  const std::vector<Value> named = interpreter_.values_of_call(block);
  if (call.remaining < 0) refuse_flow(block, codes::kOutOfRange, "P asks for no call at all", "write P1 or more");
  call.entry = program_called(block, call.name, labels_, dialect_);
  enter(block, std::move(call), true);
  for (std::size_t i = 0; i < named.size(); ++i) interpreter_.set_variable(block, i, named[i]);
  if (calls_.top().remaining > 0) interpreter_.remember_call();
}

// M98, G65, M97
void StatementFlow::call_program(const Block& block, const ProgramCall& program) {
  if (program.count <= 0) return;
  Call call;
  call.name = std::to_string(program.number);
  call.by = CalledBy::code;
  call.remaining = program.count - 1;
  if (const std::optional<std::string> whole = program_of_eight_digits(block, program, labels_)) {
    call.name = *whole;
    call.remaining = 0;
  }
  if (program.kind == ProgramCall::Kind::part) {
    call.name.insert(0, 1, 'N');
    call.entry = {files_.current(), part_called(block, call.name, labels_, interpreter_)};
  } else {
    call.entry = program_called(block, call.name, labels_, dialect_);
  }
  const bool macro = program.kind == ProgramCall::Kind::macro;
  enter(block, std::move(call), macro);
  if (macro) interpreter_.set_macro_arguments();
  if (calls_.top().remaining > 0) interpreter_.remember_call();
}

void StatementFlow::enter(const Block& block, Call call, bool own_variables) {
  used_ = true;
  calls_.check_room(block);
  call.back = files_.here();
  call.line = block.line;
  own_variables ? interpreter_.enter_with_own(dialect_.syntax.local_variables) : interpreter_.enter_sharing();
  loops_.enter_call();
  announced_ = static_cast<std::uint64_t>(call.remaining) + 1;
  calls_.push(std::move(call));
  begin_call();
}

void StatementFlow::begin_call() {
  ways_.forget();
  files_.go_to(calls_.top().entry);
  if (files_.in_program()) begun_.insert(calls_.top().entry.line.line);
  reading_ = Reading::head;
  definitions_.begin();
  entry_ = calls_.entry(files_);
}

bool StatementFlow::end_program(const Block& block, const ProgramCall& program) {
  const bool was_called = called();
  const std::size_t from = was_called ? calls_.top().line : block.line;
  if (was_called) {
    if (program.return_to && calls_.top().remaining > 0) {
      refuse_flow(block, codes::kNotInterpreted,
                  fmt::format("{} calls this more than once, and whether P of M99 leaves the calls to come out was "
                              "found in no source",
                              line_of_call(calls_.top(), files_)),
                  "call it once in a block, or leave P out here");
    }
    leave(block);
  } else if (!program.return_to) {
    returned_ = true;
    return false;  // M99 in the main program: one pass
  }
  if (program.return_to) jump_back(block, *program.return_to, from);
  if (program.return_to && !was_called) ways_.check_main_again(block);
  return true;
}

// M99 P100: the caller goes on at N100. `from`: its line that calls.
void StatementFlow::jump_back(const Block& block, int number, std::size_t from) {
  const LinePlace* const place =
      find_label(block, labels_, interpreter_, block_name(block, number), from, Direction::both);
  if (place == nullptr) {
    refuse_flow(block, codes::kFlowLabel,
                fmt::format("there is no N{} to return to in the program that called", number), "check the P of M99");
  }
  used_ = true;
  loops_.check_jump(block, from, place->line);
  loops_.leave_by_jump(place->line);
  files_.seek(*place);
}

void StatementFlow::leave(const Block& block) {
  refuse_without_head(block.text, block.line, calls_.top(), files_);
  sections_.leave(calls_.depth());
  if (calls_.begins_again()) {
    interpreter_.call_again();
    loops_.begin_call_again();
    begin_call();
    return;
  }
  ways_.forget();
  interpreter_.leave_subprogram(block);
  files_.go_to(calls_.top().back);
  calls_.pop();
  loops_.leave_call();
  reading_ = Reading::body;
  definitions_.close();
}

}  // namespace plumbline::nc
