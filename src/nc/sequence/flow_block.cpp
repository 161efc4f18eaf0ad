#include "nc/sequence/flow_block.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "nc/control/parameters/expression.hpp"
#include "nc/language/codes.hpp"
#include "nc/language/refusal.hpp"
#include "nc/sequence/subprogram_file.hpp"

namespace plumbline::nc {

Span steering_span(const Block& block) {
  const bool is_word = block.flow.word == FlowWord::none && !block.words.empty();
  return is_word ? block.words.front().span : block.flow.span;
}

Place steering_place(const Block& block) {
  const Span span = steering_span(block);
  Place place;
  place.file = block.file;
  place.line = block.line;
  place.column = std::size_t{span.begin} + 1;
  place.length = std::max<std::size_t>(span.end - span.begin, 1);
  place.text = block.text;
  return place;
}

void refuse_flow(const Block& block, std::string_view code, std::string message, std::string help) {
  refuse_at(block, steering_span(block), code, std::move(message), std::move(help));
}

bool condition_holds(Interpreter& interpreter, const Block& block) {
  return interpreter.value_of(block, block.flow.values.front(), block.flow.span) != 0;
}

double chosen_by(Interpreter& interpreter, const Block& block, std::uint32_t code) {
  const double value = interpreter.value_of(block, code, block.flow.span);
  if (value == std::trunc(value)) return value;
  refuse_flow(block, codes::kNotWhole, fmt::format("CASE chooses by {}, which is no whole number", value),
              "choose by whole numbers, as ROUND makes them, or by IF");
}

int number_of(Interpreter& interpreter, const Block& block, std::uint32_t code, std::string_view what) {
  return whole_number(block, block.flow.span, interpreter.value_of(block, code, block.flow.span), what);
}

// "N0 must not be used" [B-63684EN p. 129], and GOTO 0 is an alarm.
std::string block_name(const Block& block, int number) {
  if (number < 1) {
    refuse_flow(block, codes::kOutOfRange, fmt::format("there is no block N{} to go on at", number),
                "blocks have the numbers 1 to 99999: give that block another one");
  }
  return fmt::format("N{}", number);
}

namespace {

[[noreturn]] void refuse_missing_program(const Block& block, const std::string& name, LabelIndex& labels,
                                         const Dialect& dialect) {
  if (const std::optional<LinePlace> behind = labels.behind_end(name)) {
    refuse_flow(block, codes::kFlowOpen,
                fmt::format("subprogram {} stands in line {}, behind the second %: the control stops reading there",
                            name, behind->line),
                "take out the % between the two programs, or put the subprogram into a file of its own");
  }
  if (const std::string other = labels.name_with_other_zeros(name); !other.empty()) {
    refuse_flow(block, codes::kFlowOpen,
                fmt::format("there is no subprogram {}, but {}: whether the control takes it for the same was found in "
                            "no source",
                            name, other),
                "call it by its name as it is written there");
  }
  const std::string_view if_no_program =
      dialect.syntax.calls_by_name ? "; if it is a word of the control, it is not interpreted: a file in its place "
                                     "would only pass it over"
                                   : "";
  refuse_flow(block, codes::kFlowOpen, fmt::format("subprogram {} is neither in this file nor beside it", name),
              fmt::format("put it into a file of its name beside the program, as {}{}",
                          subprogram_file_name(name, dialect), if_no_program));
}

// Libraries are known to a control before a program runs: which of two it takes does not depend on the order of calls.
void check_one_file(const Block& block, LabelIndex& labels, const std::string& name, const FilePlace& found) {
  const std::optional<LabelIndex::SameName> same = labels.find_same_name(name, found);
  if (!same) return;
  refuse_flow(block, "nc-subprogram-ambiguous",
              fmt::format("subprogram {} begins in {} and in {}, and which of them the control takes was found in no "
                          "source",
                          same->name, same->one, same->other),
              "move away the one that the control does not have, or give them names of their own");
}

}  // namespace

FilePlace program_called(const Block& block, const std::string& name, LabelIndex& labels, const Dialect& dialect) {
  if (const std::optional<FilePlace> found = labels.find_program(name)) {
    if (labels.is_twice(name)) {
      refuse_flow(block, codes::kFlowOpen, fmt::format("several programs of these files are named {}", name),
                  "leave the one that is meant, or give them names of their own");
    }
    if (dialect.syntax.statements == Statements::user_task) check_one_file(block, labels, name, *found);
    return *found;
  }
  refuse_missing_program(block, name, labels, dialect);
}

// A control whose programs have eight digits calls O00020003 once.
std::optional<std::string> program_of_eight_digits(const Block& block, const ProgramCall& program, LabelIndex& labels) {
  std::string whole = std::to_string(program.whole);
  if (program.whole == 0 || !labels.begins_in(0, whole)) return std::nullopt;
  if (labels.begins_in(0, std::to_string(program.number))) {
    refuse_flow(
        block, "nc-subprogram-ambiguous",
        fmt::format("P calls program {} once where programs have eight digits, and program {} {} times elsewhere",
                    whole, program.number, program.count),
        "say how often with L, as in M98 P3 L2");
  }
  return whole;
}

}  // namespace plumbline::nc
