// What a block does besides moving.
#pragma once

#include <vector>

#include "compensate/read_back/intended.hpp"
#include "nc/control/step.hpp"
#include "nc/language/dialect.hpp"

namespace plumbline::compensate {

/// Appends the comments of the block of a step, then its codes and S, T and D words in the order in which the control
/// executes them. Left out is what shows otherwise: moves, feed, and modes that IntendedState holds.
void append_effects(const nc::Step& step, const nc::Dialect& dialect, std::vector<BlockEffect>& effects);

/// True if both say the same, their values alike to what nine decimals hold.
bool are_alike(const BlockEffect& a, const BlockEffect& b);

/// As the messages name it: "M100 P1".
std::string text_of(const BlockEffect& effect);

/// The name of the first thing in which two states differ; empty if they are alike.
std::string difference(const IntendedState& meant, const nc::Modal& modal, const nc::Frame& frame);

}  // namespace plumbline::compensate
