#include "compensate/exact/pose_batch.hpp"

#include "compensate/exact/kernel_units.hpp"

namespace plumbline::compensate::exact {
namespace {

std::vector<InstructionSet> sets_here() {
  std::vector<InstructionSet> sets{{"one lane", 1, correct_one_by_one}, {"any processor", 2, correct_on_any}};
#ifdef PLUMBLINE_X86_64_UNITS
  if (has_x86_64_v3()) sets.push_back({"x86-64-v3", 4, correct_on_x86_64_v3});
  if (has_x86_64_v4()) sets.push_back({"x86-64-v4", 8, correct_on_x86_64_v4});
#endif
  return sets;
}

}  // namespace

std::span<const InstructionSet> instruction_sets() {
  static const std::vector<InstructionSet> sets = sets_here();
  return sets;
}

void PoseBatch::add(const AxisWords& pose, const AxisWords& slope, const AxisWords& bend, double seconds) {
  const std::size_t lane = count_ % kBlock;
  if (count_ / kBlock == asked_.size()) asked_.emplace_back();
  AskedBlock& block = asked_[count_ / kBlock];
  for (std::size_t a = 0; a < kAxes; ++a) {
    block.pose[a][lane] = pose.values[a];
    block.slope[a][lane] = slope.values[a];
    block.bend[a][lane] = bend.values[a];
  }
  block.seconds[lane] = seconds;
  ++count_;
}

void PoseBatch::correct(const Setup& setup) {
  const std::span<const InstructionSet> sets = instruction_sets();
  correct(setup, count_ == 1 ? sets.front() : sets.back());
}

void PoseBatch::correct(const Setup& setup, const InstructionSet& with) {
  answered_.resize(asked_.size());
  const auto lanes = static_cast<std::size_t>(with.lanes);
  const std::size_t last = count_ - 1;
  for (std::size_t rest = count_; rest % lanes != 0; ++rest) {  // lanes that nobody asked for
    AskedBlock& block = asked_[last / kBlock];
    for (Rows6* const rows : {&block.pose, &block.slope, &block.bend}) {
      for (Row& row : *rows) row[rest % kBlock] = row[last % kBlock];
    }
    block.seconds[rest % kBlock] = block.seconds[last % kBlock];
  }
  with.correct(setup, asked_.data(), answered_.data(), count_);
}

AxisWords PoseBatch::commanded(std::size_t i) const {
  AxisWords words;
  for (std::size_t a = 0; a < kAxes; ++a) words.values[a] = answered_[i / kBlock].pose[a][i % kBlock];
  return words;
}

machine::PerStrut<double> PoseBatch::sign(std::size_t i) const {
  machine::PerStrut<double> sign;
  for (std::size_t j = 0; j < 6; ++j) sign[static_cast<int>(j)] = answered_[i / kBlock].sign[j][i % kBlock];
  return sign;
}

}  // namespace plumbline::compensate::exact
