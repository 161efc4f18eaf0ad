// The subprograms that are being executed, one inside the other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "nc/control/parameters/parameters.hpp"
#include "nc/control/step.hpp"
#include "nc/language/block.hpp"
#include "nc/sequence/program_files.hpp"

namespace plumbline::nc {

enum class CalledBy : std::uint8_t {
  statement,  // O CALL, CALL OSUB, a name
  code,       // M98, G65
};

struct Call {
  std::string name;
  CalledBy by = CalledBy::statement;
  FilePlace back;                // where its caller goes on
  FilePlace entry;               // where it begins
  int remaining = 0;             // further calls of the same block
  std::size_t line = 0;          // of the call
  std::uint64_t pass = 1;        // of the calls of the same block
  std::vector<Value> arguments;  // by position, for its head
  bool takes_values = false;     // its head (PROC) was read
};

class CallStack {
 public:
  /// `most`: how deep the control takes them.
  explicit CallStack(std::size_t most) : most_(most) {}

  bool empty() const { return calls_.empty(); }
  std::size_t depth() const { return calls_.size(); }
  const Call& top() const { return calls_.back(); }
  Call& top() { return calls_.back(); }
  /// Refuses the call of the block if it is one too deep.
  void check_room(const Block& block) const;
  void push(Call call) { calls_.push_back(std::move(call)); }
  void pop() { calls_.pop_back(); }
  /// True: the block that called asks for one more call, which begins.
  bool begins_again();
  /// What the steps are told of the call on top; holds while it lasts.
  FlowEntry entry(const ProgramFiles& files) const;

 private:
  std::size_t most_;
  std::vector<Call> calls_;
};

/// "line 3", and "line 3 of MAIN.MPF" where the call stands in another file than what is read.
std::string line_of_call(const Call& call, const ProgramFiles& files);

/// The block is the head of what is called, PROC SUB(REAL A, REAL B): refused if it takes fewer values than are given.
void take_values(const Block& block, Call& call, const ProgramFiles& files);

/// Its first line shows whether what is called has a head that takes the values: refused if it has none.
void refuse_without_head(std::string_view text, std::size_t line, const Call& call, const ProgramFiles& files);

}  // namespace plumbline::nc
