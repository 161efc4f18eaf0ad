#include "settings/contradiction.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace plumbline::settings {

bool excludes(const OptionRow& one, const OptionRow& other) {
  constexpr std::array<std::string_view, 4> kInPlaceOfBound{"step-angle", "step-length", "friction-turn",
                                                            "first-order"};
  const auto is_other = [&](std::string_view name) {
    return std::find(kInPlaceOfBound.begin(), kInPlaceOfBound.end(), name) != kInPlaceOfBound.end();
  };
  return (one.group == OptionGroup::bound && is_other(other.name)) ||
         (other.group == OptionGroup::bound && is_other(one.name));
}

std::optional<std::string> contradiction(const Options& options) {
  const compensate::Settings& compensation = options.compensation;
  if (!compensation.bound.is_asked()) return std::nullopt;
  if (options.steps_given)
    return "--tolerance chooses the points: --step-angle and --step-length say nothing beside it";
  if (compensation.sign_width_of_feed != compensate::Settings().sign_width_of_feed)
    return "--tolerance takes friction to turn as fast as the model says: --friction-turn says nothing beside it";
  if (compensation.method == compensate::Method::first_order)
    return "--first-order leaves an error that no choice of points takes away: --tolerance cannot be kept with it";
  return std::nullopt;
}

}  // namespace plumbline::settings
