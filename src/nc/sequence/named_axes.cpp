#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <set>
#include <string>

#include <fmt/format.h>

#include "base/diagnostic.hpp"
#include "base/text/characters.hpp"
#include "nc/sequence/flow_block.hpp"
#include "nc/sequence/program.hpp"
#include "nc/sequence/subprogram_file.hpp"
#include "nc/syntax/line_head.hpp"
#include "nc/syntax/line_source.hpp"
#include "nc/syntax/parser.hpp"

namespace plumbline::nc {
namespace {

namespace fs = std::filesystem;

constexpr double kBeyondCodes = 1e4;
constexpr double kBeyondPrograms = 1e9;

// What a word that is a code and no expression does; nothing of others.
std::optional<Action> action_of(const Word& word, const Dialect& dialect) {
  if (word.expression != kLiteral || std::abs(word.value) >= kBeyondCodes) return std::nullopt;
  const CodeRow* const row = dialect.row_of(word);
  return row == nullptr ? std::nullopt : std::optional(row->action);
}

bool has_action(const Block& block, const Dialect& dialect, Action action) {
  return std::any_of(block.words.begin(), block.words.end(),
                     [&](const Word& word) { return action_of(word, dialect) == action; });
}

// M98; M97 stays within the program.
bool calls_by_code(const Block& block, const Dialect& dialect) {
  return std::any_of(block.words.begin(), block.words.end(), [&](const Word& word) {
    return action_of(word, dialect) == Action::call_program && dialect.row_of(word)->value == 0;
  });
}

bool ends_program(const Block& block, const Dialect& dialect) {
  return !block.block_delete && has_action(block, dialect, Action::end);
}

// After G65 letters are arguments.
void add_axes(const Block& block, const Dialect& dialect, AxisSet& axes) {
  for (const Word& word : block.words) {
    if (action_of(word, dialect) == Action::call_macro) return;
    if (const std::optional<Axis> axis = axis_of(word.letter)) axes.insert(*axis);
  }
}

// The name of the subprogram that the line calls; empty: none, or one that only executing it tells.
std::string called_name(const Block& block, const Dialect& dialect) {
  if (block.flow.word == FlowWord::call && block.flow.label == kLiteral) {
    if (!dialect.syntax.case_of_files) return program_name(block.at(block.flow.name), dialect);
    std::string name;
    for (const char c : block.at(block.flow.name)) {
      if (c != ' ' && c != '\t') name += lower(c);
    }
    return name;
  }
  if (block.flow.word == FlowWord::call) {
    const Instruction& label = block.code.at(block.flow.label);
    return label.operation == Operation::number ? fmt::format("{}", std::lround(label.number)) : "";
  }
  const bool by_code = calls_by_code(block, dialect);
  const Word* const program = find_word(block, 'P');
  if (program == nullptr || program->expression != kLiteral || std::abs(program->value) >= kBeyondPrograms) return {};
  if (!by_code && !has_action(block, dialect, Action::call_macro)) return {};
  long number = std::lround(program->value);
  if (by_code && dialect.behaviour.call_repeat_digits > 0 && find_word(block, 'L') == nullptr) {
    number %= std::lround(std::pow(10, dialect.behaviour.call_repeat_digits));
  }
  return fmt::format("{}", number);
}

// After the end of the program nothing is executed unless something jumps there.
bool may_jump(const Block& block, const Dialect& dialect) {
  const FlowWord word = block.flow.word;
  return word == FlowWord::call || word == FlowWord::go_to || word == FlowWord::choose || calls_part(block) ||
         has_action(block, dialect, Action::call_program) || has_action(block, dialect, Action::call_macro);
}

// CYCLE800() ends a plane. Where the axes go then only the machine knows: what it does not name is not known behind it.
bool is_bare(const Block& block) {
  return std::all_of(block.arguments.begin(), block.arguments.end(),
                     [](const Argument& argument) { return argument.expression == kLiteral; });
}

// Codes that move the rotary axes without naming them, and directions of the tool.
bool turns_tool(const Block& block, const Dialect& dialect) {
  for (const Word& word : block.words) {
    const bool is_plain_code = word.letter == 'G' && action_of(word, dialect).has_value();
    if (word.use == WordUse::tool_vector || (is_plain_code && dialect.row_of(word)->tool_vectors)) return true;
  }
  return has_action(block, dialect, Action::tool_on_plane) ||
         (has_action(block, dialect, Action::swivel) && !is_bare(block));
}

// The axes of a line of G0 to G3 with lengths and a feed, as most lines of a program are: parsing them takes its time.
// Nothing: the line is another one.
std::optional<AxisSet> axes_of_plain_move(std::string_view line) {
  AxisSet axes;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = lower(line[i]);
    if (c != 'g') {
      if (!is_digit(c) && !is_blank(c) && std::string_view(".+-xyzfn").find(c) == std::string_view::npos) return {};
      if (const std::optional<Axis> axis = axis_of(upper(c))) axes.insert(*axis);
      continue;
    }
    std::size_t end = i + 1;
    while (end < line.size() && line[end] == '0') ++end;
    if (end < line.size() && line[end] >= '1' && line[end] <= '3') ++end;
    if (end == i + 1 || (end < line.size() && (is_digit(line[end]) || line[end] == '.'))) return {};
    i = end - 1;
  }
  return axes;
}

class AxisSearch {
 public:
  AxisSearch(const InputFile& program, const Dialect& dialect) : program_(program), dialect_(dialect) {}

  AxisSet run() {
    scan(program_, false);
    return axes_;
  }

 private:
  void scan(const InputFile& file, bool whole) {
    LineSource lines(file, dialect_.syntax.goes_on);
    Parser parser(dialect_);
    Block block;
    Line line;
    while (axes_ != AxisSet::all() && lines.next(line)) {
      // Executing the program refuses such a line; parsing one of 200,000 brackets would take as deep a stack.
      if (!line.whole || longest_line(line.text) > dialect_.line_length) continue;
      if (const std::optional<AxisSet> named = axes_of_plain_move(line.text)) {
        axes_ = axes_ | *named;
        continue;
      }
      block.file = file.name();
      block.text = line.text;
      block.line = line.place.line;
      block.offset = line.place.offset;
      try {
        parser.parse(block);
      } catch (const Refusal&) {
        continue;  // executing the program will say so
      }
      add_axes(block, dialect_, axes_);
      if (turns_tool(block, dialect_)) axes_ = axes_ | AxisSet::rotary();
      follow(block);
      whole = whole || may_jump(block, dialect_);
      if (!whole && ends_program(block, dialect_)) break;
    }
  }

  void follow(const Block& block) {
    const std::string name = called_name(block, dialect_);
    if (name.empty()) return;
    const fs::path path = subprogram_file(program_.name(), name, dialect_);
    if (!path.empty() && seen_.insert(path).second) scan(InputFile(path.generic_string()), true);
  }

  const InputFile& program_;
  const Dialect& dialect_;
  std::set<fs::path> seen_;
  AxisSet axes_;
};

}  // namespace

AxisSet named_axes(const InputFile& file, const Dialect& dialect) { return AxisSearch(file, dialect).run(); }

}  // namespace plumbline::nc
