// Programs that jump to labels, with loops and calls by statements: macro B, user task, high-level language.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "base/diagnostic.hpp"
#include "base/files.hpp"
#include "nc/control/interpreter.hpp"
#include "nc/language/dialect.hpp"
#include "nc/sequence/sequencer.hpp"
#include "nc/syntax/line_head.hpp"

namespace plumbline::nc {

/// Refuses with the code, at the statement of the block, or at its first word if it has none.
[[noreturn]] void refuse_statement(const Block& block, std::string_view code, std::string message, std::string help);

class StatementFlow : public Sequencer {
 public:
  /// All must outlive it.
  StatementFlow(const InputFile& program, const Dialect& dialect, Interpreter& interpreter);

  bool next(Line& line) override;
  const std::string& file() const override { return files_[file_]->file->name(); }
  bool used() const override { return used_; }
  bool called() const override { return !calls_.empty(); }
  void check_files() const override {
    for (const auto& one : files_) one->file->check_unchanged();
  }
  bool ended() const override { return ended_; }
  bool take(const Block& block) override;
  void call_program(const Block& block, const ProgramCall& program) override;
  bool end_program(const Block& block, const ProgramCall& program) override;

 private:
  struct File {
    std::unique_ptr<InputFile> opened;  // null for the program itself
    const InputFile* file;
    LineSource lines;
    bool has_index = false;
    std::vector<std::pair<std::string, LinePlace>> programs;
    bool has_labels = false;
    std::unordered_map<std::string, std::vector<LinePlace>> labels;
  };
  struct Loop {
    FlowWord word = FlowWord::none;
    int number = 0;     // of DO
    LinePlace begin;    // of the line that begins it
    LinePlace content;  // of the line behind
    std::uint64_t pass = 1;
  };
  struct Skip {  // of the lines up to the end of a loop or branch
    FlowWord opens, closes;
    bool stops_at_else = false;
    int number = 0;
    Place from;
  };
  struct Call {
    std::string name;
    std::size_t file = 0;  // where it goes on afterwards
    LinePlace place;
    std::size_t own_file = 0;
    LinePlace entry;
    int remaining = 0;       // further calls of the same block
    std::size_t line = 0;    // of the call
    std::uint64_t pass = 1;  // of the calls of the same block
    std::vector<Loop> loops;
    std::vector<Value> arguments;  // by position, for its head
  };

  struct Section {  // a part of a program that is repeated
    LinePlace begin, back;
    std::size_t end = 0;  // the first line behind it
    int remaining = 0;
    std::size_t level = 0;  // of calls
    std::size_t from = 0;   // the line that repeats it
    std::uint64_t pass = 1;
  };

  void choose(const Block& block);
  void repeat(const Block& block);
  void go_through_section();
  bool leaves_section(const Line& line);
  void check_jump_in_section(const Block& block, const LinePlace& to) const;
  void note_call();
  void note_pass(Loop& loop);
  void head(const Block& block);
  void jump(const Block& block, const std::string& label, Direction direction);
  const LinePlace* find_label(const std::string& label, std::size_t line, Direction direction);
  void index_programs(File& file) const;
  void index_labels(File& file) const;
  void begin_loop(const Block& block);
  void end_loop(const Block& block);
  void steer_for(const Block& block);
  Loop& loop_of(const Block& block, FlowWord word, int number);
  void leave_out(const Block& block, FlowWord opens, FlowWord closes, bool stops_at_else, int number);
  void skip(const Skip& skip);
  void call(const Block& block);
  void enter(const Block& block, Call call, bool own_variables);
  std::optional<std::pair<std::size_t, LinePlace>> find_program(const std::string& name);
  void open_beside(const std::string& name);
  void leave(const Block& block);
  void jump_back(const Block& block, int number);
  bool condition(const Block& block);
  int number_of(const Block& block, std::uint32_t code, std::string_view what);
  std::vector<Loop>& loops() { return calls_.empty() ? main_loops_ : calls_.back().loops; }

  const Dialect& dialect_;
  Interpreter& interpreter_;
  std::vector<std::unique_ptr<File>> files_;
  std::size_t file_ = 0;
  std::vector<Call> calls_;
  std::vector<Loop> main_loops_;
  std::optional<Skip> skip_;
  std::vector<Section> sections_;
  bool begun_ = false;  // words were read since the program or subprogram began
  bool again_ = false;  // FOR is reached from its end
  bool used_ = false;
  bool ended_ = false;
};

}  // namespace plumbline::nc
