// Terms of a description that are periodic in the length of a strut.
#pragma once

#include <vector>

#include "diagnose/description/term_columns.hpp"

namespace plumbline::diagnose {

/// The strongest of the terms, strongest first.
std::vector<Term> foremost(std::vector<Term> terms, int count);

/// The waves in length or torque that go best with the residual alone, of which nuisances take little. Adds how many
/// were tried.
std::vector<Term> best_waves(const std::vector<ReadyRun>& runs, const LinearProblem& problem,
                             const identify::NoiseModel& noise, const DescriptionOptions& options, double& tried);

/// The pitches of the waves in length or torque, each strut with its own phase, that go best with what is `left` of
/// each run (whitened), strongest first. Adds how many were tried.
std::vector<double> best_pitches(const std::vector<ReadyRun>& runs, const std::vector<identify::SlopeRows>& left,
                                 const identify::NoiseModel& noise, Term::Channel channel,
                                 const DescriptionOptions& options, int count, double& tried);

}  // namespace plumbline::diagnose
