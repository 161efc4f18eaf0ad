#include "jobs/diff/moves.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/check.hpp"
#include "path/duration.hpp"

namespace plumbline::jobs {
namespace {

double turn_deg(const AxisWords& delta) { return std::hypot(delta[Axis::A], delta[Axis::B], delta[Axis::C]); }

bool states_code(const nc::Block& block, const nc::Dialect& dialect) {
  return std::any_of(block.words.begin(), block.words.end(), [&](const nc::Word& word) {
    const nc::CodeRow* const row = nc::is_code(word) ? dialect.row_of(word) : nullptr;
    return row != nullptr && (row->action == nc::Action::rapid || row->action == nc::Action::feed ||
                              row->action == nc::Action::arc_cw || row->action == nc::Action::arc_ccw);
  });
}

// Where nobody says whether F counts turns: as if it did not, which is true of what a correction turns.
std::optional<double> effort(const compensate::Move& read, const nc::Dialect& dialect) {
  if (read.duration || read.motion->feed_rule != nc::FeedRule::unknown) return read.duration;
  nc::Motion counted = *read.motion;
  counted.feed_rule = nc::FeedRule::xyz_first;
  return path::duration(counted, read.path.curve, dialect);
}

DiffMove diff_move(const compensate::Move& read, const nc::Dialect& dialect) {
  const nc::Step& step = *read.step;
  const nc::Motion& motion = *read.motion;
  const path::Curve& curve = read.path.curve;
  DiffMove move{motion.line,
                std::string(step.block->at(step.block->number)),
                motion.kind,
                motion.in_machine_coordinates,
                motion.in_machine_coordinates ? motion.machine : step.frame->to_pose(motion.to),
                curve.linear_mm() + turn_deg(curve.delta()),
                effort(read, dialect),
                read.seconds,
                *step.frame,
                curve};
  const bool alone = step.motions.size() == 1;
  if (alone || step.role == nc::BlockRole::plain) move.states_code = !alone || states_code(*step.block, dialect);
  return move;
}

}  // namespace

double distance(const AxisWords& a, const AxisWords& b) {
  const AxisWords d = a - b;
  return std::hypot(d[Axis::X], d[Axis::Y], d[Axis::Z]) + turn_deg(d);
}

MoveQueue::MoveQueue(const InputFile& file, const nc::Dialect& dialect, const nc::ProgramSettings& settings)
    : dialect_(dialect), reader_(file, dialect, settings, {.as_it_stands = true}) {}

bool MoveQueue::read_more() {
  const nc::Step* const step = reader_.next();
  if (step == nullptr) return false;
  offset_ = step->block->offset;
  numbered_ = numbered_ || step->block->has_number();
  for (const nc::Motion& motion : step->motions) {
    if (motion.kind == nc::MotionKind::dwell) {
      dwell_s_ += motion.dwell_s;
    } else if (step->role != nc::BlockRole::cycle || motion.from != motion.to) {  // cycles stop over where they stand
      moves_ahead_.push_back(diff_move(reader_.move(*step, motion), dialect_));
      moves_ahead_.back().begins_numbered = std::exchange(numbered_, false);
      if (keeps_texts_) moves_ahead_.back().text = step->block->text;
      ++moves_;
    }
  }
  return true;
}

const DiffMove* MoveQueue::peek(std::size_t ahead) {
  while (moves_ahead_.size() <= ahead) {
    if (!read_more()) return nullptr;
  }
  return &moves_ahead_[ahead];
}

void MoveQueue::drop(std::size_t count) {
  PLUMBLINE_CHECK(count <= moves_ahead_.size());
  moves_ahead_.erase(moves_ahead_.begin(), moves_ahead_.begin() + static_cast<std::ptrdiff_t>(count));
}

}  // namespace plumbline::jobs
