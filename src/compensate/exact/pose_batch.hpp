// Any number of poses, corrected or played on the model together: they go in one by one and come out in the same order.
// What a pose gets does not depend on those beside it, nor on the processor.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "base/axes.hpp"
#include "compensate/exact/pose_block.hpp"
#include "compensate/exact/setup.hpp"

namespace plumbline::compensate::exact {

/// Code of the kernels for one kind of processor.
struct InstructionSet {
  std::string_view name;
  int lanes;
  void (*correct)(const Setup&, const AskedBlock*, AnsweredBlock*, std::size_t poses);
  void (*play)(const Setup&, Friction, const AskedBlock*, PlayedBlock*, std::size_t poses);
  void (*carry)(const Setup&, Friction, const AskedBlock*, CarriedBlock*, std::size_t poses);
};

/// Those that this processor has: one lane alone first, the fastest last. All give the same bits.
std::span<const InstructionSet> instruction_sets();

class PoseBatch {
 public:
  void clear() { count_ = 0; }
  std::size_t size() const { return count_; }
  /// See compensate/target.hpp. `seconds` below zero: only the direction counts.
  void add(const AxisWords& pose, const AxisWords& slope, const AxisWords& bend, double seconds);

  /// Corrects all poses that were added since clear().
  void correct(const Setup& setup);
  void correct(const Setup& setup, const InstructionSet& with);

  /// Finds where the deformed machine stands when it is sent to these poses.
  void play(const Setup& setup, Friction friction);
  void play(const Setup& setup, Friction friction, const InstructionSet& with);

  /// Finds what the struts carry where the machine is sent to, its giving way left out.
  void carry(const Setup& setup, Friction friction);
  void carry(const Setup& setup, Friction friction, const InstructionSet& with);

  // of the pose that was added as number i; hold after correct()
  AxisWords commanded(std::size_t i) const;
  machine::PerStrut<double> sign(std::size_t i) const;
  int state(std::size_t i) const { return static_cast<int>(answered_[i / kBlock].state[i % kBlock]); }
  // the same; hold after play()
  bool stands(std::size_t i) const { return played_[i / kBlock].state[i % kBlock] != 0; }
  Pose<double> stands_at(std::size_t i) const;
  machine::PerStrut<double> speed(std::size_t i) const;
  // the same; hold after carry(), where it carries() at all: else the packs cannot say
  bool carries(std::size_t i) const { return carried_[i / kBlock].state[i % kBlock] != 0; }
  machine::PerStrut<double> length(std::size_t i) const;       // m
  machine::PerStrut<double> nut_tension(std::size_t i) const;  // N

 private:
  void fill_lanes(int lanes);

  std::size_t count_ = 0;
  std::vector<AskedBlock> asked_;
  std::vector<AnsweredBlock> answered_;
  std::vector<PlayedBlock> played_;
  std::vector<CarriedBlock> carried_;
};

}  // namespace plumbline::compensate::exact
