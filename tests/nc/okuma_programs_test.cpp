// Programs of an OSP that CALL names: their zeros, and files that hold one of the same name.
#include <optional>
#include <string>

#include <catch2/catch.hpp>

#include "nc/osp_cases.hpp"
#include "nc/programs.hpp"
#include "support/scratch.hpp"

using namespace plumbline;
using namespace plumbline::nc;
using namespace plumbline::nc::tests;

namespace {

constexpr const char* kSub = "\nG1 X5 F100\nRTS\n";

std::string called(const testing::Scratch& scratch, const std::string& body) {
  ProgramSettings settings = at_zero();
  settings.work_offsets[0] = WorkOffset{};
  const std::string program = scratch.file("PART.MIN", "G15 H1 G0 X0 Y0 Z0\n" + body);
  const std::optional<Diagnostic> found = refusal_of_file(program, settings, "okuma");
  return found ? found->code + ": " + found->message : "";
}

bool is_ambiguous(const std::string& refused) { return refused.starts_with("nc-subprogram-ambiguous"); }

}  // namespace

TEST_CASE("OSP: a program is called by its name as it is written") {
  check_osp({{"G15 H1 G0 X0\nCALL O0002\nM2\nO2\nX5\nRTS\n", 2, 1, "nc-flow-open", "O2"},
             {"G15 H1 G0 X0\nCALL O2\nM2\nO0002\nX5\nRTS\n", 2, 1, "nc-flow-open", "O0002"},
             {"G15 H1 G0 X0\nCALL O02 Q2\nM2\nO002\nX5\nRTS\n", 2, 1, "nc-flow-open", "O002"},
             {"G15 H1 G0 X0\nCALL O3\nM2\nO2\nX5\nRTS\n", 2, 1, "nc-flow-open", "O3.SSB"}});
  check_osp({{"G15 H1 G0 X0\nCALL O0002\nM2\no0002\nX5\nRTS\n", 0, 0},
             {"G15 H1 G0 X0\nCALL O2\nCALL O002\nM2\nO2\nX5\nRTS\nO002\nX6\nRTS\n", 0, 0},
             {"G15 H1 G0 X0\nCALL O 2\nM2\nO2\nX5\nRTS\n", 0, 0}});
}

TEST_CASE("OSP: a file beside the program of another number of zeros is named") {
  const testing::Scratch scratch;
  scratch.file("O0007.SSB", std::string("O0007") + kSub);
  CHECK(called(scratch, "CALL O0007\nM2\n").empty());
  const std::string refused = called(scratch, "CALL O7\nM2\n");
  INFO(refused);
  CHECK(refused.starts_with("nc-flow-open"));
  CHECK(refused.find("O0007.SSB") != std::string::npos);
}

TEST_CASE("OSP: a subprogram that several files hold is refused, whatever the order of calls") {
  {
    const testing::Scratch scratch;
    scratch.file("O2.SSB", std::string("O2") + kSub);
    CHECK(called(scratch, "CALL O2\nCALL O2\nM2\n").empty());
    CHECK(is_ambiguous(called(scratch, "CALL O2\nM2\nO2\nX9\nRTS\n")));
    CHECK(called(scratch, "CALL O3\nM2\nO3\nX9\nRTS\n").empty());
    scratch.file("O2.SUB", std::string("O2") + kSub);  // the same program twice
    CHECK(called(scratch, "CALL O2\nM2\n").empty());
    scratch.file("O2.SUB", std::string("O2\nX7") + kSub);
    CHECK(is_ambiguous(called(scratch, "CALL O2\nM2\n")));
  }
  {
    const testing::Scratch scratch;
    scratch.file("OALL.LIB", std::string("OALL") + kSub + "O2" + kSub);
    CHECK(called(scratch, "CALL OALL\nCALL O2\nM2\n").empty());
    scratch.file("O2.SSB", "G1 X6 F100\nRTS\n");  // names none
    CHECK(is_ambiguous(called(scratch, "CALL OALL\nCALL O2\nM2\n")));
    CHECK(is_ambiguous(called(scratch, "CALL O2\nCALL OALL\nM2\n")));
    CHECK(called(scratch, "CALL O2\nM2\n").empty());
  }
  {
    const testing::Scratch scratch;
    scratch.file("OA.LIB", std::string("OA") + kSub + "O5" + kSub);
    scratch.file("OB.LIB", std::string("OB") + kSub + "O5" + kSub);
    CHECK(called(scratch, "CALL OA\nCALL OB\nM2\n").empty());
    CHECK(is_ambiguous(called(scratch, "CALL OA\nCALL OB\nCALL O5\nM2\n")));
    CHECK(is_ambiguous(called(scratch, "CALL OA\nCALL O5\nCALL OB\nM2\n")));
  }
}

TEST_CASE("OSP: a program that holds the one of its own file's name is one of it") {
  const testing::Scratch scratch;
  const std::string program = scratch.file("OSUB.MIN", "G15 H1 G0 X0 Y0 Z0\nCALL OSUB\nM2\nOSUB\nG1 X5 F100\nRTS\n");
  ProgramSettings settings = at_zero();
  settings.work_offsets[0] = WorkOffset{};
  const auto found = refusal_of_file(program, settings, "okuma");
  INFO((found ? to_text(*found) : ""));
  CHECK_FALSE(found);
}
