// Blocks of languages in which words, values and codes may be names: X=LENGTH, TRAORI, R1=5.
#pragma once

#include "nc/syntax/reading/block_reading.hpp"

namespace plumbline::nc {

class NamedGrammar {
 public:
  /// Reads the whole line: block = [ percent ] , [ "/" , [ digit ] ] , [ label ] , ( program name | items ).
  void read(BlockReading& in);

 private:
  bool draws(const BlockReading& in);
  bool drawing_ = false;  // between DEF WORK and END
};

}  // namespace plumbline::nc
