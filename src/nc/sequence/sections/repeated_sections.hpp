// Parts of a program that are repeated by their labels (REPEAT, REPEATB) [A 1.13, 1.14].
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "nc/control/step.hpp"
#include "nc/language/block.hpp"
#include "nc/syntax/line_source.hpp"

namespace plumbline::nc {

inline constexpr std::size_t kEndOfFile = static_cast<std::size_t>(-1);  // behind each line

struct RepeatedSection {
  LinePlace begin;
  std::size_t end = 0;           // the first line after it
  LinePlace back;                // where reading goes on when all passes are done
  int remaining = 0;             // passes
  std::size_t level = 0;         // of calls, in which it is repeated
  std::uint64_t pass = 1;        // the text itself was the first
  std::size_t calling_line = 0;  // of CALL BLOCK; 0: it is repeated
};

class RepeatedSections {
 public:
  /// Where reading goes on, and what the steps are told of it.
  struct GoesOn {
    LinePlace at;
    std::optional<FlowEntry> entry;
  };

  /// Its first pass begins. Refuses with nc-not-interpreted a part that is called (CALL BLOCK) while it is executed.
  GoesOn begin(const Block& block, const RepeatedSection& section);
  /// Of the line after the part that this level of calls repeats, or of the end of the file (kEndOfFile); nothing: the
  /// line is none such.
  std::optional<GoesOn> after(std::size_t line, std::size_t level);
  /// Refuses a jump out of it: what the control does with the passes that are left is in no source.
  void check_jump(const Block& block, const LinePlace& to, std::size_t level) const;
  /// The call of this level ends.
  void leave(std::size_t level);

 private:
  GoesOn next_pass();
  std::vector<RepeatedSection> sections_;  // one inside the other
};

}  // namespace plumbline::nc
