#include "nc/sequence/program_ends.hpp"

#include <optional>

#include <fmt/format.h>

#include "base/diagnostic.hpp"
#include "nc/language/codes.hpp"
#include "nc/sequence/flow_block.hpp"

namespace plumbline::nc {
namespace {

[[noreturn]] void refuse_other(const LabelIndex& labels, const LinePlace& place) {
  refuse(codes::kFlowOpen, "a program of its own begins here, which nothing before it calls: it would stay as it is",
         "put it into a file of its own, and work on each of them", labels.shown(0, place));
}

[[noreturn]] void refuse_unreached(const LabelIndex& labels, const LinePlace& place) {
  refuse(codes::kFlowOpen,
         "this stands behind the end of the program (M2, M30, RTS), and nothing leads to it: it would stay as it is",
         "put another program into a file of its own; take out what is never executed", labels.shown(0, place));
}

// Of an archive the first program is read, and those that it calls.
void check_archive(LabelIndex& labels, const std::set<std::size_t>& begun) {
  check_first_of_archive(labels);
  for (const ProgramHead& head : labels.own_programs().heads) {
    if (head.is_main && !begun.contains(head.place.line)) refuse_other(labels, head.place);
  }
}

}  // namespace

std::string how_programs_end(const Dialect& dialect) {
  switch (dialect.syntax.statements) {
    case Statements::user_task:
      return "end it with RTS";
    case Statements::high_level:
      return "end it with M17 or RET";
    default:
      return "end it with M99";
  }
}

// What stands behind such a line would be passed over. Archives of high-level programs keep each as a file of its own,
// whose end is that of the program.
void refuse_unended(const Block& block, Statements statements) {
  if (statements == Statements::high_level) return;
  refuse_flow(
      block, codes::kFlowOpen, "this begins another program, and the one before it has not ended",
      statements == Statements::user_task  // OMIT and other words of an OSP look like names of programs
          ? "end that with M2 or M30 before this line; patterns of holes (LAA, BHC, OMIT) are not read"
          : "end that with M30 before this line; the number of a program stands at the begin of its first line");
}

void check_first_of_archive(LabelIndex& labels) {
  const ProgramHeads& programs = labels.own_programs();
  if (programs.words_before || programs.heads.size() < 2 || programs.heads.front().is_main) return;
  refuse(codes::kFlowOpen,
         "the first program of this archive is taken for the main one, and its name does not end with _MPF",
         "put the main program before its subprograms, and no more than one into a file",
         labels.shown(0, programs.heads.front().place));
}

void check_other_programs(LabelIndex& labels, const std::set<std::size_t>& begun, const Dialect& dialect, bool left_out,
                          bool returned) {
  if (dialect.syntax.statements == Statements::high_level) return check_archive(labels, begun);
  if (const std::optional<LinePlace> other = labels.other_main(begun)) refuse_other(labels, *other);
  if (dialect.syntax.statements != Statements::user_task) return;
  for (const ProgramHead& head : labels.own_programs().heads) {
    if (returned && !begun.contains(head.place.line)) refuse_other(labels, head.place);
  }
  if (const std::optional<LinePlace> line = labels.unreached(left_out)) refuse_unreached(labels, *line);
}

std::optional<ProgramsBehind> programs_behind(const InputFile& file, const Dialect& dialect) {
  if (dialect.syntax.statements != Statements::high_level) return std::nullopt;
  ProgramFiles files(file, dialect);
  LabelIndex labels(files, dialect);
  const ProgramHeads& programs = labels.own_programs();
  const std::size_t first = programs.words_before ? 0 : 1;
  if (programs.heads.size() <= first) return std::nullopt;
  ProgramsBehind behind;
  behind.begin = programs.heads[first].place.offset;
  for (std::size_t i = first; i < programs.heads.size() && !behind.main; ++i) {
    if (programs.heads[i].is_main) behind.main = labels.shown(0, programs.heads[i].place);
  }
  return behind;
}

bool returns_from_file(const Step& step) {
  return step.block->flow.word == FlowWord::give_back && !step.flow && step.block_delete != BlockDelete::left_out;
}

}  // namespace plumbline::nc
