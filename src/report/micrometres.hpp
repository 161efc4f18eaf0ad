// Corrections are told in micrometres; programs are in millimetres.
#pragma once

#include "base/units.hpp"

namespace plumbline::report {

inline constexpr double kUmPerMm = kMm / kUm;

}  // namespace plumbline::report
