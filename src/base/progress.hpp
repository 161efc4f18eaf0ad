// How far a long piece of work has come: the libraries report, the command line decides whether to show it.
#pragma once

#include <cstdint>
#include <functional>

namespace plumbline {

/// Called now and then with the work done and the whole of it, in the same unit (bytes read, runs fitted).
using Progress = std::function<void(std::uint64_t done, std::uint64_t total)>;

inline constexpr std::uint64_t kProgressEvery = 4096;  // blocks or points between two calls

}  // namespace plumbline
