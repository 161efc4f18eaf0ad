#include "nc/control/parameters/expression.hpp"

#include <cmath>
#include <map>
#include <string>

#include <catch2/catch.hpp>

#include "base/diagnostic.hpp"
#include "nc/syntax/parser.hpp"

using namespace plumbline;
using namespace plumbline::nc;

namespace {

// Parameters 1 to 9 hold their number times ten, 20 what only the machine knows; #<a> is 4.
class SomeParameters : public ParameterReader {
 public:
  Value read(const Block&, int number, Span) override { return {10.0 * number, number != 20}; }
  Value read(const Block&, std::string_view name, Span) override { return {name == "a" ? 4.0 : -1.0, true}; }
  Value exists(const Block& /*block*/, std::string_view name, Span /*span*/) override {
    return {name == "a" ? 1.0 : 0.0, true};
  }
};

Value run(const std::string& expression) {
  Block block;
  std::string text(1, 'X');
  text += expression;
  block.text = text;
  Parser(dialect("linuxcnc")).parse(block);
  SomeParameters parameters;
  return Evaluator().run(block, block.words.at(0).expression, parameters);
}

double value(const std::string& expression) {
  const Value result = run(expression);
  CHECK(result.known);
  return result.number;
}

}  // namespace

TEST_CASE("operators bind from the strongest to the weakest, each from the left") {
  CHECK(value("[1+2*3-4/2]") == 5);
  CHECK(value("[2**3**2]") == 64);
  CHECK(value("[10-4-3]") == 3);
  CHECK(value("[24/4/2]") == 3);
  CHECK(value("[1+1 EQ 2 AND 3 GT 2]") == 1);
  CHECK(value("[[1+2]*3]") == 9);
  CHECK(value("[-2**2]") == 4);
  CHECK(value("[7 mod -3]") == 1);
  CHECK(value("[-7 MOD 3]") == 2);
}

TEST_CASE("relations and logic give one or zero") {
  CHECK(value("[1 LT 2]") == 1);
  CHECK(value("[2 LE 1]") == 0);
  CHECK(value("[2 NE 2.00001]") == 0);
  CHECK(value("[5 EQ 5.001]") == 0);
  CHECK(value("[5 AND 0]") == 0);
  CHECK(value("[5 OR 0]") == 1);
  CHECK(value("[5 XOR -1]") == 0);
}

TEST_CASE("functions take degrees and round as the control does") {
  CHECK(value("SIN[30]") == Approx(0.5));
  CHECK(value("ATAN[1]/[-1]") == Approx(135));
  CHECK(value("ACOS[0]") == Approx(90));
  CHECK(value("FIX[-2.5]") == -3);
  CHECK(value("FUP[-2.5]") == -2);
  CHECK(value("ROUND[-2.5]") == -3);
  CHECK(value("ROUND[0.7-0.2]") == 1);  // half is added first
  CHECK(value("ROUND[0.2-0.7]") == -1);
  CHECK(value("ROUND[0.4999]") == 0);
  CHECK(value("ROUND[-3.2]") == -3);
  CHECK(value("ROUND[1000000.5]") == 1000001);
  CHECK_THROWS_AS(value("ROUND[2147483648]"), Refusal);
  CHECK_THROWS_AS(value("ROUND[-3e9*1]"), Refusal);
  CHECK(value("EXP[LN[3]]") == Approx(3));
  CHECK(value("SQRT[ABS[-16]]") == 4);
}

TEST_CASE("angles are those of the control to the last bit") {
  CHECK(value("SIN[30]") == 0.5);
  CHECK(value("FUP[10*COS[60]]") == 5);
  CHECK(value("TAN[45]") == 1);
  CHECK(value("[COS[300] GT 0.5]") == 0);
  CHECK(value("ASIN[0.5]") == 30);
  CHECK(value("ACOS[-0.5]") == 120);
  CHECK(value("ATAN[1]/[1]") == 45);
}

TEST_CASE("ROUND rounds to what it is told, and where that is not known only whole numbers are") {
  const auto rounded = [](const std::string& expression, const Rounding& rounding) {
    Block block;
    const std::string text = "X" + expression;
    block.text = text;
    Parser(dialect("linuxcnc")).parse(block);
    SomeParameters parameters;
    return Evaluator().run(block, block.words.at(0).expression, parameters, rounding).number;
  };
  CHECK(rounded("ROUND[1.2346]", {}) == 1);
  CHECK(rounded("[ROUND[1.2346]+ROUND[-0.0007]]", {0.001, true}) == Approx(1.234));
  CHECK(rounded("[2*ROUND[0.12346]]", {0.0001, true}) == Approx(0.247));
  CHECK(rounded("ROUND[17]", {1, false}) == 17);
  CHECK_THROWS_AS(rounded("ROUND[17.5]", {1, false}), Refusal);
}

TEST_CASE("parameters by number, by the value of another, by name") {
  CHECK(value("#3") == 30);
  CHECK(value("#[1+1]") == 20);
  CHECK(value("##1") == 100);
  CHECK(value("-#2") == -20);
  CHECK(value("[#<a>+1]") == 5);
  CHECK(value("EXISTS[#<a>]") == 1);
  CHECK(value("[EXISTS[#<b>]+1]") == 1);
}

TEST_CASE("a value that only the machine knows makes every value unknown that uses it") {
  CHECK_FALSE(run("#20").known);
  CHECK_FALSE(run("[1+#20*0]").known);
  CHECK_FALSE(run("SQRT[-#20]").known);
  CHECK(run("#2").known);
}

TEST_CASE("what has no value is refused") {
  for (const char* bad : {"[1/0]", "[0/0]", "SQRT[-1]", "LN[0]", "ASIN[1.1]", "[-2**0.5]", "EXP[1000]", "[5 MOD 0]"}) {
    INFO(bad);
    CHECK_THROWS_AS(run(bad), Refusal);
  }
}
