// Also named_words.cpp, named_calls.cpp, named_statements.cpp and named_values.cpp: the items of its lines.
#include "nc/syntax/named/named_grammar.hpp"

#include <catch2/catch.hpp>

#include "base/diagnostic.hpp"
#include "nc/syntax/parsed.hpp"

using namespace plumbline;
using namespace plumbline::nc;
using nc::tests::Parsed;

namespace {

Parsed siemens(const char* line) { return Parsed(line, "siemens"); }
Parsed okuma(const char* line) { return Parsed(line, "okuma"); }

}  // namespace

TEST_CASE("words have values that are names, modes and numbers") {
  const Parsed p = siemens("N10 START: G1 X=LENGTH*2 Y=IC(5) F10 CR=2.50 Z1=0");
  REQUIRE(p.block.words.size() == 6);
  CHECK(p.at(p.block.number) == "N10");
  CHECK(p.at(p.block.names.front()) == "START");
  CHECK(p.at(p.block.words[1].span) == "X=LENGTH*2");
  CHECK(p.block.words[2].mode == WordMode::incremental);
  CHECK(p.block.words[3].expression == kLiteral);
  CHECK(p.block.words[4].letter == 'R');
  CHECK(p.block.words[4].decimals == 2);
  CHECK(p.block.words[5].use == WordUse::machine_axis);
  CHECK_THROWS_AS(siemens("X=IC 5"), Refusal);
}

TEST_CASE("a blank ends a number") {
  CHECK(siemens("X 15").block.words.front().value == 15);
  CHECK(siemens("X - 1.5").block.words.front().value == -1.5);
  for (const char* text : {"X1 5", "X1. 5", "X1 .5", "X=1 5", "X=1 .5", "R1=1 0", "G0 1 X1"}) {
    INFO(text);
    CHECK_THROWS_AS(siemens(text), Refusal);
  }
}

TEST_CASE("variables with numbers are parameters, others have names") {
  const Parsed p = siemens("R1=2 R[3]=4 DEPTH=5");
  REQUIRE(p.block.settings.size() == 3);
  CHECK(p.block.settings[0].target != kLiteral);
  CHECK(p.block.settings[1].target != kLiteral);
  CHECK(p.block.settings[2].target == kLiteral);
  CHECK_THROWS_AS(siemens("R1"), Refusal);
  CHECK_THROWS_AS(siemens("FIELD[1]=2"), Refusal);
  CHECK_THROWS_AS(okuma("VC999=1"), Refusal);
}

TEST_CASE("relations bind weaker than AND in the 840D, which few mean; brackets are needed as on other controls") {
  const auto last = [](const Parsed& p) { return p.block.code[p.block.code.size() - 2].operation; };
  CHECK_THROWS_AS(siemens("IF R1 AND R2 == 3 GOTOF ENDE"), Refusal);
  CHECK_THROWS_AS(siemens("IF R1 == 3 OR R2 GOTOF ENDE"), Refusal);
  CHECK_THROWS_AS(siemens("IF (R1 == 3) AND R2 > 3 GOTOF ENDE"), Refusal);
  CHECK(last(siemens("IF (R1 == 3) AND (R2 == 3) GOTOF ENDE")) == Operation::logical_and);
  CHECK(last(siemens("IF (R1 AND R2) == (R3 OR R4) GOTOF ENDE")) == Operation::equal);
  CHECK(last(siemens("IF R1 AND R2 OR R3 GOTOF ENDE")) == Operation::logical_or);
  CHECK_THROWS_AS(okuma("IF [VC1 EQ 1 AND VC2 EQ 2] N10"), Refusal);
  CHECK(last(okuma("IF [[VC1 EQ 1] AND [VC2 EQ 2]] N10")) == Operation::logical_and);
}

TEST_CASE("programs are called by a statement, or by their names") {
  const Parsed call = okuma("CALL O1000 Q3 PX=10");
  CHECK(call.at(call.block.flow.name) == "O1000");
  CHECK(call.block.flow.count != kLiteral);
  CHECK(call.block.settings.size() == 1);
  const Parsed by_name = siemens("POCKET(1, R2) P3 ; deep");
  CHECK(by_name.block.flow.word == FlowWord::call);
  CHECK(by_name.block.flow.values.size() == 2);
  CHECK(by_name.block.flow.count != kLiteral);
  CHECK(siemens("L10").block.flow.word == FlowWord::call);
  CHECK_THROWS_AS(siemens("G1 POCKET"), Refusal);
  const Parsed path = siemens("EXTCALL(\"/user/POCKET.SPF\")");
  CHECK(path.at(path.block.flow.name) == "POCKET");
  const Parsed head = siemens("PROC POCKET(REAL DEPTH, INT COUNT) DISPLOF");
  CHECK(head.block.settings.size() == 2);
  CHECK(head.block.settings[1].type == VariableType::whole);
  CHECK_THROWS_AS(siemens("PROC POCKET SAVE"), Refusal);
}

TEST_CASE("statements steer the program") {
  CHECK(siemens("IF R1 > 3").block.flow.word == FlowWord::begin_if);
  const Parsed jump = siemens("IF R1 > 3 GOTOB N100");
  CHECK(jump.block.flow.direction == Direction::backward);
  CHECK(jump.at(jump.block.flow.name) == "N100");
  CHECK(okuma("IF [VC1 GT 3] NEND").block.flow.word == FlowWord::go_to);
  CHECK(siemens("FOR R1=1 TO 10").block.flow.values.size() == 1);
  const Parsed choices = siemens("CASE R1 OF 1 GOTOF ONE 2 GOTOB TWO DEFAULT GOTO REST");
  REQUIRE(choices.block.flow.choices.size() == 3);
  CHECK(choices.block.flow.choices[1].direction == Direction::backward);
  CHECK(choices.block.flow.choices[2].value == kLiteral);
  CHECK(siemens("REPEAT").block.flow.word == FlowWord::begin_repeat);
  CHECK(siemens("REPEAT HERE THERE P=3").block.flow.word == FlowWord::repeat_section);
  CHECK(siemens("REPEATB HERE P3").block.flow.word == FlowWord::repeat_line);
  CHECK(siemens("DEF INT DEPTH, WIDTH=3").block.settings.size() == 2);
  CHECK_THROWS_AS(siemens("DEF STRING A"), Refusal);
  CHECK_THROWS_AS(siemens("G1 GOTOF ENDE"), Refusal);
  CHECK_THROWS_AS(siemens("CASE R1 OF 1 ONE"), Refusal);
}

TEST_CASE("the head of a program, its names and what only the control draws are no blocks") {
  CHECK(okuma("$PART.MIN%").block.kind == LineKind::percent);
  CHECK_THROWS_AS(okuma("$G0"), Refusal);
  CHECK(okuma("O1000 (NAME)").block.flow.word == FlowWord::program);
  CHECK(siemens("%_N_PART_MPF").block.flow.word == FlowWord::program);
  Parser parser(dialect("okuma"));
  Block block;
  for (const std::string text : {"DEF WORK", "PS LC,[0,0]", "END"}) {
    block.text = text;
    parser.parse(block);
    CHECK(block.kind == LineKind::ignored);
  }
  block.text = "G0";
  parser.parse(block);
  CHECK(block.kind == LineKind::block);
}
