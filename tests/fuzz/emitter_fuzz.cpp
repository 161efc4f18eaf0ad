// Any bytes as a program: written again without corrections it is itself, byte for byte. With corrections drawn from
// its own bytes it can be read again, every move ends where its correction says, and the undo file brings the original
// back.
#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "base/text/hash.hpp"
#include "fuzz/programs.hpp"
#include "nc/rewrite/emit.hpp"
#include "nc/rewrite/output/undo.hpp"
#include "path/curve.hpp"
#include "path/duration.hpp"

using namespace plumbline;

namespace {

constexpr double kReachMm = 1e5;       // beyond it a program is none for a machine, and digits run out
constexpr double kToleranceMm = 3e-3;  // digits of the output, drift of many blocks in inches

// Corrections that no model could give: any direction, steps from point to point.
class Draw {
 public:
  explicit Draw(std::string_view text) : random_(fnv1a(text)) {}
  int pieces() { return std::uniform_int_distribution<int>(1, 4)(random_); }
  AxisWords shift() {
    AxisWords shift;
    if (random_() % 4 == 0) return shift;
    for (const Axis axis : kAllAxes) {
      if (random_() % 2 == 0) shift[axis] = std::uniform_real_distribution<double>(-0.05, 0.05)(random_);
    }
    return shift;
  }

 private:
  std::mt19937_64 random_;
};

bool is_rewritable(const nc::Step& step) {
  if (step.role != nc::BlockRole::plain || step.motions.size() != 1 || step.end_words == nc::EndWords::polar)
    return false;
  const nc::Motion& motion = step.motions.front();
  if (motion.in_machine_coordinates || motion.kind == nc::MotionKind::dwell || motion.kind == nc::MotionKind::probe) {
    return false;
  }
  return motion.known_after == AxisSet::all() && motion.known_before == AxisSet::all();
}

bool is_within_reach(const nc::Step& step) {
  return std::all_of(step.motions.begin(), step.motions.end(), [](const nc::Motion& m) {
    return std::all_of(kAllAxes.begin(), kAllAxes.end(),
                       [&](Axis axis) { return std::abs(m.to[axis]) < kReachMm && std::abs(m.from[axis]) < kReachMm; });
  });
}

// Refused before it comes to the emitter: nobody knows how a cutting move begins whose axes are not all known.
bool cuts_blindly(const nc::Step& step) {
  return std::any_of(step.motions.begin(), step.motions.end(), [](const nc::Motion& m) {
    const bool cuts = m.kind == nc::MotionKind::feed || m.kind == nc::MotionKind::arc;
    return cuts && (m.known_before != AxisSet::all() || m.known_after != AxisSet::all());
  });
}

struct Rewritten {
  bool whole = false;           // the program was neither refused nor beyond what is rewritten
  std::vector<AxisWords> ends;  // where the moves of the output should end, in W
};

// With `draw` corrected, else copied.
Rewritten rewrite(const InputFile& source, const nc::Dialect& dialect, Draw* draw, OutputFile& out, OutputFile& undo) {
  Rewritten rewritten;
  nc::EmitSettings settings;
  settings.stamp = {"a stamp"};
  rewritten.whole = fuzz::is_taken([&] {
    nc::Program program(source, dialect, fuzz::everything_known());
    nc::Emitter emitter(source, dialect, settings, out);
    nc::UndoLog log(undo);
    emitter.record(log);
    out.keep_hash();
    while (const nc::Step* step = program.next()) {
      if ((draw != nullptr && (step->motions.size() > 1 || cuts_blindly(*step))) || step->flow || program.jumped() ||
          program.position_read() || step->role == nc::BlockRole::cycle || step->end_words == nc::EndWords::polar ||
          !is_within_reach(*step)) {
        refuse("fuzz", "not rewritten", "none");
      }
      if (draw == nullptr || !is_rewritable(*step)) {
        emitter.copy(*step);
        continue;
      }
      const nc::Motion& motion = step->motions.front();
      const bool cuts = motion.kind != nc::MotionKind::rapid;
      const path::Curve curve(motion);
      const std::optional<double> seconds = path::duration(motion, curve, dialect);
      const int count = cuts ? draw->pieces() : 1;
      std::vector<nc::CorrectedPoint> points;
      for (int i = 1; i <= count; ++i) {
        points.push_back({curve.at(static_cast<double>(i) / count), draw->shift(), 1.0 / count});
      }
      const nc::EmittedMove emitted = emitter.move(*step, points, AxisSet::all(), cuts ? seconds : std::nullopt);
      FUZZ_CHECK(emitted.pieces >= 1 && emitted.pieces <= count);
      FUZZ_CHECK(std::isfinite(emitted.rounding_mm));
      rewritten.ends.push_back(step->frame->to_pose(points.back().nominal + points.back().shift));
    }
    emitter.finish();
    log.finish(source, out.size(), out.hash());
    out.commit();
    undo.commit();
  });
  return rewritten;
}

// The ends of the output's moves, in order, hold those that were asked for, in order.
void check_ends(const std::string& path, const nc::Dialect& dialect, const std::vector<AxisWords>& ends) {
  const InputFile source(path);
  nc::Program program(source, dialect, fuzz::everything_known());
  std::size_t next = 0;
  while (const nc::Step* step = program.next()) {
    if (next >= ends.size() || !is_rewritable(*step)) continue;
    const AxisWords off = step->frame->to_pose(step->motions.front().to) - ends[next];
    const bool there =
        std::all_of(kAllAxes.begin(), kAllAxes.end(), [&](Axis axis) { return std::abs(off[axis]) < kToleranceMm; });
    if (there) ++next;
  }
  if (next < ends.size()) {
    const AxisWords& p = ends[next];
    std::fprintf(stderr, "move %zu of %zu should end at %.6f %.6f %.6f %.6f %.6f %.6f in W; the output:\n%s\n",
                 next + 1, ends.size(), p[Axis::X], p[Axis::Y], p[Axis::Z], p[Axis::A], p[Axis::B], p[Axis::C],
                 read_text(path).c_str());
  }
  FUZZ_CHECK(next == ends.size());
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
  const std::string output = fuzz::folder() / "out.ngc";
  const std::string undo = fuzz::folder() / "out.ngc.undo";
  {
    OutputFile out(output);
    OutputFile log(undo);
    if (!rewrite(source, dialect, nullptr, out, log).whole) return;
  }
  FUZZ_CHECK(read_text(output) == text);
  check_restored(text, output, undo);
  Draw draw(text);
  Rewritten rewritten;
  {
    OutputFile out(output);
    OutputFile log(undo);
    rewritten = rewrite(source, dialect, &draw, out, log);
  }
  if (!rewritten.whole) return;
  check_restored(text, output, undo);
  check_ends(output, dialect, rewritten.ends);
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = fuzz::text_of(data, size);
  const InputFile source(fuzz::folder().file("program.ngc", text));
  for (const std::string_view name : nc::dialect_names()) run(source, text, nc::dialect(name));
  return 0;
}
