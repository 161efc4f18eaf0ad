// That long records were made short, in one sentence.
#pragma once

#include <string>

#include "measure/thinning.hpp"

namespace plumbline::report {

/// A line with its end; empty: none was.
std::string thinning_text(const measure::Thinning& thinning);

}  // namespace plumbline::report
