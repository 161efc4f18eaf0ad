#include "report/measured/thinning_text.hpp"

#include <fmt/format.h>

namespace plumbline::report {

std::string thinning_text(const measure::Thinning& thinning) {
  if (thinning.thinned == 0) return {};
  return fmt::format(
      "{} of {} runs have up to {} samples: means of up to {} consecutive ones were used, and the noise stated is that "
      "of these means\n",
      thinning.thinned, thinning.runs, thinning.longest, thinning.largest);
}

}  // namespace plumbline::report
