#include "nc/program.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "base/diagnostic.hpp"
#include "nc/codes.hpp"
#include "nc/interpreter.hpp"
#include "nc/line_source.hpp"
#include "nc/parser.hpp"

namespace plumbline::nc {
namespace {

bool is_blank(std::string_view text) { return text.find_first_not_of(" \t\r") == std::string_view::npos; }

void place_block(Block& block, const Line& line, std::string_view file) {
  block.file = file;
  block.text = line.text;
  block.line_end = line.line_end;
  block.line = line.place.line;
  block.offset = line.place.offset;
}

void check_length(const Block& block, const Line& line, const Dialect& dialect) {
  const std::size_t length = block.text.size() + (block.line_end.size() > 1 ? 1 : 0);  // a CR counts
  if (line.whole && length <= dialect.line_length) return;
  Place place;
  place.file = block.file;
  place.line = block.line;
  place.column = dialect.line_length + 1;
  place.text = block.text.substr(0, 2 * dialect.line_length);
  refuse(codes::kLineTooLong,
         fmt::format("the line is longer than the {} characters that the control reads", dialect.line_length),
         "break it into several blocks, or shorten its comment", std::move(place));
}

}  // namespace

struct Program::Parts {
  Parts(const InputFile& file_, const Dialect& dialect_, ProgramSettings settings_)
      : file(file_), dialect(dialect_), settings(std::move(settings_)), lines(file), interpreter(dialect, settings) {}

  const InputFile& file;
  const Dialect& dialect;
  const ProgramSettings settings;
  LineSource lines;
  Parser parser;
  Interpreter interpreter;
  Block block;
  bool begun = false;        // a line that is not blank was read
  bool in_percents = false;  // the program began with %
  bool behind_end = false;   // M2, M30 or the second % was executed

  const Step* next();
  const Step* ignore();
  const Step* percent();
};

const Step* Program::Parts::next() {
  Line line;
  if (!lines.next(line)) return nullptr;
  place_block(block, line, file.name());
  if (behind_end) return ignore();
  check_length(block, line, dialect);
  parser.parse(block);
  if (block.kind == LineKind::percent) return percent();
  begun = begun || !is_blank(block.text);
  const Step& step = interpreter.execute(block);
  behind_end = interpreter.ended();
  return &step;
}

const Step* Program::Parts::ignore() {
  block.kind = LineKind::ignored;
  block.block_delete = false;
  block.number = block.slash = Span{};
  block.words.clear();
  block.comments.clear();
  block.settings.clear();
  return &interpreter.pass(block);
}

// The first line that is not blank may be %; then the program ends at the next one [RS274/NGC 3.2].
const Step* Program::Parts::percent() {
  if (begun && !in_percents) {
    const auto at = static_cast<std::uint32_t>(block.text.find('%'));
    refuse_at(block, {at, at + 1}, codes::kBadCharacter, "% ends a program that did not begin with %",
              "put % on the first line as well, or end with M2");
  }
  behind_end = begun;
  begun = in_percents = true;
  return &interpreter.pass(block);
}

Program::Program(const InputFile& file, const Dialect& dialect, ProgramSettings settings)
    : parts_(std::make_unique<Parts>(file, dialect, std::move(settings))) {}

Program::~Program() = default;

const Step* Program::next() { return parts_->next(); }

}  // namespace plumbline::nc
