#include "compensate/exact/pose_batch.hpp"

#include "compensate/exact/kernel_units.hpp"

namespace plumbline::compensate::exact {
namespace {

std::vector<InstructionSet> sets_here() {
  std::vector<InstructionSet> sets{{"one lane", 1, correct_one_by_one, play_one_by_one, carry_one_by_one},
                                   {"any processor", 2, correct_on_any, play_on_any, carry_on_any}};
#ifdef PLUMBLINE_X86_64_UNITS
  if (has_x86_64_v2()) sets.push_back({"x86-64-v2", 2, correct_on_x86_64_v2, play_on_x86_64_v2, carry_on_x86_64_v2});
  if (has_x86_64_v3()) sets.push_back({"x86-64-v3", 4, correct_on_x86_64_v3, play_on_x86_64_v3, carry_on_x86_64_v3});
  if (has_x86_64_v4()) sets.push_back({"x86-64-v4", 8, correct_on_x86_64_v4, play_on_x86_64_v4, carry_on_x86_64_v4});
#endif
  return sets;
}

// Of one pose the other lanes would be wasted.
const InstructionSet& best_for(std::size_t count) {
  const std::span<const InstructionSet> sets = instruction_sets();
  return count == 1 ? sets.front() : sets.back();
}

machine::PerStrut<double> six_of(const Rows6& rows, std::size_t i) {
  machine::PerStrut<double> six;
  for (std::size_t j = 0; j < 6; ++j) six[static_cast<int>(j)] = rows[j][i % kBlock];
  return six;
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

// Lanes that nobody asked for repeat the last pose.
void PoseBatch::fill_lanes(int lanes) {
  for (std::size_t rest = count_; rest % static_cast<std::size_t>(lanes) != 0; ++rest) {
    AskedBlock& block = asked_[rest / kBlock];
    const std::size_t last = (count_ - 1) % kBlock;
    for (Rows6* const rows : {&block.pose, &block.slope, &block.bend}) {
      for (Row& row : *rows) row[rest % kBlock] = row[last];
    }
    block.seconds[rest % kBlock] = block.seconds[last];
  }
}

void PoseBatch::correct(const Setup& setup) { correct(setup, best_for(count_)); }

void PoseBatch::correct(const Setup& setup, const InstructionSet& with) {
  fill_lanes(with.lanes);
  answered_.resize(asked_.size());
  with.correct(setup, asked_.data(), answered_.data(), count_);
}

void PoseBatch::play(const Setup& setup, Friction friction) { play(setup, friction, best_for(count_)); }

void PoseBatch::play(const Setup& setup, Friction friction, const InstructionSet& with) {
  fill_lanes(with.lanes);
  played_.resize(asked_.size());
  with.play(setup, friction, asked_.data(), played_.data(), count_);
}

void PoseBatch::carry(const Setup& setup, Friction friction) { carry(setup, friction, best_for(count_)); }

void PoseBatch::carry(const Setup& setup, Friction friction, const InstructionSet& with) {
  fill_lanes(with.lanes);
  carried_.resize(asked_.size());
  with.carry(setup, friction, asked_.data(), carried_.data(), count_);
}

AxisWords PoseBatch::commanded(std::size_t i) const {
  AxisWords words;
  for (std::size_t a = 0; a < kAxes; ++a) words.values[a] = answered_[i / kBlock].pose[a][i % kBlock];
  return words;
}

machine::PerStrut<double> PoseBatch::sign(std::size_t i) const { return six_of(answered_[i / kBlock].sign, i); }

Pose<double> PoseBatch::stands_at(std::size_t i) const {
  const PlayedBlock& block = played_[i / kBlock];
  Pose<double> pose;
  for (int a = 0; a < 3; ++a) {
    pose.p_WT[a] = block.tip[static_cast<std::size_t>(a)][i % kBlock];
    for (int b = 0; b < 3; ++b) pose.R_WP(a, b) = block.turned[static_cast<std::size_t>(3 * a + b)][i % kBlock];
  }
  return pose;
}

machine::PerStrut<double> PoseBatch::speed(std::size_t i) const { return six_of(played_[i / kBlock].speed, i); }

machine::PerStrut<double> PoseBatch::length(std::size_t i) const { return six_of(carried_[i / kBlock].length, i); }

machine::PerStrut<double> PoseBatch::nut_tension(std::size_t i) const {
  return six_of(carried_[i / kBlock].nut_tension, i);
}

}  // namespace plumbline::compensate::exact
