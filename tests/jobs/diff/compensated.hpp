// Programs of a test, compensated and compared.
#pragma once

#include <string>

#include "jobs/compensate/compensate_file.hpp"
#include "jobs/diff/diff.hpp"
#include "settings/options.hpp"
#include "support/scratch.hpp"

namespace plumbline::testing {

inline jobs::DiffSummary diff_of(const std::string& a, const std::string& b, const settings::Options& options = {}) {
  const Scratch scratch;
  return jobs::diff_files(scratch.file("a.ngc", a), scratch.file("b.ngc", b), options);
}

/// Each move of the one has found its own in the other.
inline bool is_whole(const jobs::DiffSummary& s) {
  return s.out_of_line_a == 0 && s.out_of_line_b == 0 && s.matched == s.moves_a;
}

inline std::string compensated(const Scratch& scratch, const std::string& program, double step_mm = 1,
                               double step_deg = 0.1, double time_tolerance = 1e-3) {
  settings::Options options;
  options.paths.model = source_file("models/pm600-like.toml");
  options.program.work_offsets[0] = nc::WorkOffset{{{0, 0, -1008, 0, 0, 0}}, 0};
  options.compensation.step.length_mm = step_mm;
  options.compensation.step.angle_deg = step_deg;
  options.emit.time_tolerance = time_tolerance;
  jobs::compensate_file(scratch.file("in.ngc", program), scratch.path("out.ngc"), options);
  return scratch.text("out.ngc");
}

}  // namespace plumbline::testing
