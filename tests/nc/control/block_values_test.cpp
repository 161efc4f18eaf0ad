#include "nc/control/block_values.hpp"

#include <string>

#include <catch2/catch.hpp>

#include "base/diagnostic.hpp"
#include "nc/syntax/parsed.hpp"

using namespace plumbline;
using namespace plumbline::nc;
using nc::tests::Parsed;

namespace {

// A control, and the values of the blocks that it is given.
struct Valued {
  explicit Valued(std::string_view name) : control(dialect(name), settings), run{dialect(name), settings, control} {}
  Block& give(Parsed& parsed) {
    run.block = &parsed.block;
    values.evaluate(parsed.block);
    values.apply(parsed.block);
    return parsed.block;
  }
  ProgramSettings settings;
  Control control;
  Execution run;
  BlockValues values{run};
};

}  // namespace

TEST_CASE("RS274 finds all values of a block before it sets any; where no source says so, it is refused") {
  Parsed first("#1=2 #2=3");
  Parsed both("#1=5 #2=#1 X#1");
  Valued linuxcnc("linuxcnc");
  linuxcnc.give(first);
  CHECK(linuxcnc.give(both).words.front().value == 2);
  CHECK(linuxcnc.control.parameters.get(2).number == 2);
  CHECK(linuxcnc.control.parameters.get(1).number == 5);
  CHECK_THROWS_AS(Parsed("#1=5. X#1", "fanuc"), Refusal);
}

TEST_CASE("a word worth a vacant variable is left out, or refused") {
  Parsed macro("G0 X#1 Y2.", "fanuc");
  Valued fanuc("fanuc");
  CHECK(fanuc.give(macro).words.size() == 2);
  CHECK(macro.block.left_out.size() == 1);
  Parsed task("G0 X=DEPTH", "okuma");
  Valued okuma("okuma");
  CHECK_THROWS_AS(okuma.give(task), Refusal);
}

TEST_CASE("the variables of a table stop the control, or show a message") {
  Parsed alarm("#3000=1", "fanuc");
  Valued fanuc("fanuc");
  fanuc.give(alarm);
  CHECK(fanuc.run.step.stop == StopByVariable::alarm);
  CHECK(fanuc.control.ended);
  Parsed message("#3006=1", "fanuc");
  fanuc.give(message);
  CHECK(fanuc.run.step.stop == StopByVariable::alarm);  // the program ends all the same
  Valued shows("fanuc");
  shows.give(message);
  CHECK(shows.run.step.stop == StopByVariable::message);
  Parsed elsewhere("#3000=1");
  Valued linuxcnc("linuxcnc");
  linuxcnc.give(elsewhere);
  CHECK(linuxcnc.run.step.stop == StopByVariable::none);
}
