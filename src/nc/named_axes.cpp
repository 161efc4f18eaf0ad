#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <string>

#include <fmt/format.h>

#include "base/characters.hpp"
#include "base/diagnostic.hpp"
#include "nc/line_source.hpp"
#include "nc/parser.hpp"
#include "nc/program.hpp"

namespace plumbline::nc {
namespace {

namespace fs = std::filesystem;

constexpr double kBeyondCodes = 1e4;

bool ends_program(const Block& block, const Dialect& dialect) {
  if (block.block_delete) return false;
  return std::any_of(block.words.begin(), block.words.end(), [&](const Word& word) {
    const bool is_code = word.letter == 'M' && word.expression == kLiteral && std::abs(word.value) < kBeyondCodes;
    if (!is_code) return false;
    const CodeRow* const row = dialect.m_code(static_cast<int>(word.value * 10));
    return row != nullptr && row->action == Action::end;
  });
}

void add_axes(const Block& block, AxisSet& axes) {
  for (const Word& word : block.words) {
    for (const Axis axis : kAllAxes) {
      if (word.letter == letter(axis)) axes.insert(axis);
    }
  }
}

bool calls(const Block& block) {
  const Word* const code = find_word(block, 'M');
  return block.flow.word == FlowWord::call || (code != nullptr && code->value == 98);
}

// The file of a subprogram that the line calls, beside the program; empty: none.
fs::path called_file(const Block& block, const fs::path& folder) {
  std::string name;
  if (block.flow.word == FlowWord::call && block.flow.label == kLiteral) {
    for (const char c : block.at(block.flow.name)) {
      if (c != ' ' && c != '\t') name += lower(c);
    }
  } else if (block.flow.word == FlowWord::call && block.code.at(block.flow.label).operation == Operation::number) {
    name = fmt::format("{}", std::lround(block.code[block.flow.label].number));
  } else if (const Word* program = find_word(block, 'P'); program != nullptr && program->expression == kLiteral) {
    if (calls(block)) name = fmt::format("{}", std::lround(program->value));
  }
  if (name.empty()) return {};
  const fs::path path = folder / (name + ".ngc");
  std::error_code ignored;  // a name too long for a file is none
  return fs::is_regular_file(path, ignored) ? path : fs::path();
}

void scan(const InputFile& file, const Dialect& dialect, std::set<fs::path>& seen, AxisSet& axes) {
  LineSource lines(file);
  Parser parser(dialect);
  Block block;
  Line line;
  bool jumps = !seen.empty();  // then what stands behind the end may be executed as well
  while (axes != AxisSet::all() && lines.next(line)) {
    // Executing the program refuses such a line; parsing one of 200,000 brackets would take as deep a stack.
    if (!line.whole || line.text.size() > dialect.line_length) continue;
    block.file = file.name();
    block.text = line.text;
    block.line = line.place.line;
    block.offset = line.place.offset;
    try {
      parser.parse(block);
    } catch (const Refusal&) {
      continue;  // executing the program will say so
    }
    add_axes(block, axes);
    const fs::path called = called_file(block, fs::path(file.name()).parent_path());
    if (!called.empty() && seen.insert(called).second) scan(InputFile(called.string()), dialect, seen, axes);
    jumps = jumps || calls(block);
    if (!jumps && ends_program(block, dialect)) break;
  }
}

}  // namespace

AxisSet named_axes(const InputFile& file, const Dialect& dialect) {
  AxisSet axes;
  std::set<fs::path> seen;
  scan(file, dialect, seen, axes);
  return axes;
}

}  // namespace plumbline::nc
