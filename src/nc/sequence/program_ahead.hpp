// The steps of a program, executed on a thread of its own ahead of who takes them.
#pragma once

#include <memory>

#include "nc/sequence/program.hpp"

namespace plumbline::nc {

/// Gives what Program gives, in the same order; what it refuses is refused when the steps before it were taken. Reads
/// a few hundred blocks ahead, so that memory does not grow with the program. Where there is one processor, or no
/// thread to be had, it reads when it is asked.
class ProgramAhead {
 public:
  /// As of Program.
  ProgramAhead(const InputFile& file, const Dialect& dialect, ProgramSettings settings);
  ~ProgramAhead();
  ProgramAhead(ProgramAhead&&) = delete;
  ProgramAhead& operator=(ProgramAhead&&) = delete;
  ProgramAhead(const ProgramAhead&) = delete;
  ProgramAhead& operator=(const ProgramAhead&) = delete;

  /// As Program::next(); the step holds until the next call.
  const Step* next();
  /// The step that the call of next() after `skipped` others will give, if it was read already and is kept beside the
  /// last one; null otherwise, and whenever nothing is read ahead. Holds as the last one does.
  const Step* ahead(std::size_t skipped) const;
  /// Of the last step, as Program has them.
  bool jumped() const { return jumped_; }
  bool position_read() const { return position_read_; }

 private:
  struct Reader;
  const Step* next_in_place();

  Program program_;
  bool jumped_ = false;
  bool position_read_ = false;
  std::unique_ptr<Reader> reader_;  // null: no thread reads ahead
};

}  // namespace plumbline::nc
