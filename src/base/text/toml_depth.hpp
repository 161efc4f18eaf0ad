// How deep the tables of a TOML text lie in each other, seen before it is parsed.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace plumbline {

/// The offset where keys with points or brackets first lie more than `most` deep; nothing: nowhere. Parsing takes a
/// stack that grows with that depth. A text that is no TOML is looked at up to where the parser would stop, at least.
std::optional<std::size_t> too_deep(std::string_view text, std::size_t most);

}  // namespace plumbline
