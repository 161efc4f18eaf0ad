#include "jobs/trace.hpp"

#include <utility>

#include "jobs/program/open_program.hpp"
#include "nc/sequence/program.hpp"

namespace plumbline::jobs {

void trace_file(const Source& program, const settings::Options& options,
                const std::function<void(const nc::Motion&)>& take, const Progress& progress) {
  OpenedProgram source = open_program(options, program);
  nc::Program steps(source.file, source.dialect, std::move(source.settings));
  std::uint64_t count = 0;
  while (const nc::Step* const step = steps.next()) {
    for (const nc::Motion& motion : step->motions) take(motion);
    if (progress && ++count % kProgressEvery == 0) progress(step->block->offset, source.file.size());
  }
}

}  // namespace plumbline::jobs
