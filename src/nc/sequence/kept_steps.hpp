// Steps that outlive the block that they came from.
#pragma once

#include <deque>
#include <exception>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "nc/control/state/control.hpp"
#include "nc/control/step.hpp"
#include "nc/sequence/program.hpp"

namespace plumbline::nc {

/// Names of files, each once; a name holds as long as this does.
class FileNames {
 public:
  std::string_view keep(std::string_view name);

 private:
  std::set<std::string, std::less<>> names_;
  std::string_view last_;
};

/// As many steps as fit, with all that they point to but the rows of the dialect. Filled again and again, so that it
/// does not allocate once it has grown.
class KeptSteps {
 public:
  KeptSteps();

  void clear();
  /// The last step of the program, with its block. False, and nothing is kept: it does not fit beside those that are
  /// there.
  bool add(const Step& step, Program& program, FileNames& files);
  /// The program ends after these steps; with `refusal` it cannot be read beyond them.
  void end(std::exception_ptr refusal = {});

  struct Kept {
    Step step;
    bool jumped = false;
    bool position_read = false;
    std::unique_ptr<Block> block = std::make_unique<Block>();
    std::vector<Motion> motions;
    std::vector<Hole> holes;
    CycleCall call;
  };
  std::size_t size() const { return used_; }
  const Kept& operator[](std::size_t i) const { return steps_[i]; }
  bool is_last() const { return is_last_; }
  const std::exception_ptr& refusal() const { return refusal_; }

 private:
  std::string_view keep_text(std::string_view text);

  std::vector<Kept> steps_;  // of which the first used_ are filled; they never move, so that steps may point to them
  std::size_t used_ = 0;
  std::string texts_;  // never grows beyond what it has room for while something points into it
  std::deque<Modal> modals_;
  std::deque<Frame> frames_;
  bool is_last_ = false;
  std::exception_ptr refusal_;
};

}  // namespace plumbline::nc
