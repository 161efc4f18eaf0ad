// The steps of a program, executed on a thread of its own ahead of who takes them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "nc/sequence/kept_steps.hpp"
#include "nc/sequence/program.hpp"

namespace plumbline::nc {

/// Prepares work for steps that were read ahead, where they are read.
class StepsAhead {
 public:
  static constexpr std::size_t kPlaces = 8;

  virtual ~StepsAhead() = default;
  /// The steps that come next, before the first of them is taken. What is made of them is kept in this place, below
  /// kPlaces, and is for who takes them: until the first step after them is taken, nobody looks at others for it.
  virtual void look(const KeptSteps& steps, std::size_t place) = 0;
};

/// Gives what Program gives, in the same order; what it refuses is refused when the steps before it were taken. Reads
/// a few hundred blocks ahead, so that memory does not grow with the program. Where there is one processor, or no
/// thread to be had, it reads when it is asked: some dozens at a time for one who looks, else one.
class ProgramAhead {
 public:
  /// As of Program; `looks`, if not null, must outlive it.
  ProgramAhead(const InputFile& file, const Dialect& dialect, ProgramSettings settings, StepsAhead* looks = nullptr);
  ~ProgramAhead();
  ProgramAhead(ProgramAhead&&) = delete;
  ProgramAhead& operator=(ProgramAhead&&) = delete;
  ProgramAhead(const ProgramAhead&) = delete;
  ProgramAhead& operator=(const ProgramAhead&) = delete;

  /// As Program::next(); the step holds until the next call.
  const Step* next();
  /// How many times steps were handed over so far, of which the last step is one; 0 where nothing is read ahead.
  std::uint64_t handed_over() const;
  /// Where these were looked at.
  std::size_t place() const;
  /// Of the last step, as Program has them.
  bool jumped() const { return jumped_; }
  bool position_read() const { return position_read_; }

 private:
  struct Reader;
  const Step* next_in_place();

  Program program_;
  bool jumped_ = false;
  bool position_read_ = false;
  std::unique_ptr<Reader> reader_;  // null: nothing is read ahead
};

}  // namespace plumbline::nc
