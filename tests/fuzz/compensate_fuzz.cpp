// Any bytes as a program, compensated for a machine: the output can be read again as a program, and the undo file
// brings the original back.
#include <cmath>

#include "compensate/stream.hpp"
#include "fuzz/programs.hpp"
#include "machine/model_file.hpp"
#include "nc/rewrite/output/undo.hpp"

using namespace plumbline;

namespace {

const machine::MachineModel& model() {
  static const machine::MachineModel read = machine::read_model(PLUMBLINE_SOURCE_DIR "/models/pm600-like.toml");
  return read;
}

constexpr int kMostMotions = 2000;

// A helix of a million turns or a hole of ten thousand pecks takes its time, and that is no finding.
bool is_short(const InputFile& source, const nc::Dialect& dialect) {
  bool is_short = true;
  int motions = 0;
  const bool whole = fuzz::is_taken([&] {
    nc::Program program(source, dialect, fuzz::everything_known());
    while (const nc::Step* step = is_short ? program.next() : nullptr) {
      motions += static_cast<int>(step->motions.size());
      is_short = motions < kMostMotions;
      for (const nc::Motion& motion : step->motions) {
        is_short = is_short && std::abs(motion.arc.turns) < 20;
        for (const Axis axis : kAllAxes) is_short = is_short && std::abs(motion.to[axis]) < 1e4;
      }
    }
  });
  return whole && is_short;
}

void check_restored(std::string_view text, const std::string& output, const std::string& undo) {
  const std::string back = fuzz::folder() / "back.ngc";
  {
    OutputFile out(back);
    nc::restore(InputFile(output), InputFile(undo), out);
    out.commit();
  }
  FUZZ_CHECK(read_text(back) == text);
}

void run(const InputFile& source, std::string_view text, const nc::Dialect& dialect) {
  if (!is_short(source, dialect)) return;
  const std::string output = fuzz::folder() / "out.ngc";
  const std::string undo = fuzz::folder() / "out.ngc.undo";
  const nc::ProgramSettings settings = fuzz::everything_known();
  compensate::Settings compensation;
  compensation.step.angle_deg = 2;  // coarse, for speed
  compensation.step.length_mm = 20;
  nc::EmitSettings emit;
  emit.stamp = {"plumbline 0 compensated this program"};
  const bool taken = fuzz::is_taken([&] {
    OutputFile out(output);
    OutputFile log_file(undo);
    nc::UndoLog log(log_file);
    const compensate::ProgramSurvey survey{dialect, nc::named_axes(source, dialect)};
    compensate::Stream stream(source, survey, settings, model(), compensation, emit, out);
    stream.record(log);
    out.keep_hash();
    stream.run();
    log.finish(source, out.size(), out.hash());
    log_file.commit();
    out.commit();
  });
  if (!taken) return;
  check_restored(text, output, undo);
  const InputFile again(output);
  nc::ProgramSettings settings_again = settings;
  settings_again.max_blocks = fuzz::kMostBlocks * 1000;
  nc::Program program(again, dialect, settings_again);
  while (program.next() != nullptr) continue;  // a refusal here is a finding: nobody catches it
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = fuzz::text_of(data, size);
  const InputFile source(fuzz::folder().file("program.ngc", text));
  for (const std::string_view name : nc::dialect_names()) run(source, text, nc::dialect(name));
  return 0;
}
