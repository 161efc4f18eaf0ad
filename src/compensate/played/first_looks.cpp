#include "compensate/played/first_looks.hpp"

#include <algorithm>

namespace plumbline::compensate {

void FirstLooks::add(std::uint64_t block, const std::array<Target, kFractions.size()>& told) {
  blocks_.push_back(block);
  told_.insert(told_.end(), told.begin(), told.end());
}

void FirstLooks::play() {
  corrector_.play(told_, plays_);
  played_.insert(played_.end(), plays_.all().begin(), plays_.all().end());
  told_.clear();
}

std::span<const std::optional<PlayedTip>> FirstLooks::of(std::uint64_t block) const {
  const auto at = std::lower_bound(blocks_.begin(), blocks_.end(), block);
  if (at == blocks_.end() || *at != block) return {};
  const auto i = static_cast<std::size_t>(at - blocks_.begin());
  return std::span(played_).subspan(i * kFractions.size(), kFractions.size());
}

void FirstLooks::forget_before(std::uint64_t block) {
  const auto kept = std::lower_bound(blocks_.begin(), blocks_.end(), block);
  const auto forgotten = kept - blocks_.begin();
  blocks_.erase(blocks_.begin(), kept);
  played_.erase(played_.begin(), played_.begin() + forgotten * static_cast<std::ptrdiff_t>(kFractions.size()));
}

}  // namespace plumbline::compensate
