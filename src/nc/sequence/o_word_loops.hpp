// Loops and branches of O words. What is left out ends at the next O word with the same label, whatever it says
// [LinuxCNC, measured]; this is how BREAK and CONTINUE find the end of their loop.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>

#include "base/diagnostic.hpp"
#include "nc/control/interpreter.hpp"
#include "nc/control/step.hpp"
#include "nc/language/block.hpp"
#include "nc/sequence/program_files.hpp"

namespace plumbline::nc {

/// Lines that are left out, up to an O word of this label.
struct LeftOut {
  enum class Until : std::uint8_t {
    any_word,    // of the label: a loop or a branch
    end_sub,     // the definition of a subprogram that is passed over
    subprogram,  // one that was called is looked for
  };
  Until until = Until::any_word;
  std::string label;
  std::string what;  // is looked for, as a message calls it
  Place from;        // the block that asked for it

  bool ends_at(FlowWord word, const std::string& label_of_word) const;
};

class OWordLoops {
 public:
  /// Both must outlive it.
  OWordLoops(ProgramFiles& files, Interpreter& interpreter) : files_(files), interpreter_(interpreter) {}

  /// Executes a word of a loop or branch of that label, which is unique in its subprogram; gives the pass that begins
  /// there, if any. `left_out` may end there, or begin. Refuses with nc-flow-label words that do not belong together.
  FlowEntry steer(const Block& block, const std::string& label, std::optional<LeftOut>& left_out);

 private:
  struct Begin {  // where a loop or branch was met
    FlowWord word = FlowWord::none;
    FilePlace place;
    std::optional<int> remaining;  // passes of a REPEAT that goes on
    std::uint64_t pass = 0;        // that is being executed
    std::uint64_t next_pass = 1;   // that begins when reading comes to it
  };
  // What BREAK and CONTINUE ask of ends of loops: that of a DO forgets BREAK alone, that of another loop CONTINUE
  // alone [LinuxCNC, measured].
  enum class Leaving : std::uint8_t { nothing, by_break, by_continue, by_both };

  Begin& begin(const Block& block, const std::string& label);
  Begin& need(const Block& block, const std::string& label, FlowWord a, FlowWord b);
  FlowEntry repeat(const Block& block, const std::string& label, std::optional<LeftOut>& left_out);
  FlowEntry begin_while(const Block& block, const std::string& label, std::optional<LeftOut>& left_out);
  void end_do(const Block& block, Begin& loop);
  void end_loop(const Block& block, const std::string& label, std::optional<LeftOut>& left_out);
  void leave(const Block& block, const std::string& label, std::optional<LeftOut>& left_out);
  void evaluate_passed_over(const Block& block);
  void branch(const Block& block, const std::string& label, std::optional<LeftOut>& left_out);
  void go_back(Begin& loop);

  ProgramFiles& files_;
  Interpreter& interpreter_;
  std::unordered_map<std::string, Begin> begins_;
  Leaving leaving_ = Leaving::nothing;
  bool branch_is_executed_ = false;  // some branch of the IF met last
};

}  // namespace plumbline::nc
