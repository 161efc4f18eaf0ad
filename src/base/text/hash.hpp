// A short fingerprint of a text, for stamps: tells that two files differ, keeps no secret.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace plumbline {

/// FNV-1a, 64 bit [Fowler, Noll, Vo; draft-eastlake-fnv].
constexpr std::uint64_t fnv1a(std::string_view text, std::uint64_t hash = 0xcbf29ce484222325ULL) {
#pragma GCC unroll 8
  for (const char c : text) {
    hash ^= static_cast<unsigned char>(c);
    hash *= 0x100000001b3ULL;
  }
  return hash;
}

/// Sixteen hexadecimal digits.
std::string to_hex(std::uint64_t hash);

}  // namespace plumbline
