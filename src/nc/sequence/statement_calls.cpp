// Subprograms of controls with statements: where they are, and the way there and back.
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "nc/language/codes.hpp"
#include "nc/language/refusal.hpp"
#include "nc/sequence/statement_flow.hpp"
#include "nc/sequence/subprogram_file.hpp"
#include "nc/syntax/parser.hpp"

namespace plumbline::nc {
namespace {

constexpr std::size_t kProgramLevels = 10;

}  // namespace

// In the files that are open, else in one of its name beside the program.
std::optional<std::pair<std::size_t, LinePlace>> StatementFlow::find_program(const std::string& name) {
  for (int pass = 0; pass < 2; ++pass) {
    for (std::size_t i = 0; i < files_.size(); ++i) {
      index_programs(*files_[i]);
      for (const auto& [program, place] : files_[i]->programs) {
        if (program == name) return std::pair{i, place};
      }
    }
    const std::size_t open = files_.size();
    if (pass == 0) open_beside(name);
    if (files_.size() == open) continue;
    index_programs(*files_.back());
    if (files_.back()->programs.empty()) {
      files_.back()->programs.emplace_back(name, LinePlace{});
      return std::pair{open, LinePlace{}};
    }
  }
  return std::nullopt;
}

void StatementFlow::open_beside(const std::string& name) {
  const std::filesystem::path path = subprogram_file(files_.front()->file->name(), name, dialect_);
  if (path.empty()) return;
  auto opened = std::make_unique<InputFile>(path.string());
  const InputFile& file = *opened;
  files_.push_back(std::make_unique<File>(
      File{std::move(opened), &file, LineSource(file, dialect_.syntax.goes_on), false, {}, false, {}}));
}

// CALL OSUB, SUB(1,2): what the arguments are worth is found before the subprogram has variables of its own.
void StatementFlow::call(const Block& block) {
  Call call;
  call.name = canonical_program(block.at(block.flow.name));
  if (block.flow.count != kLiteral) call.remaining = number_of(block, block.flow.count, "the count of calls") - 1;
  if (call.remaining < 0 && dialect_.syntax.statements == Statements::user_task) {
    refuse_at(block, block.flow.span, codes::kNotInterpreted,
              "whether a CALL with Q0 calls once or not at all was found in no source",
              "write Q1 or more, or leave the call out");
  }
  for (const std::uint32_t code : block.flow.values) {
    call.arguments.push_back({interpreter_.value_of(block, code, block.flow.span), true});
  }
  std::vector<Value> named;
  for (const Setting& setting : block.settings) named.push_back(interpreter_.value(block, setting.value));
  if (call.remaining < 0 && dialect_.syntax.statements == Statements::high_level) {
    refuse_at(block, block.flow.span, codes::kOutOfRange, "P asks for no call at all", "write P1 or more");
  }
  if (call.remaining < 0) return;
  enter(block, std::move(call), true);
  for (std::size_t i = 0; i < named.size(); ++i) interpreter_.set_variable(block, i, named[i]);
}

// M98, G65
void StatementFlow::call_program(const Block& block, const ProgramCall& program) {
  if (program.count <= 0) return;
  Call call;
  call.name = std::to_string(program.number);
  call.remaining = program.count - 1;
  enter(block, std::move(call), program.macro);
  if (program.macro) interpreter_.set_macro_arguments();
}

void StatementFlow::enter(const Block& block, Call call, bool own_variables) {
  used_ = true;
  if (calls_.size() >= kProgramLevels) {
    refuse_statement(block, codes::kCallDepth,
                     fmt::format("subprograms call each other more than {} deep", kProgramLevels),
                     "the control takes no more; does a subprogram call itself without an end?");
  }
  const LinePlace back = files_[file_]->lines.place();
  const auto found = find_program(call.name);
  if (!found) {
    refuse_statement(block, codes::kFlowOpen,
                     fmt::format("subprogram {} is neither in this file nor beside it", call.name),
                     fmt::format("put it into a file of its name beside the program, as {}",
                                 subprogram_file_name(call.name, dialect_)));
  }
  call.file = file_;
  call.place = back;
  call.own_file = found->first;
  call.entry = found->second;
  interpreter_.enter_subprogram(own_variables ? dialect_.syntax.local_variables : -1);
  call.line = block.line;
  calls_.push_back(std::move(call));
  file_ = found->first;
  files_[file_]->lines.seek(found->second);
  begun_ = false;
  note_call();
}

void StatementFlow::note_call() {
  const Call& call = calls_.back();
  entry_ = {FlowEntry::Kind::call, call.name, {}, call.line, call.pass};
  if (file_ != 0) entry_.file = file();
}

void StatementFlow::note_pass(Loop& loop) {
  ++loop.pass;
  entry_ = {FlowEntry::Kind::pass, {}, {}, loop.begin.line, loop.pass};
}

bool StatementFlow::end_program(const Block& block, const ProgramCall& program) {
  if (called()) {
    leave(block);
  } else if (!program.return_to) {
    return false;  // M99 in the main program: one pass
  }
  if (program.return_to) jump_back(block, *program.return_to);
  return true;
}

// M99 P100: the caller goes on at N100.
void StatementFlow::jump_back(const Block& block, int number) {
  const std::size_t line = files_[file_]->lines.place().line;
  const LinePlace* const place = find_label(fmt::format("N{}", number), line, Direction::both);
  if (place == nullptr) {
    refuse_statement(block, codes::kFlowLabel,
                     fmt::format("there is no N{} to return to in the program that called", number),
                     "check the P of M99");
  }
  used_ = true;
  files_[file_]->lines.seek(*place);
}

void StatementFlow::leave(const Block& block) {
  while (!sections_.empty() && sections_.back().level == calls_.size()) sections_.pop_back();
  Call& call = calls_.back();
  if (call.remaining > 0) {
    --call.remaining;
    ++call.pass;
    call.loops.clear();
    file_ = call.own_file;
    files_[file_]->lines.seek(call.entry);
    begun_ = false;
    note_call();
    return;
  }
  interpreter_.leave_subprogram(block);
  file_ = call.file;
  files_[file_]->lines.seek(call.place);
  calls_.pop_back();
  begun_ = true;
}

}  // namespace plumbline::nc
