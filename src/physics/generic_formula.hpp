// The effect `generic` in words: what a report says of it.
#pragma once

#include <span>
#include <string>

namespace plumbline::physics {

/// The formula of one instance, its parameters in SI as a ForceModel has them: one line per channel that it adds to, as
/// "length_j: [0, 3.2, 0, 0, 0, 0] um x s x (t / kN)^2". Empty where all coefficients are zero.
std::string generic_formula(std::span<const double> parameters);

/// " x s x (t / kN)^2": what a description is multiplied by.
std::string powers_formula(std::span<const int> strut_powers, std::span<const int> shared_powers);

}  // namespace plumbline::physics
