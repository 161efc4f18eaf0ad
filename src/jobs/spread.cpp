#include "jobs/spread.hpp"

#include <algorithm>
#include <cmath>

namespace plumbline::jobs {
namespace {

constexpr double kClassWidth = 1.005;
constexpr double kLeastClass = 1e-15;   // what is smaller counts as this
constexpr double kLargestClass = 1e18;  // what is larger counts as this

std::size_t spread_class(double value) {
  static const double scale = 1 / std::log(kClassWidth);
  const double held = std::clamp(value, kLeastClass, kLargestClass);
  return static_cast<std::size_t>(std::log(held / kLeastClass) * scale);
}

}  // namespace

void Spread::add(double value) {
  least_ = count_ == 0 ? value : std::min(least_, value);
  largest_ = count_ == 0 ? value : std::max(largest_, value);
  ++count_;
  if (classes_.empty()) classes_.resize(spread_class(kLargestClass) + 1);
  ++classes_[spread_class(value)];
}

double Spread::bound_of(double share) const {
  const double wanted = share * static_cast<double>(count_);
  std::uint64_t below = 0;
  for (std::size_t i = 0; i < classes_.size(); ++i) {
    below += classes_[i];
    if (below > 0 && static_cast<double>(below) >= wanted)
      return std::clamp(kLeastClass * std::pow(kClassWidth, static_cast<double>(i + 1)), least_, largest_);
  }
  return largest_;
}

}  // namespace plumbline::jobs
