// Where a program goes on: what reads lines asks here, whichever way the language has of jumping, repeating and
// calling.
#pragma once

#include <cstdint>
#include <string>
#include <utility>

#include "nc/control/step.hpp"
#include "nc/language/block.hpp"
#include "nc/syntax/line_source.hpp"

namespace plumbline::nc {

class Sequencer {
 public:
  Sequencer() = default;
  virtual ~Sequencer() = default;
  Sequencer(const Sequencer&) = delete;
  Sequencer& operator=(const Sequencer&) = delete;

  /// The next line to be read, of whichever file; false where the program ends.
  virtual bool next(Line& line) = 0;
  virtual const std::string& file() const = 0;
  /// True while lines are left out: all but those that begin with an O word.
  virtual bool skipping() const { return false; }
  /// True once something jumped, repeated or left out lines.
  bool used() const { return used_; }
  /// True inside a subprogram.
  virtual bool called() const = 0;
  /// Refuses with file-changed where a file that was read changed meanwhile.
  virtual void check_files() const = 0;
  /// True once the program ran into the next one of its file.
  virtual bool ended() const { return false; }

  /// Refuses where the program's file holds another one that nobody calls: it would not be read.
  virtual void check_others() {}

  /// % in a subprogram; refuses one that ends it.
  virtual void pass_percent(const Block& /*block*/) {}

  /// % ends the text here, though lines after it may be looked for; refuses where they are.
  virtual void end_of_text() {}

  /// A line that steers; false: it belongs to what is left out.
  virtual bool take(const Block& block) = 0;
  /// M98, G65.
  virtual void call_program(const Block& block, const ProgramCall& call) = 0;
  /// M99, M17; false: this is the main program, which ends here.
  virtual bool end_program(const Block& block, const ProgramCall& call) = 0;
  /// What the line just taken enters; names hold until the next line is taken.
  FlowEntry take_entry() { return std::exchange(entry_, {}); }
  /// How many blocks it has executed at least, where it says so itself: L10 P1000000.
  std::uint64_t take_announced() { return std::exchange(announced_, 0); }

 protected:
  FlowEntry entry_;
  bool used_ = false;
  std::uint64_t announced_ = 0;
};

}  // namespace plumbline::nc
