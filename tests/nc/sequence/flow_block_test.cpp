#include "nc/sequence/flow_block.hpp"

#include <catch2/catch.hpp>

#include "nc/syntax/parsed.hpp"
#include "support/scratch.hpp"

using namespace plumbline;
using namespace plumbline::nc;
using nc::tests::Parsed;

TEST_CASE("a line steers by its statement, or by the first of its words") {
  const Parsed jump("N10 GOTO 5", "fanuc");
  CHECK(jump.at(steering_span(jump.block)).starts_with("GOTO"));
  const Parsed call("N10 M98 P100", "fanuc");
  CHECK(call.at(steering_span(call.block)) == "M98");
  const Place place = steering_place(call.block);
  CHECK(place.line == 7);
  CHECK(place.column == 5);
  CHECK(place.length == 3);
  CHECK(place.text == "N10 M98 P100");
}

TEST_CASE("a refusal of what steers stands under it") {
  const Parsed call("N10 M98 P100", "fanuc");
  const Diagnostic refused = testing::refusal_of([&] { refuse_flow(call.block, "nc-flow-label", "why", "way out"); });
  CHECK(refused.code == "nc-flow-label");
  CHECK(refused.message == "why");
  CHECK(refused.help == "way out");
  CHECK(refused.place.column == 5);
}

TEST_CASE("a condition holds where it is not 0") {
  const ProgramSettings settings;
  Interpreter interpreter(dialect("linuxcnc"), settings);
  CHECK(condition_holds(interpreter, Parsed("o1 if [2 GT 1]").block));
  CHECK_FALSE(condition_holds(interpreter, Parsed("o1 if [1 GT 2]").block));
  CHECK(condition_holds(interpreter, Parsed("o1 while [-0.5]").block));
  const Parsed unset("o1 if [#31]");
  CHECK(testing::refusal_of([&] { condition_holds(interpreter, unset.block); }).code == "nc-parameter-unset");
}

TEST_CASE("labels and counts are whole numbers") {
  const ProgramSettings settings;
  Interpreter interpreter(dialect("linuxcnc"), settings);
  const auto count = [&](const Parsed& line) {
    return number_of(interpreter, line.block, line.block.flow.values.front(), "the count");
  };
  CHECK(count(Parsed("o1 repeat [2+3]")) == 5);
  CHECK(count(Parsed("o1 repeat [-3]")) == -3);
  const Parsed half("o1 repeat [2.5]");
  CHECK(testing::refusal_of([&] { count(half); }).code == "nc-not-whole");
}
