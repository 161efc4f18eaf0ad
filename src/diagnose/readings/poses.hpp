// Which runs were made at one pose: centre and tilt alike.
#pragma once

#include "identify/plausible.hpp"

namespace plumbline::diagnose {

using identify::poses_of;

}  // namespace plumbline::diagnose
