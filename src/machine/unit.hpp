// The units that model files speak, with what is easily mistaken for them.
#pragma once

#include <array>
#include <string_view>

#include "base/units.hpp"

namespace plumbline::machine {

/// Another unit in which a number may have been written by mistake: value x factor is the value in the right one.
struct Slip {
  std::string_view name;
  double factor = 0;  // 0: none
};

struct Unit {
  std::string_view name;  // as messages write it; empty for numbers without unit
  double si = 1;          // value in SI = value in the file x si
  std::array<Slip, 2> slips{};
};

namespace units {
inline constexpr Unit none{"", 1, {}};
inline constexpr Unit percent{"%", 0.01, {}};
inline constexpr Unit mm{"mm", kMm, {{{"m", 1000}, {"um", 0.001}}}};
inline constexpr Unit um{"um", kUm, {{{"mm", 1000}, {"m", 1e6}}}};
inline constexpr Unit inch{"inch", kInch, {}};
inline constexpr Unit deg{"deg", kDeg, {{{"rad", 1 / kDeg}, {}}}};
inline constexpr Unit mrad{"mrad", kMrad, {{{"rad", 1000}, {"urad", 0.001}}}};
inline constexpr Unit kg{"kg", 1, {{{"g", 0.001}, {"t", 1000}}}};
inline constexpr Unit N{"N", 1, {{{"kN", 1000}, {"mN", 0.001}}}};
inline constexpr Unit Nm{"N m", 1, {{{"N mm", 0.001}, {}}}};
inline constexpr Unit N_m{"N/m", 1, {{{"N/mm", 1000}, {"N/um", 1e6}}}};
inline constexpr Unit um_N{"um/N", kUm, {{{"mm/N", 1000}, {"nm/N", 0.001}}}};
inline constexpr Unit um_N_m{"um/N per m", kUm, {{{"um/N per mm", 1000}, {"nm/N per m", 0.001}}}};
inline constexpr Unit Nms_rad{"N m s/rad", 1, {}};
inline constexpr Unit N_s_m{"N s/m", 1, {{{"N s/mm", 1000}, {}}}};
inline constexpr Unit mm_s{"mm/s", kMm, {{{"m/s", 1000}, {"mm/min", 1 / 60.0}}}};
inline constexpr Unit m_s2{"m/s^2", 1, {{{"mm/s^2", 0.001}, {"g", kStandardGravity}}}};
inline constexpr Unit ms{"ms", 1e-3, {{{"s", 1000}, {"us", 0.001}}}};
inline constexpr Unit K_h{"K/h", 1 / 3600.0, {}};
inline constexpr Unit um_m{"um/m", 1e-6, {}};
inline constexpr Unit um_h{"um/h", kUm / 3600.0, {}};
inline constexpr Unit urad_Nm{"urad/N m", 1e-6, {}};
}  // namespace units

}  // namespace plumbline::machine
