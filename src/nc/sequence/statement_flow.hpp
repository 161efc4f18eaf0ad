// Programs that jump to labels, with loops and calls by statements: macro B, user task, high-level language.
#pragma once

#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>

#include "base/files/files.hpp"
#include "nc/control/interpreter.hpp"
#include "nc/language/dialect.hpp"
#include "nc/sequence/call_stack.hpp"
#include "nc/sequence/definitions.hpp"
#include "nc/sequence/label_index.hpp"
#include "nc/sequence/program_files.hpp"
#include "nc/sequence/sections/repeated_sections.hpp"
#include "nc/sequence/sequencer.hpp"
#include "nc/sequence/statement_loops.hpp"
#include "nc/sequence/ways_back.hpp"

namespace plumbline::nc {

class StatementFlow : public Sequencer {
 public:
  /// All must outlive it.
  StatementFlow(const InputFile& program, const Dialect& dialect, Interpreter& interpreter);

  bool next(Line& line) override;
  const std::string& file() const override { return files_.name(); }
  bool called() const override { return !calls_.empty(); }
  void check_files() const override { files_.check_unchanged(); }
  void check_others() override;
  void pass_percent(const Block& block) override;
  bool ended() const override { return reading_ == Reading::after_end; }
  bool take(const Block& block) override;
  void call_program(const Block& block, const ProgramCall& program) override;
  bool end_program(const Block& block, const ProgramCall& program) override;

 private:
  static constexpr std::size_t kProgramLevels = 10;
  /// What is read of the program, or of the subprogram on top.
  enum class Reading : std::uint8_t { head, body, after_end };

  void steer(const Block& block);
  void choose(const Block& block);
  void repeat(const Block& block);
  RepeatedSection section_of(const Block& block);
  void go_on(const RepeatedSections::GoesOn& there);
  void head(const Block& block);
  void jump(const Block& block, std::string_view written, Direction direction);
  void call(const Block& block);
  void enter(const Block& block, Call call, bool own_variables);
  void begin_call();
  void leave(const Block& block);
  void jump_back(const Block& block, int number, std::size_t from);

  const Dialect& dialect_;
  Interpreter& interpreter_;
  ProgramFiles files_;
  CallStack calls_{kProgramLevels};
  LabelIndex labels_;
  StatementLoops loops_;
  WaysBack ways_;
  RepeatedSections sections_;
  std::set<std::size_t> begun_;  // the lines of the program's file in which it and its subprograms begin
  bool returned_ = false;        // the program itself, by what ends subprograms
  Reading reading_ = Reading::head;
  Definitions definitions_;
};

}  // namespace plumbline::nc
