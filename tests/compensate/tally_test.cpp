#include "compensate/tally.hpp"

#include <algorithm>

#include <catch2/catch.hpp>

#include "compensate/opened.hpp"

using namespace plumbline;

namespace {

// What is said of a program whose moves were written in `pieces` equal pieces, a millimetre above where they were.
compensate::Summary tallied(const std::string& text, const Job& job, int pieces = 1) {
  const Opened opened(text, job);
  compensate::MoveReader reader = reader_of(opened);
  const compensate::Corrector corrector(opened.job.model, opened.job.settings);
  compensate::Tally tally(opened.source, opened.dialect, opened.job.model, opened.job.settings, corrector);
  while (const nc::Step* const step = reader.next()) {
    tally.take_block(*step);
    for (const nc::Motion& motion : step->motions) {
      if (motion.kind == nc::MotionKind::dwell) {
        tally.take_dwell(motion);
        continue;
      }
      compensate::CorrectedMove corrected;
      corrected.move = reader.move(*step, motion);
      corrected.points.push_back({motion.to, {{0, 0, 1, 0, 0.5, 0}}, 1});
      compensate::WrittenMove written;
      written.changed = true;
      written.rounding_mm = 1e-4;
      for (int i = 0; i < pieces; ++i)
        written.pieces.push_back({{}, {}, 1.0 / pieces, machine::PerStrut<double>::Zero()});
      if (corrected.move.is_rapid()) {
        tally.take_rapid(corrected, written);
      } else {
        written.seconds = *corrected.move.seconds * 1.01;
        tally.take_cut(corrected, written);
      }
    }
  }
  return tally.summary();
}

bool warns(const compensate::Summary& summary, std::string_view code) { return warnings_of(summary, code) > 0; }

}  // namespace

TEST_CASE("moves, times and corrections are counted with the line of the worst") {
  const compensate::Summary summary = tallied("G21 G90 G94\nG0 X1\nG1 X7 F360\nG4 P2\nM2\n", standing_at_zero());
  CHECK(summary.blocks == 5);
  CHECK(summary.moves == 2);
  CHECK(summary.changed_blocks == 2);
  CHECK(summary.points == 2);
  CHECK(summary.seconds_before == Approx(3));
  CHECK(summary.seconds_after == Approx(3.01));
  CHECK(summary.time_change.value == Approx(0.01));
  CHECK(summary.time_change.line == 3);
  CHECK(summary.correction_mm.value == Approx(1));
  CHECK(summary.correction_mm.line == 2);
  CHECK(summary.correction_deg.value == Approx(0.5));
  CHECK(summary.rms_correction_mm == Approx(1));
  CHECK(summary.rounding_mm.value == Approx(1e-4));
  CHECK(summary.zero_error_line == 3);
  CHECK_FALSE(warns(summary, "compensate-no-end"));
}

TEST_CASE("a program that ends without M2 or M30 is warned of") {
  CHECK(warns(tallied("G21 G90\nG0 X1\n", standing_at_zero()), "compensate-no-end"));
  CHECK_FALSE(warns(tallied("%\nG21 G90\nG0 X1\n%\n", standing_at_zero()), "compensate-no-end"));
}

TEST_CASE("pieces that a control may not read fast enough are counted") {
  const std::string text = "G21 G90 G94\nG1 X6 F36000\nM2\n";  // 10 ms
  CHECK_FALSE(warns(tallied(text, standing_at_zero(), 10), "compensate-short-pieces"));
  const compensate::Summary summary = tallied(text, standing_at_zero(), 40);
  CHECK(summary.short_pieces.below_1_ms == 40);
  CHECK(summary.short_pieces.least_s == Approx(0.25e-3));
  CHECK(summary.short_pieces.line == 2);
  CHECK(warns(summary, "compensate-short-pieces"));
  Job slow = standing_at_zero();
  slow.settings.step.least_time_s = 0.1;  // a block time that the model states
  CHECK(tallied(text, slow, 10).short_pieces.below_block_time == 10);
  CHECK(warns(tallied(text, slow, 10), "compensate-short-pieces"));
}

TEST_CASE("a length below zero is told once") {
  Job job = standing_at_zero();
  job.program.tools = nc::ToolTable({{.number = 1, .length_mm = -20}, {.number = 2, .length_mm = 20}});
  const auto told = [&](const std::string& text) {
    return warnings_of(tallied("G21 G90 G94\n" + text + "M2\n", job), "compensate-tool-length");
  };
  CHECK(told("G43 H1\nG0 X1 Z3\nG1 X2 F100\nG43 H2\nG0 X5 Z3\nG43 H1\nG0 Z3\n") == 1);
  CHECK(told("G43.1 Z-5\nG0 X1 Z3\n") == 1);
  CHECK(told("G43 H2 G0 Z5\nG43.2 H1\nG43.2 H1\nG0 Z3\n") == 1);
  CHECK(told("G43 H1\nG49\nG0 X1\n") == 0);  // no move was made with it
  CHECK(told("G43 H2\nG0 X1 Z3\n") == 0);
}
