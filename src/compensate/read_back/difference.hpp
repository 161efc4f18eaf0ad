// How what was read differs from what was meant, thrown by those who compare: who knows both lines says it.
#pragma once

#include <string>

namespace plumbline::compensate {

struct Difference {
  std::string what;  // "it waits 0.5 s, and 0.6 s were meant"
};

}  // namespace plumbline::compensate
