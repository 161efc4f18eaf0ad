#include "nc/control/passed_values.hpp"

#include <string>

#include <catch2/catch.hpp>

#include "nc/syntax/parsed.hpp"

using namespace plumbline;
using namespace plumbline::nc;
using nc::tests::Parsed;

namespace {

// The line with values in place of its variables; "?": some have none.
std::string with_passed_values(const std::string& line) {
  const ProgramSettings settings;
  Control control(dialect("siemens"), settings);
  const Execution run{dialect("siemens"), settings, control};
  control.parameters.set(1, {2.5});
  control.parameters.set(2, {-3});
  control.parameters.set(3, {0, false});
  control.parameters.set("CLOSE", {0.02});
  const Parsed parsed(line, "siemens");
  const PassedValues passed = passed_values(run, parsed.block);
  if (passed.unknown) return "?";
  std::string text = line;
  for (auto value = passed.values.rbegin(); value != passed.values.rend(); ++value) {
    text.replace(value->span.begin, value->span.end - value->span.begin, value->text);
  }
  return text;
}

}  // namespace

TEST_CASE("variables in brackets that are not looked into have their values in their place") {
  CHECK(with_passed_values("CYCLE832(0.1,1)") == "CYCLE832(0.1,1)");
  CHECK(with_passed_values("CYCLE832(R1,R2,1)") == "CYCLE832(2.5,-3,1)");
  CHECK(with_passed_values("CYCLE832( close , 1)") == "CYCLE832( 0.02 , 1)");
  CHECK(with_passed_values("G641 ADIS=R1/10") == "G641 ADIS=2.5/10");
  CHECK(with_passed_values("ADIS=10-R2 ADISPOS=R1") == "ADIS=10-(-3) ADISPOS=2.5");
  CHECK(with_passed_values("SPOS[1]=DC(R2)") == "SPOS[1]=DC(-3)");
  CHECK(with_passed_values("MSG(\"R1 CLOSE\")") == "MSG(\"R1 CLOSE\")");
}

TEST_CASE("texts that are joined become one") {
  CHECK(with_passed_values("MSG(\"N \"<<R2)") == "MSG(\"N -3\")");
  CHECK(with_passed_values("MSG(\"X, \" << R1 << \" mm (R1)\" ) ; R1") == "MSG(\"X, 2.5 mm (R1)\") ; R1");
  CHECK(with_passed_values("MSG(R1<<\"/\"<<close,1)") == "MSG(\"2.5/0.02\",1)");
}

TEST_CASE("what has no value here is passed as it stands") {
  for (const std::string line :
       {"ADIS=R3", "ADIS=R4", "ADIS=R[1]", "MSG(\"N \"<<R3)", "MSG(\"N \"<<R1+1)", "CYCLE832(R1,R3)", "R1=5 ADIS=R1"}) {
    INFO(line);
    CHECK(with_passed_values(line) == "?");
  }
}
