#include "compensate/hole_corrector.hpp"

#include <catch2/catch.hpp>

#include "compensate/opened.hpp"
#include "compensate/written_steps.hpp"

using namespace plumbline;

namespace {

const std::string kTapped = "G21 G90 G94 G98\nG0 X0 Y0 Z20 A0 B0 C0\nS200 M3\nG84 X10 Y5 Z-12 R2 F100\nG80\nM2\n";

// The hole of the one cycle of the program, corrected and checked.
struct Hole {
  explicit Hole(const std::string& text, const Job& job)
      : opened(text, job),
        reader(reader_of(opened)),
        corrector(opened.job.model, opened.job.settings),
        moves(corrector, opened.job.model.limits, compensate::MoveCorrector::AtViolation::stop),
        holes(opened.dialect, corrector, opened.job.model.limits, opened.job.settings, moves),
        steps(opened.dialect, opened.job.emit, nc::Form::in_text_order) {
    const nc::Step* step = reader.next();
    while (step->cycle == nc::CycleForm::none) step = reader.next();
    holes.begin(*step);
    for (const nc::Step* const part : steps.of_cycle(*step)) {
      if (part->cycle == nc::CycleForm::none) continue;
      const compensate::Move down = reader.move(*part, compensate::HoleCorrector::way_down(*part));
      corrected = holes.correct(down, part->holes.front(), {});
      holes.check(corrected);
    }
  }

  Opened opened;
  compensate::MoveReader reader;
  compensate::Corrector corrector;
  compensate::MoveCorrector moves;
  compensate::HoleCorrector holes;
  compensate::WrittenSteps steps;
  compensate::CorrectedHole corrected;
};

}  // namespace

TEST_CASE("a hole is shifted by the mean of the corrections from R to its bottom") {
  const Hole hole(kTapped, standing_at_zero());
  REQUIRE(hole.corrected.at != nullptr);
  const auto& points = hole.corrected.at->points;
  REQUIRE(points.size() == 15);  // 14 mm, every millimetre
  CHECK(points.front().nominal == AxisWords{{10, 5, 2, 0, 0, 0}});
  CHECK(points.back().nominal == AxisWords{{10, 5, -12, 0, 0, 0}});
  double sum = 0;
  for (const nc::CorrectedPoint& point : points) sum += point.shift[Axis::Z];
  CHECK(hole.corrected.shift[Axis::Z] == Approx(sum / 15));
  CHECK(std::abs(hole.corrected.shift[Axis::Z]) > 1e-3);
}

TEST_CASE("the tool goes down and up, so the hole is corrected without friction") {
  Job without = standing_at_zero();
  without.settings.friction = false;
  CHECK(Hole(kTapped, standing_at_zero()).corrected.shift == Hole(kTapped, without).corrected.shift);
}

TEST_CASE("a hole along which the correction varies too much is refused") {
  Job job = standing_at_zero();
  job.settings.cycle_tolerance_mm = 1e-7;
  const Diagnostic refused = testing::refusal_of([&] { const Hole hole(kTapped, job); });
  CHECK(refused.code == "compensate-cycle");
  CHECK(refused.place.line == 4);
  CHECK(refused.message.find("varies") != std::string::npos);
}
