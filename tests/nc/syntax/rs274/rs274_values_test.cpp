#include "nc/syntax/rs274/rs274_values.hpp"

#include <vector>

#include <catch2/catch.hpp>

#include "base/diagnostic.hpp"
#include "nc/syntax/parsed.hpp"

using namespace plumbline;
using namespace plumbline::nc;
using nc::tests::Parsed;

namespace {

std::vector<Operation> operations_of(const Parsed& parsed, std::uint32_t code) {
  std::vector<Operation> all;
  for (auto at = code; parsed.block.code[at].operation != Operation::end; ++at) {
    all.push_back(parsed.block.code[at].operation);
  }
  return all;
}

std::vector<Operation> operations_in(const std::string& value, std::string_view dialect_name) {
  const Parsed parsed("X" + value, dialect_name);
  return operations_of(parsed, parsed.block.words.front().expression);
}

}  // namespace

TEST_CASE("operators bind as the control says") {
  using enum Operation;
  CHECK(operations_in("[1+2*3]", "linuxcnc") == std::vector{number, number, number, times, plus});
  CHECK(operations_in("[2**3**2]", "linuxcnc") == std::vector{number, number, power, number, power});
  CHECK(operations_in("[1 EQ 2 AND 3]", "linuxcnc") == std::vector{number, number, equal, number, logical_and});
  CHECK(operations_in("[1 + 2 AND 3]", "fanuc") == std::vector{number, number, number, bit_and, plus});
}

TEST_CASE("functions are those of the control") {
  using enum Operation;
  CHECK(operations_in("ATAN[1]/[2]", "linuxcnc") == std::vector{number, number, arc_tangent});
  CHECK(operations_in("[ATAN[1]/[2]]", "fanuc") == std::vector{number, number, arc_tangent_turn});
  CHECK(operations_in("[ATAN[1,2]]", "fanuc") == std::vector{number, number, arc_tangent_turn});
  CHECK(operations_in("[ATAN[1]]", "fanuc") == std::vector{number, arc_tangent_of_one});
  CHECK(operations_in("[FIX[1]]", "fanuc") == std::vector{number, truncate});
  CHECK(operations_in("FIX[1]", "linuxcnc") == std::vector{number, round_down});
  CHECK_THROWS_AS(Parsed("XATAN[1]"), Refusal);
  CHECK(operations_in("EXISTS[#5]", "linuxcnc") == std::vector{number, exists_number});
  CHECK_THROWS_AS(Parsed("X[EXISTS[#5]]", "fanuc"), Refusal);
}

TEST_CASE("a control whose AND works on bits compares once in a bracket") {
  CHECK_THROWS_AS(Parsed("#1=[#2 EQ 1 AND #3 EQ 2]", "fanuc"), Refusal);
  CHECK_THROWS_AS(Parsed("#1=[[#2 EQ 1] AND [#3 EQ 2]]", "fanuc"), Refusal);
  CHECK(Parsed("IF [[#2 EQ 1] AND [#3 EQ 2]] GOTO 5", "fanuc").block.flow.values.size() == 1);
  Parser parser(dialect("fanuc"));
  Block block;
  for (const std::string text :
       {"IF [#2 EQ 3] GOTO 1", "IF [#5 GT 6] GOTO 1"}) {  // what one block compares, the next may compare too
    block.text = text;
    parser.parse(block);
    CHECK(block.flow.values.size() == 1);
  }
}
