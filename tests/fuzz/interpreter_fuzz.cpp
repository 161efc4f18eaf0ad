// Any bytes as a program, executed under each dialect: as trace does, and as compensate does with all or nothing known.
#include <cmath>

#include "fuzz/programs.hpp"

using namespace plumbline;

namespace {

void check_motion(const nc::Motion& motion) {
  for (const Axis axis : kAllAxes) {
    FUZZ_CHECK(!motion.known_after.contains(axis) || std::isfinite(motion.to[axis]));
    FUZZ_CHECK(!motion.known_before.contains(axis) || std::isfinite(motion.from[axis]));
  }
  FUZZ_CHECK(std::isfinite(motion.feed) && motion.feed >= 0);
  FUZZ_CHECK(std::isfinite(motion.dwell_s) && motion.dwell_s >= 0);
  FUZZ_CHECK(motion.kind != nc::MotionKind::arc || motion.arc.turns != 0);
}

// As long as nothing jumped, the texts of the blocks are the file; if it is refused, a first part of it.
void run(const InputFile& file, std::string_view text, const nc::Dialect& dialect, nc::ProgramSettings settings) {
  std::string blocks;
  bool jumped = false;
  const bool whole = fuzz::is_taken([&] {
    nc::Program program(file, dialect, std::move(settings));
    while (const nc::Step* step = program.next()) {
      jumped = jumped || program.jumped() || step->flow;
      if (!jumped) {
        blocks += step->block->text;
        blocks += step->block->line_end;
      }
      for (const nc::Motion& motion : step->motions) check_motion(motion);
    }
  });
  FUZZ_CHECK(text.starts_with(blocks));
  FUZZ_CHECK(jumped || !whole || blocks.size() == text.size());
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = fuzz::text_of(data, size);
  const InputFile file(fuzz::folder().file("program.ngc", text));
  for (const std::string_view name : nc::dialect_names()) {
    const nc::Dialect& dialect = nc::dialect(name);
    run(file, text, dialect, fuzz::empty_tables());
    run(file, text, dialect, fuzz::everything_known());
    run(file, text, dialect, fuzz::nothing_known());
  }
  return 0;
}
