#include "nc/sequence/kept_steps.hpp"

#include <algorithm>

#include "base/same_value.hpp"

namespace plumbline::nc {
namespace {

constexpr std::size_t kSteps = 128;
constexpr std::size_t kTexts = std::size_t{1} << 14U;  // bytes of their blocks

// Blocks change little of what is in force: one that is as the last kept is that one.
template <class State>
const State* keep_state(std::deque<State>& kept, const State* state) {
  if (state == nullptr) return nullptr;
  if (kept.empty() || !same_value(kept.back(), *state)) kept.push_back(*state);
  return &kept.back();
}

}  // namespace

std::string_view FileNames::keep(std::string_view name) {
  if (name != last_) last_ = *names_.emplace(name).first;
  return last_;
}

KeptSteps::KeptSteps() {
  steps_.reserve(kSteps);
  texts_.reserve(kTexts);
}

void KeptSteps::clear() {
  used_ = 0;
  texts_.clear();
  modals_.clear();
  frames_.clear();
  is_last_ = false;
  refusal_ = nullptr;
}

std::string_view KeptSteps::keep_text(std::string_view text) {
  const std::size_t begin = texts_.size();
  texts_ += text;
  return std::string_view(texts_).substr(begin);
}

bool KeptSteps::add(const Step& step, Program& program, FileNames& files) {
  const std::size_t names = step.flow ? step.flow->name.size() : 0;
  const std::size_t room = step.block->text.size() + step.block->line_end.size() + names;
  if (used_ == kSteps) return false;
  if (texts_.size() + room > texts_.capacity()) {
    if (used_ > 0) return false;
    texts_.reserve(room);
  }
  if (used_ == steps_.size()) steps_.emplace_back();
  Kept& kept = steps_[used_++];
  kept.jumped = program.jumped();
  kept.position_read = program.position_read();
  kept.block = program.exchange_block(std::move(kept.block));
  kept.block->file = files.keep(kept.block->file);
  kept.block->text = keep_text(kept.block->text);
  kept.block->line_end = keep_text(kept.block->line_end);
  kept.step = step;
  kept.motions.assign(step.motions.begin(), step.motions.end());
  kept.step.motions = kept.motions;
  kept.holes.assign(step.holes.begin(), step.holes.end());
  kept.step.holes = kept.holes;
  kept.step.before = keep_state(modals_, step.before);
  kept.step.after = keep_state(modals_, step.after);
  kept.step.frame = keep_state(frames_, step.frame);
  if (step.call != nullptr) {
    kept.call = *step.call;
    kept.step.call = &kept.call;
  }
  if (step.flow) {
    kept.step.flow->name = keep_text(step.flow->name);
    kept.step.flow->file = files.keep(step.flow->file);
  }
  return true;
}

void KeptSteps::end(std::exception_ptr refusal) {
  is_last_ = true;
  refusal_ = std::move(refusal);
}

}  // namespace plumbline::nc
