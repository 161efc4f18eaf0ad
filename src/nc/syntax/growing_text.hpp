// A program that is read while it is written.
#pragma once

#include <cstdint>

namespace plumbline::nc {

/// What an InputFile may be besides: a text that grows by whole blocks, in which reading on waits for the next of them.
class GrowingText {
 public:
  virtual ~GrowingText() = default;
  /// True where the text ends at `offset` so far: a block ends there as well, so that whether a line goes on is known
  /// without waiting for the next one.
  virtual bool ends_block(std::uint64_t offset) const = 0;
};

}  // namespace plumbline::nc
