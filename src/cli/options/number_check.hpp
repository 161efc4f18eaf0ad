// What numbers an option takes: CLI11's own checks let "nan" pass.
#pragma once

#include <CLI/CLI.hpp>

namespace plumbline::cli {

/// Finite numbers from `least` to `most`.
CLI::Validator number_between(double least, double most);
/// Finite numbers above 0.
CLI::Validator number_above_zero();
/// Finite numbers from 0 on.
CLI::Validator number_from_zero();
/// Digits alone, of a number below 2^64: CLI11 takes -1 and what is too large for other numbers.
CLI::Validator whole_number();

}  // namespace plumbline::cli
