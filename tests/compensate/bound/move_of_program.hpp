// The last move of a program, and the parts that choose its points.
#pragma once

#include <string>
#include <vector>

#include "compensate/bound/correction_curve.hpp"
#include "compensate/opened.hpp"

namespace plumbline {

struct MoveOfProgram {
  explicit MoveOfProgram(const std::string& text, bool friction)
      : opened(text, job_of(friction)), reader(reader_of(opened)), corrector(opened.job.model, opened.job.settings) {
    const compensate::Move* read = reader.next_move();
    for (; read != nullptr; read = reader.next_move()) {
      if (!read->is_rapid()) break;
    }
    move = *read;
  }

  static Job job_of(bool friction) {
    Job job = standing_at_zero();
    job.settings.friction = friction;
    return job;
  }

  Opened opened;
  compensate::MoveReader reader;
  compensate::Corrector corrector;
  compensate::Move move;
};

}  // namespace plumbline
