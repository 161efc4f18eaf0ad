// The pictures of a diagnosis as SVG.
#pragma once

#include <string>

#include "diagnose/diagnose.hpp"

namespace plumbline::report {

/// Text as it may stand in HTML.
std::string escaped(const std::string& text);

/// Run by channel: colour by rms over the noise, before beside after.
std::string gap_map(const diagnose::Diagnosis& diagnosis);

/// The bar's residuals of one run around the circle, before and after; `scale` (m) is the distance of the two rings.
std::string polar_plot(const diagnose::RunGap& run, double scale);

/// Log odds of the foremost effects as bars.
std::string evidence_bars(const diagnose::Diagnosis& diagnosis);

}  // namespace plumbline::report
