// Everything inside plumbline is SI (m, rad, s, kg, N); NC programs, model files and datasets speak mm, deg, um, min.
// These factors are used where such a file is read or written, and nowhere else.
#pragma once

#include <numbers>

namespace plumbline {

inline constexpr double kMm = 1e-3;                       // m per millimetre
inline constexpr double kUm = 1e-6;                       // m per micrometre
inline constexpr double kInch = 25.4e-3;                  // m per inch
inline constexpr double kMmPerInch = 25.4;                // exact by definition
inline constexpr double kDeg = std::numbers::pi / 180.0;  // rad per degree
inline constexpr double kMrad = 1e-3;                     // rad per milliradian
inline constexpr double kUrad = 1e-6;                     // rad per microradian
inline constexpr double kMs = 1e-3;                       // s per millisecond
inline constexpr double kMinute = 60.0;                   // s per minute
inline constexpr double kMmPerMin = kMm / kMinute;        // m/s per mm/min
inline constexpr double kStandardGravity = 9.80665;       // m/s^2, CGPM 1901

}  // namespace plumbline
