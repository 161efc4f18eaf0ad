#include "nc/rewrite/output/emit_codes.hpp"

#include <string>

#include <catch2/catch.hpp>

#include "nc/syntax/parsed.hpp"

using namespace plumbline;
using namespace plumbline::nc;
using nc::tests::Parsed;

namespace {

// The text of a word that codes_of found.
std::string text_of_word(const Parsed& parsed, const Word* word) {
  return word == nullptr ? "none" : parsed.at(word->span);
}

}  // namespace

TEST_CASE("what a control is told has the code of its table, or none") {
  const CodeWriter linuxcnc(dialect("linuxcnc"));
  CHECK(linuxcnc.motion(MotionMode::rapid) == "G0");
  CHECK(linuxcnc.motion(MotionMode::arc_ccw) == "G3");
  CHECK(linuxcnc.motion(MotionMode::none) == "G80");
  CHECK(linuxcnc.feed_mode(FeedMode::inverse_time) == "G93");
  CHECK(linuxcnc.feed_mode(FeedMode::per_revolution) == "G95");
  CHECK(linuxcnc.path_control(PathControl::exact_path) == "G61");
  CHECK(linuxcnc.path_control(PathControl::exact_stop) == "G61.1");
  CHECK(linuxcnc.path_control(PathControl::continuous) == "G64");
  CHECK(linuxcnc.distance(true) == "G91");
  CHECK(linuxcnc.distance(false) == "G90");
  CHECK(linuxcnc.cycle(83) == "G83");
  CHECK(linuxcnc.text_of("spindle", kCounterClockwise) == "M4");
  CHECK(linuxcnc.text_of("coolant", kFlood) == "M8");
  CHECK(linuxcnc.text_of("coolant", 77).empty());
  CHECK(linuxcnc.text_of("no meaning").empty());
}

TEST_CASE("a control that knows no exact path has its pieces written under continuous motion") {
  const CodeWriter fanuc(dialect("fanuc"));
  CHECK(fanuc.path_control(PathControl::exact_path) == "G64");
  CHECK(fanuc.path_control(PathControl::exact_stop) == "G61");
}

TEST_CASE("the seconds of a dwell stand after the letter of the dialect") {
  CHECK(CodeWriter(dialect("linuxcnc")).dwell_letter() == 'P');
  CHECK(CodeWriter(dialect("fanuc")).dwell_letter() == 'P');
  CHECK(CodeWriter(dialect("siemens")).dwell_letter() == 'F');
  CHECK(CodeWriter(dialect("okuma")).dwell_letter() == 'F');
  CHECK(CodeWriter(dialect("siemens")).dwell() == "G4");
}

TEST_CASE("the codes of a block are found by what they do") {
  const CodeWriter writer(dialect("linuxcnc"));
  const Parsed block("G1 G93 G64 X1 F5 M8 M2");
  const BlockCodes codes = writer.codes_of(block.block);
  CHECK(text_of_word(block, codes.motion) == "G1");
  CHECK(text_of_word(block, codes.feed_mode) == "G93");
  CHECK(text_of_word(block, codes.path_control) == "G64");
  CHECK(text_of_word(block, codes.feed) == "F5");
  CHECK(codes.axis_taker == nullptr);
  REQUIRE(codes.after_motion().size() == 1);
  CHECK(text_of_word(block, codes.after_motion().front()) == "M2");
  const Parsed none("X1 Y2");
  CHECK(writer.codes_of(none.block).motion == nullptr);
  CHECK(writer.codes_of(none.block).after_motion().empty());
}

TEST_CASE("G80 gives way to another motion of its block, and a tool length takes axis words") {
  const CodeWriter writer(dialect("linuxcnc"));
  for (const char* const line : {"G80 G3 X1", "G3 G80 X1"}) {
    const Parsed block(line);
    CHECK(text_of_word(block, writer.codes_of(block.block).motion) == "G3");
  }
  const Parsed length("G43.1 Z5 G0");
  CHECK(text_of_word(length, writer.codes_of(length.block).axis_taker) == "G43.1");
  CHECK(text_of_word(length, writer.codes_of(length.block).motion) == "G0");
}

TEST_CASE("the F of a dwell is a time") {
  const Parsed dwell("G4 F2", "siemens");
  CHECK(CodeWriter(dialect("siemens")).codes_of(dwell.block).feed == nullptr);
  const Parsed move("G1 X2 F2", "siemens");
  CHECK(text_of_word(move, CodeWriter(dialect("siemens")).codes_of(move.block).feed) == "F2");
}

TEST_CASE("words belong to the code of the block that takes their letter") {
  const CodeWriter writer(dialect("linuxcnc"));
  CHECK(writer.other_code_takes(Parsed("G4 P1 X2").block, 'P'));
  CHECK_FALSE(writer.other_code_takes(Parsed("G82 X2 P1").block, 'P'));
  CHECK_FALSE(writer.other_code_takes(Parsed("G4 P1 X2").block, 'Q'));
  CHECK(writer.is_motion(Parsed("G81 X1").block.words.front()));
  CHECK_FALSE(writer.is_motion(Parsed("G17 X1").block.words.front()));
  CHECK_FALSE(writer.is_motion(Parsed("M3").block.words.front()));
}

TEST_CASE("codes that are names are known by what they do") {
  const CodeWriter writer(dialect("siemens"));
  CHECK(writer.name_of(Action::modal_call) == "MCALL");
  CHECK(CodeWriter(dialect("linuxcnc")).name_of(Action::modal_call).empty());
  CHECK(writer.is_call(Parsed("CYCLE81(10,0,2,-15)", "siemens").block.words.front()));
  CHECK_FALSE(writer.is_call(Parsed("G0 X1", "siemens").block.words.front()));
}
