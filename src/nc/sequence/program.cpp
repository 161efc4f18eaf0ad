#include "nc/sequence/program.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include <fmt/format.h>

#include "base/diagnostic.hpp"
#include "base/text/characters.hpp"
#include "nc/control/interpreter.hpp"
#include "nc/language/codes.hpp"
#include "nc/language/guard_lines.hpp"
#include "nc/language/refusal.hpp"
#include "nc/sequence/o_word_flow.hpp"
#include "nc/sequence/statement_flow.hpp"
#include "nc/syntax/parser.hpp"

namespace plumbline::nc {
namespace {

bool holds_nothing(std::string_view text) { return text.find_first_not_of(" \t\r") == std::string_view::npos; }

void place_block(Block& block, const Line& line, std::string_view file) {
  block.file = file;
  block.text = line.text;
  block.line_end = line.line_end;
  block.line = line.place.line;
  block.offset = line.place.offset;
}

// LF CR CR is how Fanuc's controls end a line [B-63524EN/01, parameter 0100, NCR].
void check_line_ends(const Block& block) {
  const std::size_t of_last_line = std::min(block.text.find_first_not_of('\r'), block.text.size());
  const std::size_t at = lone_carriage_return(block.text.substr(of_last_line));
  if (at == std::string_view::npos) return;
  const auto begin = static_cast<std::uint32_t>(of_last_line + at);
  refuse_at(block, {begin, begin + 1}, codes::kBadCharacter, std::string(kLoneCarriageReturn),
            std::string(kOtherLineEnds));
}

// rs274 stops at its first byte, "Bad character '\357' used"; of the other controls no source says that they pass over
// it.
void check_byte_order_mark(const Block& block) {
  if (byte_order_mark_size(block) == 0) return;
  refuse_at(block, {0, static_cast<std::uint32_t>(byte_order_mark_size(block))}, codes::kBadCharacter,
            "the file begins with a byte order mark, at which the control may stop",
            "save it as UTF-8 without a byte order mark (BOM), or as ASCII");
}

void check_length(const Block& block, const Line& line, const Dialect& dialect) {
  const std::size_t length = longest_line(block.text) + (block.line_end.size() > 1 ? 1 : 0);  // a CR counts
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

// After "/" and N, as the lines that are left out are looked through for O words.
bool begins_with_flow(std::string_view text) {
  std::size_t at = text.find_first_not_of(" \t\r/");
  if (at != std::string_view::npos && (text[at] == 'N' || text[at] == 'n')) {
    at = text.find_first_not_of(" \t\r0123456789", at + 1);
  }
  return at != std::string_view::npos && (text[at] == 'O' || text[at] == 'o');
}

bool ends_text(std::string_view text) {
  const std::size_t at = text.find_first_not_of(" \t\r");
  return at != std::string_view::npos && text[at] == '%' && holds_nothing(text.substr(at + 1));
}

std::unique_ptr<Sequencer> sequencer_of(const Dialect& dialect, const InputFile& file, Interpreter& interpreter) {
  if (dialect.syntax.statements == Statements::o_words) return std::make_unique<OWordFlow>(file, dialect, interpreter);
  return std::make_unique<StatementFlow>(file, dialect, interpreter);
}

}  // namespace

struct Program::Parts {
  Parts(const InputFile& file_, const Dialect& dialect_, ProgramSettings settings_)
      : file(file_),
        dialect(dialect_),
        settings(std::move(settings_)),
        parser(dialect),
        interpreter(dialect, settings),
        sequencer(sequencer_of(dialect, file, interpreter)),
        flow(*sequencer) {}

  const InputFile& file;
  const Dialect& dialect;
  const ProgramSettings settings;
  Parser parser;
  Interpreter interpreter;
  const std::unique_ptr<Sequencer> sequencer;
  Sequencer& flow;
  std::unique_ptr<Block> block = std::make_unique<Block>();
  enum class Stage : std::uint8_t {
    blank,        // no line was read but blank ones
    text,         // without a % before it
    opened,       // by %, and nothing stands behind it yet
    in_percents,  // the program began with %
    ended,        // M2, M30 or the second % was executed
  } stage = Stage::blank;
  bool drawn = false;          // before all else: the shape of the workpiece
  bool ends_doubtful = false;  // by a % that may be the first one: whether the control reads on there, nobody says
  bool jumped = false;         // before the block of the last step
  bool words_behind = false;   // its end
  bool in_guard = false;       // of a compensated program
  Place guard_line;            // the last one of it

