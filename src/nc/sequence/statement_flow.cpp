#include "nc/sequence/statement_flow.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "nc/control/expression.hpp"
#include "nc/language/codes.hpp"
#include "nc/language/refusal.hpp"

namespace plumbline::nc {

void refuse_statement(const Block& block, std::string_view code, std::string message, std::string help) {
  const bool is_word = block.flow.word == FlowWord::none && !block.words.empty();
  refuse_at(block, is_word ? block.words.front().span : block.flow.span, code, std::move(message), std::move(help));
}

StatementFlow::StatementFlow(const InputFile& program, const Dialect& dialect, Interpreter& interpreter)
    : dialect_(dialect), interpreter_(interpreter) {
  files_.push_back(std::make_unique<File>(
      File{nullptr, &program, LineSource(program, dialect.syntax.goes_on), false, {}, false, {}}));
}

bool StatementFlow::next(Line& line) {
  if (skip_) skip(*std::exchange(skip_, std::nullopt));
  while (files_[file_]->lines.next(line)) {
    if (leaves_section(line)) continue;
    if (!begun_) {
      const LineHead head = head_of(line.text, dialect_);
      begun_ = !head.empty && head.program.empty();
    }
    return true;
  }
  if (!called()) return false;
  Place place;
  place.file = file();
  refuse(codes::kFlowOpen, fmt::format("the file ends inside subprogram {}", calls_.back().name),
         "end it with M99, RTS, M17 or RET, as its control has it", std::move(place));
}

bool StatementFlow::take(const Block& block) {
  switch (block.flow.word) {
    case FlowWord::program:
    case FlowWord::sub:
      head(block);
      return true;
    case FlowWord::go_to:
      used_ = true;
      if (!block.flow.values.empty() && !condition(block)) return true;
      if (block.flow.label == kLiteral) {
        jump(block, canonical_label(block.at(block.flow.name)), block.flow.direction);
      } else {
        jump(block, fmt::format("N{}", number_of(block, block.flow.label, "the number to go on at")), Direction::both);
      }
      return true;
    case FlowWord::choose:
      choose(block);
      return true;
    case FlowWord::repeat_section:
    case FlowWord::repeat_line:
      repeat(block);
      return true;
    case FlowWord::if_then:
      used_ = true;
      if (condition(block)) interpreter_.assign(block);
      return true;
    case FlowWord::define:
      interpreter_.assign(block);
      return true;
    case FlowWord::call:
      call(block);
      return true;
    case FlowWord::give_back:
      if (!called()) {
        ended_ = true;
      } else {
        leave(block);
      }
      return true;
    case FlowWord::begin_if:
      used_ = true;
      if (!condition(block)) leave_out(block, FlowWord::begin_if, FlowWord::end_if, true, 0);
      return true;
    case FlowWord::otherwise:  // reached from above: the branch before it was executed
      leave_out(block, FlowWord::begin_if, FlowWord::end_if, false, 0);
      return true;
    case FlowWord::end_if:
      return true;
    case FlowWord::begin_while:
    case FlowWord::begin_do:
    case FlowWord::begin_loop:
    case FlowWord::begin_repeat:
      used_ = true;
      begin_loop(block);
      return true;
    case FlowWord::begin_for:
      used_ = true;
      steer_for(block);
      return true;
    default:
      end_loop(block);
      return true;
  }
}

// The name of a program: of the one that begins here, or of the one behind it.
void StatementFlow::head(const Block& block) {
  if (!begun_ || block.flow.word == FlowWord::sub) {
    begun_ = true;
    const std::vector<Value> none;
    const std::vector<Value>& arguments = called() ? calls_.back().arguments : none;
    for (std::size_t i = 0; i < block.settings.size(); ++i) {
      interpreter_.set_variable(block, i, i < arguments.size() ? arguments[i] : Value{0, true});
    }
    return;
  }
  if (called()) {
    refuse_statement(block, codes::kFlowOpen,
                     fmt::format("subprogram {} runs into the next program", calls_.back().name),
                     "end it with M99, RTS, M17 or RET, as its control has it");
  }
  ended_ = true;
}

namespace {

// What stands behind the second % of a tape never reaches the control; %_N_ of a SINUMERIK begins another program.
bool ends_tape(std::string_view line, bool begun, const Dialect& dialect) {
  const std::size_t first = line.find_first_not_of(" \t");
  const bool percent = first != std::string_view::npos && line[first] == '%';
  return percent && begun && dialect.syntax.statements != Statements::high_level;
}

// What the lines of a tape begin with.
template <class Take>
void for_each_head(const InputFile& file, const Dialect& dialect, const Take& take) {
  LineSource lines(file, dialect.syntax.goes_on);
  bool begun = false;
  for (Line line; lines.next(line);) {
    if (ends_tape(line.text, begun, dialect)) return;
    const LineHead head = head_of(line.text, dialect);
    begun = begun || !head.empty;
    take(head, line.place);
  }
}

}  // namespace

void StatementFlow::index_programs(File& file) const {
  if (std::exchange(file.has_index, true)) return;
  for_each_head(*file.file, dialect_, [&](const LineHead& head, const LinePlace& place) {
    if (!head.program.empty()) file.programs.emplace_back(head.program, place);
  });
}

void StatementFlow::index_labels(File& file) const {
  if (std::exchange(file.has_labels, true)) return;
  for_each_head(*file.file, dialect_, [&](const LineHead& head, const LinePlace& place) {
    if (!head.number.empty()) file.labels[head.number].push_back(place);
    if (!head.label.empty()) file.labels[head.label].push_back(place);
  });
}

// Forward from this line to the end of the program, then from its begin; backward: the nearest
// before it.
const LinePlace* StatementFlow::find_label(const std::string& label, std::size_t line, Direction direction) {
  File& file = *files_[file_];
  index_programs(file);
  index_labels(file);
  std::size_t first = 0;
  std::size_t end = std::string::npos;
  for (const auto& [name, place] : file.programs) {
    if (place.line <= line) {
      first = place.line;
    } else {
      end = place.line;
      break;
    }
  }
  const auto found = file.labels.find(label);
  if (found == file.labels.end()) return nullptr;
  const LinePlace* before = nullptr;
  const LinePlace* nearest = nullptr;
  const LinePlace* behind = nullptr;
  for (const LinePlace& place : found->second) {
    if (place.line < first || place.line >= end) continue;
    if (place.line <= line) {
      if (before == nullptr) before = &place;
      nearest = &place;
    } else if (behind == nullptr) {
      behind = &place;
    }
  }
  if (direction == Direction::forward) return behind;
  if (direction == Direction::backward) return nearest;
  return behind != nullptr ? behind : before;
}

void StatementFlow::jump(const Block& block, const std::string& label, Direction direction) {
  used_ = true;
  const LinePlace* const place = find_label(label, block.line, direction);
  if (place == nullptr) {
    refuse_statement(block, codes::kFlowLabel, fmt::format("there is no label {} to go on at", label),
                     direction == Direction::both ? "add it to this program, or check its name"
                                                  : "it is looked for in one direction alone: check that as well");
  }
  check_jump_in_section(block, *place);
  files_[file_]->lines.seek(*place);
}

void StatementFlow::begin_loop(const Block& block) {
  const LinePlace here{block.offset, block.line};
  std::vector<Loop>& all = loops();
  const auto again =
      std::find_if(all.begin(), all.end(), [&](const Loop& loop) { return loop.begin.line == here.line; });
  const std::uint64_t pass = again == all.end() ? 1 : again->pass;
  all.erase(again, all.end());  // left by a jump, or reached from its end
  const int number = block.flow.label == kLiteral ? 0 : number_of(block, block.flow.label, "the number of a loop");
  if (block.flow.word == FlowWord::begin_while && !condition(block)) {
    return leave_out(block, FlowWord::begin_while, FlowWord::end_while, false, number);
  }
  all.push_back({block.flow.word, number, here, files_[file_]->lines.place(), pass});
}

void StatementFlow::steer_for(const Block& block) {
  const bool again = std::exchange(again_, false);
  const LinePlace here{block.offset, block.line};
  std::vector<Loop>& all = loops();
  if (again) {
    Value value = interpreter_.variable(block, 0);
    value.number += 1;
    interpreter_.set_variable(block, 0, value);
  } else {
    const auto old =
        std::find_if(all.begin(), all.end(), [&](const Loop& loop) { return loop.begin.line == here.line; });
    all.erase(old, all.end());
    interpreter_.assign(block);
    all.push_back({FlowWord::begin_for, 0, here, files_[file_]->lines.place(), 1});
  }
  const double limit = interpreter_.value_of(block, block.flow.values.front(), block.flow.span);
  if (interpreter_.variable(block, 0).number <= limit) return;
  all.pop_back();
  leave_out(block, FlowWord::begin_for, FlowWord::end_for, false, 0);
}

StatementFlow::Loop& StatementFlow::loop_of(const Block& block, FlowWord word, int number) {
  std::vector<Loop>& all = loops();
  const bool macro = dialect_.syntax.statements == Statements::macro_b;
  while (!all.empty()) {
    Loop& loop = all.back();
    if (macro ? loop.number == number : loop.word == word) return loop;
    all.pop_back();
  }
  refuse_statement(block, codes::kFlowLabel, "this ends a loop that was not begun",
                   "each end of a loop has its begin before it, in the same program");
}

void StatementFlow::end_loop(const Block& block) {
  const auto go_back = [&](FlowWord word, int number, bool to_begin) {
    Loop& loop = loop_of(block, word, number);
    note_pass(loop);
    files_[file_]->lines.seek(to_begin ? loop.begin : loop.content);
  };
  switch (block.flow.word) {
    case FlowWord::end_while:
      return go_back(FlowWord::begin_while,
                     block.flow.label == kLiteral ? 0 : number_of(block, block.flow.label, "the number of a loop"),
                     true);
    case FlowWord::end_for:
      again_ = true;
      return go_back(FlowWord::begin_for, 0, true);
    case FlowWord::end_loop:
      return go_back(FlowWord::begin_loop, 0, false);
    default:
      loop_of(block, FlowWord::begin_repeat, 0);
      if (!condition(block)) return go_back(FlowWord::begin_repeat, 0, false);
      loops().pop_back();
  }
}

// Reading goes on behind the line that closes what this one opens.
void StatementFlow::leave_out(const Block& block, FlowWord opens, FlowWord closes, bool stops_at_else, int number) {
  Skip skip{opens, closes, stops_at_else, number, {}};
  skip.from.file = block.file;
  skip.from.line = block.line;
  skip.from.column = std::size_t{block.flow.span.begin} + 1;
  skip.from.length = std::max<std::size_t>(block.flow.span.end - block.flow.span.begin, 1);
  skip.from.text = block.text;
  skip_ = std::move(skip);
  used_ = true;
}

// The lines between are not parsed, as the control does not.
void StatementFlow::skip(const Skip& skip) {
  int depth = 1;
  const bool macro = dialect_.syntax.statements == Statements::macro_b;
  for (Line line; files_[file_]->lines.next(line);) {
    const LineHead head = head_of(line.text, dialect_);
    if (!head.program.empty()) break;
    if (macro) {
      if (head.word == skip.closes && head.loop == skip.number) return;
      continue;
    }
    if (head.word == skip.opens) ++depth;
    if (head.word == FlowWord::otherwise && skip.stops_at_else && depth == 1) return;
    if (head.word == skip.closes && --depth == 0) return;
  }
  refuse(codes::kFlowOpen, "what this line begins has no end in this program", "add it", skip.from);
}

bool StatementFlow::condition(const Block& block) {
  return interpreter_.value_of(block, block.flow.values.front(), block.flow.span) != 0;
}

int StatementFlow::number_of(const Block& block, std::uint32_t code, std::string_view what) {
  return whole_number(block, block.flow.span, interpreter_.value_of(block, code, block.flow.span), what);
}

}  // namespace plumbline::nc
