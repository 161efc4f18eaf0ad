// The interpreted motion of a program.
#pragma once

#include <functional>
#include <string>

#include "base/files/source.hpp"
#include "base/progress.hpp"
#include "nc/control/state/motion.hpp"
#include "settings/options.hpp"

namespace plumbline::jobs {

/// Hands over each motion that `program` makes, in order, in mm, deg and mm/min; what nobody gave is zero. Refuses what
/// open_program and nc::Program refuse.
void trace_file(const Source& program, const settings::Options& options,
                const std::function<void(const nc::Motion&)>& take, const Progress& progress = {});

}  // namespace plumbline::jobs
