// A model against measurements, for people and as JSON.
#pragma once

#include <string>

#include "jobs/compare.hpp"

namespace plumbline::report {

/// A line per run and the pooled figures.
std::string compare_text(const jobs::Comparison& comparison);
/// As docs/formats.md says; what was not measured is null.
std::string compare_json(const jobs::Comparison& comparison);
/// The same, and what another model, of that file, makes of the same measurements, as `beside`.
std::string compare_json(const jobs::Comparison& comparison, const jobs::Comparison& beside, const std::string& model);

}  // namespace plumbline::report