  std::uint64_t executed = 0;

  const Step* next();
  const Step* execute();
  const Step* steer();
  void note_handed(Step& step);
  void count(std::uint64_t blocks);
  void check_count(std::uint64_t blocks) const;
  void count_moves(const Step& step);
  const Step* ignore();
  const Step* end_of_file();
  const Step* pass_guard();
  [[noreturn]] void refuse_guard(std::string_view what) const;
  void refuse_text_behind() const;
  const Step* percent();
};

const Step* Program::Parts::next() {
  Line line;
  while (true) {
    if (stage == Stage::ended && flow.used()) return nullptr;
    if (!flow.next(line)) {
      if (in_guard) refuse_guard("the program ends inside its guard");
      return stage != Stage::ended && flow.used() ? end_of_file() : nullptr;
    }
    place_block(*block, line, flow.file());
    check_line_ends(*block);
    check_byte_order_mark(*block);
    if (stage == Stage::ended) {
      words_behind = words_behind || block->text.find_first_not_of(" \t\r%") != std::string_view::npos;
      if (ends_doubtful) refuse_text_behind();
      return ignore();
    }
    if (in_guard || (is_guard_line(block->text, kGuardBegins, dialect) && !flow.skipping())) return pass_guard();
    if (flow.skipping() && stage == Stage::in_percents && ends_text(line.text)) flow.end_of_text();
    if (flow.skipping() && !begins_with_flow(line.text)) continue;
    check_length(*block, line, dialect);
    parser.parse(*block);
    const bool around_file = flow.called() && !dialect.syntax.percent_pairs;
    if (block->kind == LineKind::percent && around_file) {
      flow.pass_percent(*block);
      continue;
    }
    if (block->kind == LineKind::percent) return percent();
    if (block->kind == LineKind::ignored) {
      drawn |= stage == Stage::blank;
      return &interpreter.pass(*block);
    }
    if (!holds_nothing(block->text)) {
      if (stage == Stage::blank) stage = Stage::text;
      if (stage == Stage::opened) stage = Stage::in_percents;
    }
    if (flow.used()) count(1);
    if (block->flow.word == FlowWord::none) return execute();
    if (const Step* const step = steer()) return step;
  }
}

const Step* Program::Parts::execute() {
  interpreter.execute(*block);
  Step& step = interpreter.step();
  count_moves(step);
  jumped = flow.used();
  const ProgramCall& call = interpreter.program_call();
  if (interpreter.ended() && flow.called() && dialect.behaviour.end_returns) {
    interpreter.go_on();
    step.flow.emplace();
    flow.end_program(*block, call);
    return &step;
  }
  if (interpreter.ended()) stage = Stage::ended;
  const bool steers = call.calls() || (call.ends() && (call.return_to || flow.called()));
  if (call.calls()) flow.call_program(*block, call);
  check_count(executed + flow.take_announced());
  if (call.ends() && !flow.end_program(*block, call)) {
    interpreter.check_begins_again(*block);
    stage = Stage::ended;
  }
  note_handed(step);
  const FlowEntry entry = flow.take_entry();
  if (steers) step.flow = entry;
  return &step;
}

// Null: the O word is part of what is skipped.
const Step* Program::Parts::steer() {
  interpreter.pass(*block);
  if (block->block_delete && interpreter.deleted(*block)) {
    if (flow.skipping()) return nullptr;
    Step& left_out = interpreter.step();
    left_out.block_delete = BlockDelete::left_out;
    jumped = flow.used();
    return &left_out;
  }
  if (!flow.take(*block)) return nullptr;
  check_count(executed + flow.take_announced());
  if (interpreter.ended() || flow.ended()) stage = Stage::ended;
  Step& step = interpreter.step();
  jumped = flow.used();
  const bool heads = block->flow.word == FlowWord::program || (block->flow.word == FlowWord::sub && !flow.called());
  const bool declares = heads || block->flow.word == FlowWord::define;
  const FlowEntry entry = flow.take_entry();
  const bool returns = block->flow.word == FlowWord::give_back && stage == Stage::ended;  // to who calls this file
  if ((!declares || jumped) && !returns) step.flow = entry;
  note_handed(step);
  return &step;
}

void Program::Parts::note_handed(Step& step) {
  if (stage == Stage::ended) step.handed = &interpreter.control().handed;
}

// What a few letters spell: the moves of repeated cycles, the turns of arcs.
void Program::Parts::count_moves(const Step& step) {
  if (!step.holes.empty()) count(step.motions.size() - 1);
  for (const Motion& motion : step.motions) {
    const int turns = std::abs(motion.arc.turns);
    if (turns > 1) count(static_cast<std::uint64_t>(turns - 1));
  }
}

void Program::Parts::count(std::uint64_t blocks) {
  executed += blocks;
  check_count(executed);
}

void Program::Parts::check_count(std::uint64_t blocks) const {
  if (blocks <= settings.max_blocks) return;
  const Span whole{0, static_cast<std::uint32_t>(block->text.size())};
  refuse_at(*block, whole, codes::kTooManyBlocks,
            fmt::format("the program executes more than {} blocks", settings.max_blocks),
            "look for a loop that does not end, or allow more with --max-blocks");
}

const Step* Program::Parts::ignore() {
  block->clear();
  block->kind = LineKind::ignored;
  return &interpreter.pass(*block);
}

// A program that steers itself and has no end leaves its variables here.
const Step* Program::Parts::end_of_file() {
  stage = Stage::ended;
  Line line;
  line.place = {file.size(), 0};
  place_block(*block, line, flow.file());
  const Step* const step = ignore();
  note_handed(interpreter.step());
  return step;
}

// It stops the control or does nothing: nothing that follows depends on what it reads.
const Step* Program::Parts::pass_guard() {
  guard_line = {};
  guard_line.file = block->file;
  guard_line.line = block->line;
  guard_line.column = 1;
  guard_line.length = block->text.size();
  guard_line.text = block->text;
  const bool ends = is_guard_line(block->text, kGuardEnds, dialect);
  if (in_guard && !ends && !is_part_of_guard(block->text, dialect)) {
    refuse_guard("this line is none of a guard, and stands in one");
  }
  in_guard = !ends;
  return ignore();
}

void Program::Parts::refuse_guard(std::string_view what) const {
  refuse(codes::kGuard, std::string(what), "a guard is read as a whole: compensate the original program again",
         guard_line);
}

// Controls with statements take % for the begin of the file as well as for its end, and what stands after that is none
// of theirs. RS274/NGC: the first line that is not blank may be %; then the program ends at the next one
// [RS274/NGC 3.2].
const Step* Program::Parts::percent() {
  if (stage == Stage::text && dialect.syntax.percent_pairs) {
    const auto at = static_cast<std::uint32_t>(block->text.find('%'));
    refuse_at(*block, {at, at + 1}, codes::kBadCharacter, "% ends a program that did not begin with %",
              "put % on the first line as well, or end with M2");
  }
  if (drawn && stage == Stage::blank) {
    refuse_at(*block, {0, static_cast<std::uint32_t>(block->text.size())}, codes::kBadCharacter,
              "the head of the program stands behind lines of it", "put DEF WORK to END behind this line");
  }
  ends_doubtful = !dialect.syntax.percent_pairs && (stage == Stage::text || stage == Stage::opened);
  stage = stage == Stage::blank ? Stage::opened : Stage::ended;
  interpreter.pass(*block);
  note_handed(interpreter.step());
  return &interpreter.step();
}

// What stands before the first % is none of the program; but where it holds words, the % may be the end as well.
void Program::Parts::refuse_text_behind() const {
  const std::size_t at = block->text.find_first_not_of(" \t\r%");
  if (at == std::string_view::npos) return;
  refuse_at(*block, {static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(block->text.size())},
            codes::kBadCharacter, "text stands behind a % that something stands before: either may be the program",
            "begin the program with %, or take out what is none of it");
}

Program::Program(const InputFile& file, const Dialect& dialect, ProgramSettings settings)
    : parts_(std::make_unique<Parts>(file, dialect, std::move(settings))) {}

Program::~Program() = default;

const Step* Program::next() {
  const Step* const step = parts_->next();
  if (step == nullptr) {
    parts_->flow.check_files();
    if (parts_->words_behind || parts_->flow.used()) parts_->flow.check_others();
  }
  return step;
}

std::unique_ptr<Block> Program::exchange_block(std::unique_ptr<Block> instead) {
  return std::exchange(parts_->block, std::move(instead));
}

bool Program::jumped() const { return parts_->jumped; }

bool Program::position_read() const { return parts_->interpreter.position_read(); }

}  // namespace plumbline::nc
