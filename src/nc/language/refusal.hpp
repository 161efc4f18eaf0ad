// How what a program says is refused.
#pragma once

#include <string>
#include <string_view>

#include "base/diagnostic.hpp"
#include "nc/language/block.hpp"

namespace plumbline::nc {

/// Where `span` of the block stands in its file.
Place place_in(const Block& block, Span span);

/// Refuses with the place of `span` in the block.
[[noreturn]] void refuse_at(const Block& block, Span span, std::string_view code, std::string message,
                            std::string help);

}  // namespace plumbline::nc
