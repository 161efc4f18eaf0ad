#include "cli/options/number_check.hpp"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <system_error>

#include <fmt/format.h>

namespace plumbline::cli {
namespace {

CLI::Validator number_that(const std::function<bool(double)>& fits, const std::string& wanted,
                           const std::string& name) {
  return CLI::Validator(
      [fits, wanted](const std::string& text) {
        double value = 0;
        const bool is_number = CLI::detail::lexical_cast(text, value) && std::isfinite(value);
        return is_number && fits(value) ? std::string() : fmt::format("{} is no number {}", text, wanted);
      },
      name);
}

}  // namespace

CLI::Validator number_between(double least, double most) {
  const std::string range = fmt::format("[{} - {}]", least, most);
  return number_that([=](double value) { return value >= least && value <= most; }, "in " + range, "in " + range);
}

CLI::Validator number_above_zero() {
  return number_that([](double value) { return value > 0; }, "above 0", "POSITIVE");
}

CLI::Validator number_from_zero() {
  return number_that([](double value) { return value >= 0; }, "from 0 on", "NONNEGATIVE");
}

CLI::Validator whole_number() {
  return CLI::Validator(
      [](const std::string& text) {
        std::uint64_t value = 0;
        const auto [end, wrong] = std::from_chars(text.data(), text.data() + text.size(), value);
        const bool fits = wrong == std::errc() && end == text.data() + text.size();
        return fits ? std::string() : fmt::format("{} is no whole number from 0 to 2^64 - 1", text);
      },
      "");
}

}  // namespace plumbline::cli
