// Holds what the blocks of an output do besides moving against what was meant, and in which order.
#pragma once

#include <cstddef>
#include <string>

#include "compensate/read_back/intended.hpp"
#include "nc/language/block.hpp"

namespace plumbline::compensate {

class EffectCheck {
 public:
  explicit EffectCheck(bool unrolled) : unrolled_(unrolled) {}

  /// Both must stay until end().
  void begin(const IntendedBatch& batch, const IntendedBlock& block);
  /// An effect of a block of the output. True: it is the next one of the original, and no comment. Throws Difference
  /// where it is neither the next one nor what the rewriting adds.
  bool take(const BlockEffect& effect, const nc::Block& of_output);
  /// Throws Difference if one is missing.
  void end() const;

 private:
  bool is_ours(const BlockEffect& effect, const nc::Block& of_output) const;

  bool unrolled_;
  const IntendedBatch* batch_ = nullptr;
  const IntendedBlock* block_ = nullptr;
  std::size_t next_ = 0, last_ = 0;
};

/// Nothing stands in it but comments.
bool is_bare(const nc::Block& block);

}  // namespace plumbline::compensate
