// The steps that are written for a block of the program: itself, or, where the program is written as it is executed,
// what is left of it without parameters and lines that steer.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "nc/rewrite/emit.hpp"
#include "nc/rewrite/unrolled/step_expander.hpp"
#include "nc/rewrite/unrolled/written_moves.hpp"

namespace plumbline::compensate {

class WrittenSteps {
 public:
  /// The dialect must outlive it.
  WrittenSteps(const nc::Dialect& dialect, const nc::EmitSettings& emit, nc::Form form);

  struct OfBlock {
    std::span<const nc::Step* const> steps;  // in order
    std::optional<nc::Step> steering;        // Emitter::steer, after them
  };
  /// Holds until the next call. Refuses with compensate-flow what nothing can stand for.
  OfBlock of(const nc::Step& step);

  /// Before the end of a program that is written out: blocks that leave to others the variables that it set.
  std::vector<std::string> restated_variables(const nc::Step& step) const;

  /// A cycle move by move. `anew`: as in nc::WrittenMoves::of. Holds until the next call.
  std::span<const nc::Step* const> of_cycle(const nc::Step& step, bool anew = false) {
    return moves_.of(*expander_.plain(step, true), anew);
  }
  /// The step with X and Y in place of @ and ^, and A, B and C in place of a direction of the tool. Holds until the
  /// next call of any.
  const nc::Step& in_other_words(const nc::Step& step) { return *expander_.plain(step, true); }

  bool unrolled() const { return form_ == nc::Form::unrolled; }
  /// StepExpander::silenced.
  const Place* silenced() const { return expander_.silenced(); }

 private:
  OfBlock only(const nc::Step* step);
  OfBlock of_steering(const nc::Step& step);

  const nc::Dialect& dialect_;
  nc::Form form_;
  nc::StepExpander expander_;
  nc::WrittenMoves moves_;
  const nc::Step* only_ = nullptr;
};

}  // namespace plumbline::compensate
