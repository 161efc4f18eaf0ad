#include "compensate/rewriter.hpp"

#include <catch2/catch.hpp>

#include "compensate/opened.hpp"

using namespace plumbline;

namespace {

// The program with every move that cuts sent `shift` away, at `points` places of equal distance.
std::string rewritten(const std::string& text, const AxisWords& shift, int points,
                      compensate::WrittenMove* last = nullptr) {
  const Opened opened(text, standing_at_zero());
  OutputFile out(opened.folder / "out");
  compensate::WrittenSteps steps(opened.dialect, opened.job.emit, nc::Form::in_text_order);
  compensate::Rewriter rewriter(opened.source, opened.dialect, opened.job.program, opened.job.emit, out, steps, true);
  compensate::MoveReader reader = reader_of(opened);
  while (const nc::Step* const step = reader.next()) {
    rewriter.begin(*step);
    if (step->motions.empty()) {
      rewriter.copy(*step, false);
    } else {
      compensate::CorrectedMove corrected;
      corrected.move = reader.move(*step, step->motions.front());
      corrected.standing = rewriter.standing(*step);
      for (int i = 1; i <= points; ++i) {
        corrected.points.push_back({corrected.move.path.curve.at(1.0 * i / points), shift, 1.0 / points});
        corrected.signs.emplace_back(machine::PerStrut<double>::Zero());
      }
      const compensate::WrittenMove& written = rewriter.write(corrected);
      if (last != nullptr) *last = written;
    }
    rewriter.end();
  }
  rewriter.finish();
  compensate::Summary summary;
  rewriter.describe(summary);
  CHECK(summary.identical == !rewriter.changed());
  CHECK(summary.read_back.has_value() == rewriter.changed());
  out.commit();
  return opened.folder.text("out");
}

const std::string kTwoCuts = "G21 G90 G94 G54\nG1 X4 F100\nG1 Y2\nM2\n";

}  // namespace

TEST_CASE("moves whose corrections round to nothing stay as they stand") {
  compensate::WrittenMove last;
  CHECK(rewritten(kTwoCuts, {{1e-6, 0, 0, 0, 0, 0}}, 1, &last) == kTwoCuts);
  CHECK_FALSE(last.changed);
  REQUIRE(last.pieces.size() == 1);
  CHECK(last.pieces.front().share == 1);
  CHECK(last.pieces.front().end == AxisWords{{4, 2, -1008, 0, 0, 0}});
}

TEST_CASE("a move is written through its points, and what the control keeps of them is handed on") {
  compensate::WrittenMove last;
  const std::string text = rewritten(kTwoCuts, {{0.01234567, 0, 0.5, 0, 0, 0}}, 2, &last);
  CHECK(text.find("X2.0123") != std::string::npos);
  CHECK(text.find("X4.0123") != std::string::npos);
  CHECK(text.find("Z0.5") != std::string::npos);
  CHECK(last.changed);
  CHECK(last.rounding_mm == Approx(0.00004567).epsilon(1e-3));
  REQUIRE(last.pieces.size() == 2);
  CHECK(last.pieces[0].share == Approx(0.5));
  CHECK(last.pieces[1].end[Axis::X] == Approx(4.0123));
  CHECK(last.pieces[1].wanted[Axis::X] == Approx(4.01234567));
  CHECK(last.begin[Axis::X] == Approx(4.0123));  // where the move before it left the control
  CHECK(last.begin[Axis::Z] == Approx(-1007.5));
}
