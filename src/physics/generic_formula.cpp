#include "physics/generic_formula.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "physics/effects/generic.hpp"

namespace plumbline::physics {
namespace {

// The factors as Generic lists them.
constexpr std::array<std::string_view, kStrutFactors> kStrutWords{
    "((L - L_mid) / 100 mm)", "(Ldot / (10 mm/s))", "s", "(t / kN)", "|t / kN|", "u_x", "u_y", "u_z"};
constexpr std::array<std::string_view, kSharedFactors> kSharedWords{
    "(x / 100 mm)", "(y / 100 mm)", "((z + 1 m) / 100 mm)", "z_x", "z_y", "(time / h)"};

template <class Number>
std::string powers_text(std::span<const Number> powers, std::span<const std::string_view> factors) {
  std::string text;
  for (std::size_t k = 0; k < factors.size(); ++k) {
    const int n = static_cast<int>(powers[k]);
    if (n > 0) text += fmt::format(" x {}", factors[k]);
    if (n > 1) text += fmt::format("^{}", n);
  }
  return text;
}

struct Channel {
  std::string_view key, name;
  bool per_strut;
};
constexpr std::array kChannels{Channel{"length_um", "length_j", true}, Channel{"drive_N", "drive tension_j", true},
                               Channel{"torque_Nm", "torque reading_j", true},
                               Channel{"force_N", "force at the tip", false}, Channel{"tip_um", "tip", false}};

}  // namespace

std::string powers_formula(std::span<const int> strut_powers, std::span<const int> shared_powers) {
  return powers_text(strut_powers, kStrutWords) + powers_text(shared_powers, kSharedWords);
}

std::string generic_formula(std::span<const double> parameters) {
  const std::string shared = powers_text(parameters.subspan(Generic::kSharedPowers, kSharedFactors), kSharedWords);
  std::string own = powers_text(parameters.subspan(Generic::kStrutPowers, kStrutFactors), kStrutWords);
  if (parameters[Generic::kPitch] > 0) {
    own += fmt::format(" x cos(2 pi L / {:.4g} mm + {:.4g} deg)", parameters[Generic::kPitch] / kMm,
                       parameters[Generic::kPhase] / kDeg);
  }
  std::string lines;
  std::size_t first = 0;
  for (const ParameterSpec& spec : Generic::parameters) {
    const auto count = static_cast<std::size_t>(spec.size());
    std::vector<double> values;
    bool any = false;
    for (const double x : parameters.subspan(first, count)) {
      values.push_back(x / spec.unit.si);
      any = any || x != 0;
    }
    first += count;
    const auto* const channel =
        std::find_if(kChannels.begin(), kChannels.end(), [&](const Channel& c) { return c.key == spec.key; });
    if (channel == kChannels.end() || !any) continue;
    lines += fmt::format("{}{}: [{:.4g}] {}{}{}", lines.empty() ? "" : "\n", channel->name, fmt::join(values, ", "),
                         spec.unit.name, channel->per_strut ? own : "", shared);
  }
  return lines;
}

}  // namespace plumbline::physics
