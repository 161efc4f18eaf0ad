#include <algorithm>

#include "base/diagnostic.hpp"
#include "nc/line_source.hpp"
#include "nc/parser.hpp"
#include "nc/program.hpp"

namespace plumbline::nc {
namespace {

bool ends_program(const Block& block, const Dialect& dialect) {
  if (block.block_delete) return false;
  return std::any_of(block.words.begin(), block.words.end(), [&](const Word& word) {
    if (word.letter != 'M' || word.expression != kLiteral) return false;
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

}  // namespace

AxisSet named_axes(const InputFile& file, const Dialect& dialect) {
  AxisSet axes;
  LineSource lines(file);
  Parser parser;
  Block block;
  Line line;
  while (axes != AxisSet::all() && lines.next(line)) {
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
    if (ends_program(block, dialect)) break;
  }
  return axes;
}

}  // namespace plumbline::nc
