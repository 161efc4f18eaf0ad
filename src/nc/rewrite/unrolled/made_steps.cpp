#include "nc/rewrite/unrolled/made_steps.hpp"

#include <algorithm>

namespace plumbline::nc {

MadeStep& MadeSteps::next(const Step& like) {
  if (used_ == made_.size()) made_.emplace_back();
  MadeStep& made = made_[used_++];
  made.text.clear();
  made.before = *like.after;
  made.after = *like.after;
  made.step = Step{};
  made.step.frame = like.frame;
  made.step.position = like.position;
  made.step.known = like.known;
  made.step.shifted = like.shifted;
  return made;
}

bool MadeSteps::holds(const Step& step) const {
  return std::any_of(made_.begin(), made_.begin() + static_cast<std::ptrdiff_t>(used_),
                     [&](const MadeStep& made) { return &made.step == &step; });
}

void MadeSteps::parse(MadeStep& made, const Step& like) {
  made.block.file = like.block->file;
  made.block.text = made.text;
  made.block.line = like.block->line;
  made.block.line_end = like.block->line_end;
  made.block.offset = std::max<std::uint64_t>(like.block->offset, 1);  // the text is not at the begin of a file
  parser_.parse(made.block);
  made.block.offset = like.block->offset;
  made.step.block = &made.block;
}

}  // namespace plumbline::nc
