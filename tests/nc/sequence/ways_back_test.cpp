#include "nc/sequence/ways_back.hpp"

#include <string>

#include <catch2/catch.hpp>

#include "base/diagnostic.hpp"
#include "nc/programs.hpp"

using namespace plumbline;
using namespace plumbline::nc;
using namespace plumbline::nc::tests;

namespace {

// The message of the refusal, or "".
std::string refusal(std::string_view control, std::string_view text) {
  ProgramSettings settings = empty_tables();
  settings.max_blocks = 1000;
  const auto refused = refusal_of(text, settings, control);
  return refused ? refused->message : "";
}

}  // namespace

TEST_CASE("a way that leads back without end is told when it does so again") {
  const std::string always = "this leads back without end: no variable has changed since it did so before";
  CHECK(refusal("fanuc", "O1\nN5 G0 X1.\nGOTO 5\nM30\n") == always);
  CHECK(refusal("fanuc", "O1\n#1=1\nWHILE [#1 EQ 1] DO 1\nG0 X1.\nEND 1\nM30\n") == always);
  CHECK(refusal("siemens", "LA: G0 X1\nGOTOB LA\nM30\n") == always);
  CHECK(refusal("fanuc", "O1\nN1 G0 X1.\nX2.\nM99 P1\n") == always);
  CHECK(refusal("fanuc", "O1\n#1=3\nN7 G0 X#1\nM98 P2\nM99 P7\nO2\nG0 Y1.\nM99\n") == always);
  CHECK(refusal("fanuc", "O1\nG0 X1.\nGOTO 3\nN2 X2.\nM30\nN3 M99 P2\n").empty());
  CHECK(refusal("okuma", "O1\nNA G0 X1\nGOTO NA\nM2\n") == always);
  CHECK(refusal("fanuc", "O1\n#1=0\nN5 G0 X#1\n#1=#1+1\nGOTO 5\nM30\n").find("more than 1000 blocks") !=
        std::string::npos);
  CHECK(refusal("fanuc", "O1\n#1=0\nN5 G0 X#1\n#1=#1+1\nIF [#1 LT 4] GOTO 5\nM30\n").empty());
}

TEST_CASE("loops by number lie one in the other, from 1 to 3") {
  const std::string inner = "WHILE [#2 LT 1] DO 2\n#2=#2+1\n";
  const std::string head = "O1\n#1=0\n#2=0\nWHILE [#1 LT 2] DO 1\n#1=#1+1\n";
  CHECK(refusal("fanuc", head + inner + "END 2\nEND 1\nM30\n").empty());
  CHECK(refusal("fanuc", head + inner + "END 1\nEND 2\nM30\n").find("cross") != std::string::npos);
  CHECK(refusal("fanuc", "O1\n#1=0\nWHILE [#1 LT 2] DO 4\n#1=#1+1\nEND 4\nM30\n") ==
        "the control has no loop with the number 4");
}
