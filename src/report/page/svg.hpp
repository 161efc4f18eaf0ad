// The pictures of a diagnosis as SVG.
#pragma once

#include <string>

#include "diagnose/diagnose.hpp"

namespace plumbline::report {

/// Text as it may stand in HTML.
std::string escaped(const std::string& text);

inline constexpr int kMapCell = 26;  // px, of a map's squares
inline constexpr int kMapRow = 18;

/// Colour by the times that a figure is the noise: white for the noise and less, full red for ten times and more.
std::string heat(double times_noise);

/// A square of a map in that colour, with a title that says the number.
std::string map_square(int x, int y, double times_noise, const std::string& title);

/// "bar", "T1" to "T6": a channel over a column, or before a row.
std::string short_name(int channel);

/// Run by channel: colour by rms over the noise, before beside after.
std::string gap_map(const diagnose::Diagnosis& diagnosis);

/// The bar's residuals of one run around the circle, before and after; `scale` (m) is the distance of the two rings.
std::string polar_plot(const diagnose::RunGap& run, double scale);

/// Log odds of the foremost effects as bars.
std::string evidence_bars(const diagnose::Diagnosis& diagnosis);

}  // namespace plumbline::report
