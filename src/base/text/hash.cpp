#include "base/text/hash.hpp"

#include <fmt/format.h>

namespace plumbline {

std::string to_hex(std::uint64_t hash) { return fmt::format("{:016x}", hash); }

}  // namespace plumbline
