#include "report/measured/thinning_text.hpp"

#include <fmt/format.h>

#include "report/text_table.hpp"

namespace plumbline::report {

std::string thinning_text(const measure::Thinning& thinning) {
  if (thinning.thinned == 0) return {};
  return fmt::format(
      "{} of {} {} up to {} samples: each channel was low-passed and brought to {} points of a turn, and the noise "
      "stated is that of these points\n",
      thinning.thinned, count_text(thinning.runs, "run"), thinning.thinned == 1 ? "has" : "have", thinning.longest,
      thinning.points);
}

}  // namespace plumbline::report
