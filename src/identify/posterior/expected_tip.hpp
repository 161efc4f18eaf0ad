// What a posterior leaves open of where the tip is, as one number.
#pragma once

#include <optional>
#include <vector>

#include "identify/posterior/posterior.hpp"
#include "identify/tip_field.hpp"

namespace plumbline::identify {

/// Rms of how far the tip is expected to be from where the model has it, m, over the poses that `runs` measured: to
/// first order about the model's numbers, its states as likely as they are. Nil where there are no runs.
double expected_at_tip(const machine::RotationOrder& order, const std::vector<measure::Run>& runs,
                       const Posterior& posterior);

/// A model that its own posterior calls less sure than the model as given, m.
struct LessSure {
  double given = 0, learnt = 0;
};
/// Nothing: it is about as sure at least, or moves the tip by twice as much as it is unsure of, or nothing is stated of
/// the model as given.
std::optional<LessSure> less_sure(const machine::RotationOrder& order, const std::vector<measure::Run>& runs,
                                  const Posterior& given, const Posterior& learnt);

}  // namespace plumbline::identify
