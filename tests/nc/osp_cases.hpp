// Programs for an OSP, case by case: where each is refused, or that it is read.
#pragma once

#include <cstddef>
#include <vector>

namespace plumbline::nc::tests {

struct OspCase {
  const char* program;
  std::size_t line, column;  // 0: it is read
  const char* code = "nc-not-interpreted";
  const char* part = "";  // of the message, or of its help
};

/// G15 H1 and H2 (10 mm along X from it, 5 mm up) are known, and tools 1 and 3, 100 mm and 80 mm long.
void check_osp(const std::vector<OspCase>& cases);

}  // namespace plumbline::nc::tests
