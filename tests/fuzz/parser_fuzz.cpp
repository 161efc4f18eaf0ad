// Any bytes as lines of a program: every span that the parser hands over lies inside its line, in order, and
// expressions are closed.
#include <algorithm>

#include "fuzz/fuzz.hpp"
#include "nc/language/dialect.hpp"
#include "nc/sequence/program.hpp"
#include "nc/syntax/line_source.hpp"
#include "nc/syntax/parser.hpp"

using namespace plumbline;

namespace {

void check_span(const nc::Block& block, nc::Span span) {
  FUZZ_CHECK(span.begin <= span.end);
  FUZZ_CHECK(span.end <= block.text.size());
}

// The code of an expression begins inside the block's, and Operation::end closes it.
void check_code(const nc::Block& block, std::uint32_t code) {
  if (code == nc::kLiteral) return;
  FUZZ_CHECK(code < block.code.size());
  const auto begin = block.code.begin() + code;
  FUZZ_CHECK(
      std::any_of(begin, block.code.end(), [](const nc::Instruction& i) { return i.operation == nc::Operation::end; }));
}

void check_block(const nc::Block& block) {
  std::uint32_t at = 0;
  for (const nc::Word& word : block.words) {
    check_span(block, word.span);
    FUZZ_CHECK(word.span.begin >= at);
    FUZZ_CHECK(word.span.end > word.span.begin);
    at = word.span.end;
    FUZZ_CHECK((word.letter >= 'A' && word.letter <= 'Z') || word.letter == '@' || word.letter == '^' ||
               word.letter == '$');
    check_code(block, word.expression);
  }
  for (const nc::Comment& comment : block.comments) check_span(block, comment.span);
  for (const nc::Setting& setting : block.settings) {
    check_span(block, setting.span);
    check_code(block, setting.target);
    check_code(block, setting.value);
  }
  for (const nc::Instruction& instruction : block.code) {
    check_span(block, instruction.span);
    if (instruction.operation == nc::Operation::name || instruction.operation == nc::Operation::exists) {
      FUZZ_CHECK(instruction.name < block.names.size());
    }
  }
  for (const nc::Span name : block.names) check_span(block, name);
  check_span(block, block.number);
  check_span(block, block.slash);
  if (block.flow.word != nc::FlowWord::none) {
    check_span(block, block.flow.span);
    check_span(block, block.flow.name);
    check_code(block, block.flow.label);
    for (const std::uint32_t code : block.flow.values) check_code(block, code);
  }
}

std::size_t longest_line() {
  std::size_t longest = 0;
  for (const std::string_view name : nc::dialect_names()) longest = std::max(longest, nc::dialect(name).line_length);
  return longest;
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const InputFile file(fuzz::folder().file("parsed.ngc", fuzz::text_of(data, size)));
  nc::LineSource lines(file);
  nc::Parser parser(nc::dialect("linuxcnc"));
  nc::Block block;
  std::uint64_t bytes = 0;
  for (nc::Line line; lines.next(line);) {
    block.file = file.name();
    block.text = line.text;
    block.line_end = line.line_end;
    block.line = line.place.line;
    block.offset = line.place.offset;
    FUZZ_CHECK(line.place.offset == bytes);
    bytes += line.text.size() + line.line_end.size();
    if (!line.whole || line.text.size() > longest_line()) continue;  // refused before it is parsed
    if (fuzz::is_taken([&] { parser.parse(block); })) check_block(block);
  }
  FUZZ_CHECK(bytes == size);
  for (const std::string_view name : nc::dialect_names()) named_axes(file, nc::dialect(name));
  return 0;
}
