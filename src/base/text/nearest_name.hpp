// What was probably meant: the known name nearest to a misspelt one.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace plumbline {

/// The candidate that the fewest insertions, deletions and exchanges of a letter turn into `name`; empty if all need
/// more than a third of its letters.
std::string_view nearest_name(std::string_view name, const std::vector<std::string_view>& candidates);

/// "did you mean x? ", to begin a sentence of help with; empty if none is near.
std::string did_you_mean(std::string_view name, const std::vector<std::string_view>& candidates);

/// "did you mean `x`?" and, in any case, the whole list of what is known.
std::string suggestion(std::string_view name, const std::vector<std::string_view>& candidates);

}  // namespace plumbline
