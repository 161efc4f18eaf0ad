// Where a program goes on: O words, M98 and M99 make it jump, repeat and leave out lines. Subprograms are found in the
// program, or in a file of their name beside it.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <unordered_map>

#include "base/files/files.hpp"
#include "nc/control/interpreter.hpp"
#include "nc/language/block.hpp"
#include "nc/language/dialect.hpp"
#include "nc/sequence/call_stack.hpp"
#include "nc/sequence/o_word_loops.hpp"
#include "nc/sequence/program_files.hpp"
#include "nc/sequence/sequencer.hpp"

namespace plumbline::nc {

class OWordFlow : public Sequencer {
 public:
  /// All must outlive it.
  OWordFlow(const InputFile& program, const Dialect& dialect, Interpreter& interpreter);

  /// The next line to be read, of whichever file; false where the program ends. Refuses when something that was looked
  /// for, or that must end, did not appear before the end of its file.
  bool next(Line& line) override;
  void end_of_text() override;
  const std::string& file() const override { return files_.name(); }
  bool skipping() const override { return left_out_.has_value(); }
  bool called() const override { return !calls_.empty(); }
  void check_files() const override { files_.check_unchanged(); }

  /// An O word; false: it belongs to what is left out.
  bool take(const Block& block) override;
  /// M98 P L.
  void call_program(const Block& block, const ProgramCall& call) override;
  /// M99; false: this is the main program, which ends here.
  bool end_program(const Block& block, const ProgramCall& call) override;

 private:
  static constexpr std::size_t kCallLevels = 9;  // [LinuxCNC, measured]

  std::string scoped(const std::string& label) const;
  bool leaves_out(LeftOut::Until until) const { return left_out_ && left_out_->until == until; }
  void check_not_nested(const Block& block);
  void define(const Block& block, const std::string& label);
  void enter(const Block& block, Call call, const std::string& file);
  void go_to_subprogram(const Block& block, const std::string& name, const std::string& file);
  void give_back(const Block& block);
  void keep_value(bool given, Value value);
  void keep_value_passed_over(const Block& block);
  void leave(const Block& block);

  Interpreter& interpreter_;
  ProgramFiles files_;
  CallStack calls_{kCallLevels};
  OWordLoops loops_;
  std::unordered_map<std::string, FilePlace> subprograms_;  // that were met
  std::optional<LeftOut> left_out_;
};

}  // namespace plumbline::nc
