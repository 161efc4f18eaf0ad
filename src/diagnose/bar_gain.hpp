// A bar that reads so many times what it should, in all runs: a diameter for a radius, a scale that was set wrong.
#pragma once

#include <optional>

#include "diagnose/objection.hpp"
#include "diagnose/search/search.hpp"

namespace plumbline::diagnose {

struct BarGainOptions {
  double least = 1.15;  // factor, or its inverse, from which it is no calibration of an instrument
  double margin = 12;   // nats by which it must be likelier than what was found: few bars are set so wrong
  double bend = 120;    // nats that later steps may bring
  int steps = 3;        // of Gauss and Newton
};

/// The factor that all readings of the bar have in common, fitted with the nuisances of the base model: in place of all
/// effects found, of each, or beside them; the likeliest. Nothing: it is near one, no run has a bar, or what was found
/// is not less likely by the margin, a number costing what it does in the Bayesian information criterion [Schwarz
/// 1978].
std::optional<BarGain> bar_gain(const Workbench& bench, const Model& model, const BarGainOptions& options = {});

/// Effects that a bar with a factor would do without. Nothing: there are none, or nothing is likelier than they are.
std::optional<Doubt> doubt_of_bar(const Workbench& bench, const Model& model);

}  // namespace plumbline::diagnose
