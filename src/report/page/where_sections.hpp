// Where model and measurements disagree: the gap cut in the ways in which effects show.
#pragma once

#include <string>
#include <vector>

#include "diagnose/diagnose.hpp"
#include "report/page/page.hpp"

namespace plumbline::report {

/// "bar", "motor 1" to "motor 6".
std::string channel_words(int channel);
/// The run's name, and that it was left out of the fit.
std::string run_words(const diagnose::RunGap& run);

/// Run by channel, rms over the noise: before, after, and with the second-best effect in place of the best.
Json gap_map_section(const diagnose::Diagnosis& diagnosis);

/// Around the circle, before: channel by order of the wave and by twelfth of the circle, over the noise. Empty: the gap
/// was not cut.
std::vector<Json> around_circle_sections(const diagnose::Diagnosis& diagnosis);

/// What pairs of runs have in common and where they differ; groups of runs; steps where struts turn around. Empty
/// where there are none.
std::vector<Json> run_contrast_sections(const diagnose::Diagnosis& diagnosis);

/// The bar's residuals around the circle, before and after. Null: no run has readings of the bar.
Json residual_circles_section(const diagnose::Diagnosis& diagnosis, const std::vector<measure::Run>& runs);

/// Circularity of each circle: as measured, compensated with the model as given, with what was found. Null: there is
/// none.
Json circularity_section(const diagnose::Diagnosis& diagnosis);

}  // namespace plumbline::report
