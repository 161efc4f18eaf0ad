// How far a piece of work has come, in one line.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace plumbline::report {

/// "compensate  [########----------------]  33 %, 12 s left", at most `columns` wide; narrower terminals get less of
/// it. `seconds`: since the work began. What is left is said from the third second on. `total` is not 0; what is done
/// beyond it counts as all.
std::string progress_text(std::string_view work, std::uint64_t done, std::uint64_t total, double seconds,
                          std::size_t columns);

/// "9 s", "2 min 5 s", "1 h 4 min"
std::string wait_text(double seconds);

}  // namespace plumbline::report
