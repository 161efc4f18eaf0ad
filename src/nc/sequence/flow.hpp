// Where a program goes on: O words, M98 and M99 make it jump, repeat and leave out lines. Subprograms are found in the
// program, or in a file of their name beside it.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "base/diagnostic.hpp"
#include "base/files.hpp"
#include "nc/control/interpreter.hpp"
#include "nc/language/block.hpp"
#include "nc/language/dialect.hpp"
#include "nc/sequence/sequencer.hpp"
#include "nc/syntax/line_source.hpp"

namespace plumbline::nc {

class FlowControl : public Sequencer {
 public:
  /// All must outlive it.
  FlowControl(const InputFile& program, const Dialect& dialect, Interpreter& interpreter);

  /// The next line to be read, of whichever file; false where the program ends. Refuses when something that was looked
  /// for, or that must end, did not appear before the end of its file.
  bool next(Line& line) override;
  void end_of_text() override;
  const std::string& file() const override { return files_[file_]->file->name(); }

  /// True while lines are left out: all but the O words.
  bool skipping() const override { return !skip_.empty(); }
  /// True once something jumped, repeated or left out lines.
  bool used() const override { return used_; }
  /// True inside a subprogram.
  bool called() const override { return !calls_.empty(); }
  void check_files() const override {
    for (const auto& one : files_) one->file->check_unchanged();
  }

  /// An O word; false: it belongs to what is left out.
  bool take(const Block& block) override;
  /// M98 P L.
  void call_program(const Block& block, const ProgramCall& call) override;
  /// M99; false: this is the main program, which ends here.
  bool end_program(const Block& block, const ProgramCall& call) override;

 private:
  struct File {
    std::unique_ptr<InputFile> opened;  // null for the program itself
    const InputFile* file;
    LineSource lines;
  };
  struct Target {  // where a label was met
    FlowWord word = FlowWord::none;
    std::size_t file = 0;
    LinePlace place;
    int remaining = -1;      // passes of a repeat; -1: not begun
    std::uint64_t pass = 0;  // of the loop that is being executed
  };
  struct Call {
    std::string name;
    std::size_t file = 0;  // where it goes on afterwards
    LinePlace place;
    bool by_number = false;  // M98
    int remaining = 0;       // further calls of the same block
    std::size_t line = 0;    // of the call
    std::uint64_t pass = 1;
  };

  std::string label_of(const Block& block);
  std::string label_of_skipped(const Block& block);
  std::string scoped(const std::string& label) const;
  Target& begin_loop(const Block& block, const std::string& label);
  const Target& need_target(const Block& block, const std::string& label, FlowWord a, FlowWord b) const;
  void skip_to(const Block& block, std::string label, std::string_view what);
  void go_to(const Target& target);
  bool define(const Block& block, const std::string& label);
  void enter(const Block& block, Call call);
  void go_to_subprogram(const Block& block, const std::string& name);
  void give_back(const Block& block);
  void leave(const Block& block);
  void steer(const Block& block, const std::string& label);
  void branch(const Block& block, const std::string& label);
  void end_loop(const Block& block, const std::string& label);
  bool condition(const Block& block);
  void note_call();
  void note_pass(Target& loop);
  static LinePlace place_of_line(const Block& block) { return {block.offset, block.line}; }

  const Dialect& dialect_;
  Interpreter& interpreter_;
  std::vector<std::unique_ptr<File>> files_;
  std::size_t file_ = 0;
  std::unordered_map<std::string, Target> targets_;
  std::vector<Call> calls_;
  std::string skip_;  // the label that ends the leaving out
  Place skip_from_;
  std::string skip_what_;
  bool seeks_subprogram_ = false;
  std::string defining_;  // the subprogram whose definition is passed over
  bool executed_branch_ = false;
  bool breaking_ = false;
  bool continuing_ = false;
  bool used_ = false;
  bool jumps_back_ = false;  // to the begin of a loop
};

}  // namespace plumbline::nc
