// Values that change little from block to block, held against each other.
#pragma once

#include <cstring>
#include <type_traits>

namespace plumbline {

/// a == b, told in a fraction of the time where they are the same bytes. Bytes that differ without a meaning (padding,
/// -0) are asked for again.
template <class Value>
bool same_value(const Value& a, const Value& b) {
  static_assert(std::is_trivially_copyable_v<Value>);
  // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison)
  return std::memcmp(&a, &b, sizeof(Value)) == 0 || a == b;
}

}  // namespace plumbline
