#include "compensate/played/output_play.hpp"

#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "compensate/move_corrector.hpp"
#include "compensate/opened.hpp"

using namespace plumbline;
using compensate::CorrectedMove;
using compensate::MoveCorrector;
using compensate::SentPiece;

namespace {

std::vector<SentPiece> pieces_of(const CorrectedMove& corrected) {
  std::vector<SentPiece> pieces;
  for (std::size_t i = 0; i < corrected.points.size(); ++i) {
    const AxisWords end = corrected.commanded(i);
    pieces.push_back({end, end, corrected.points[i].share, corrected.signs[i]});
  }
  return pieces;
}

}  // namespace

// At once nothing is foreseen (FirstLooks).
TEST_CASE("what is played on a thread of its own is what is played at once") {
  std::string text = "G21 G90 G94\nG0 X0 Y0 Z0\n";
  for (int i = 0; i < 900; ++i) {
    const double size = i < 400 ? 1 : 0.4;  // blocks of several pieces, and of one
    text += fmt::format("G1 X{} Y{} A{} F{}\n", size * (i % 50), size * (i % 7), 0.2 * size * (i % 30),
                        i % 9 == 0 ? 200 : 2000);
    if (i % 101 == 0) text += "G0 Z1\n";
  }
  const Opened opened(text + "M2\n", standing_at_zero());
  compensate::MoveReader reader = reader_of(opened);
  compensate::Corrector corrector(opened.job.model, opened.job.settings);
  MoveCorrector moves(corrector, opened.job.model.limits, MoveCorrector::AtViolation::go_on);
  compensate::BetweenPoints at_once(corrector);
  compensate::OutputPlay aside(opened.job.model, opened.job.settings);
  AxisWords begin;
  int count = -1;
  while (const compensate::Move* const move = reader.next_move()) {
    ++count;
    const compensate::ToolInSpindle tool{0, 5.0 * (count % 3), 0.1};
    if (count % 250 == 0) {
      at_once.leave();
      corrector.set_tool(tool);
      aside.set_tool(tool);
    }
    const CorrectedMove& corrected = moves.correct(*move, {});
    REQUIRE_FALSE(corrected.points.empty());
    const std::vector<SentPiece> pieces = pieces_of(corrected);
    if (move->is_rapid()) {
      at_once.rapid(corrected.signs.back());
      aside.rapid(corrected.signs.back());
    } else {
      const compensate::SentMove sent{&move->path, move->seconds, begin, pieces, false};
      at_once.cut(sent);
      aside.cut(sent);
    }
    begin = pieces.back().end;
  }
  at_once.leave();
  const compensate::BetweenPoints& played = aside.finish();
  CHECK(at_once.plays() > 1000);
  CHECK(played.plays() == at_once.plays());
  CHECK(played.tip_mm().value == at_once.tip_mm().value);
  CHECK(played.tip_mm().line == at_once.tip_mm().line);
  CHECK(played.turned_deg().value == at_once.turned_deg().value);
  CHECK(played.turned_deg().line == at_once.turned_deg().line);
}
