// Lines behind / that steer the program, in every dialect: whether the control executes them is said, or they are
// refused.
#include <optional>
#include <string>

#include <catch2/catch.hpp>

#include "nc/osp_cases.hpp"
#include "nc/programs.hpp"

using namespace plumbline;
using namespace plumbline::nc;
using namespace plumbline::nc::tests;

namespace {

std::optional<Diagnostic> refused(const std::string& program, const char* control,
                                  std::optional<bool> block_delete = std::nullopt) {
  ProgramSettings settings = at_zero();
  settings.block_delete = block_delete;
  return refusal_of(program, settings, control);
}

void check_unsaid(const std::string& program, const char* control, std::size_t line) {
  INFO(control << ": " << program);
  const std::optional<Diagnostic> found = refused(program, control);
  REQUIRE(found);
  CHECK(found->code == "nc-block-delete");
  CHECK(found->place.line == line);
  CHECK(found->help.find("--block-delete on") != std::string::npos);
}

void check_read(const std::string& program, const char* control, std::optional<bool> block_delete = std::nullopt) {
  const std::optional<Diagnostic> found = refused(program, control, block_delete);
  INFO(control << ": " << program << (found ? to_text(*found) : ""));
  CHECK_FALSE(found);
}

}  // namespace

TEST_CASE("OSP: a jump, a call or a return behind / is executed only where an option says so") {
  check_osp({{"G15 H1 G0 X0 Y0 Z0\n/GOTO N5\nG1 X5 F100\nN5 G1 X6 F100\nM2\n", 2, 1, "nc-block-delete"},
             {"G15 H1 G0 X0 Y0 Z0\nVC1=1\n/IF [VC1 EQ 1] N5\nX5\nN5 X6\nM2\n", 3, 1, "nc-block-delete"},
             {"G15 H1 G0 X0 Y0 Z0\n/CALL O2\nM2\nO2\nX5\nRTS\n", 2, 1, "nc-block-delete"},
             {"G15 H1 G0 X0 Y0 Z0\nCALL O2\nM2\nO2\nX5\n/2 RTS\nX6\nRTS\n", 6, 1, "nc-block-delete"},
             {"G15 H1 G0 X0 Y0 Z0\nCALL O2\nM2\n/O2\nX5\nRTS\n", 4, 1, "nc-block-delete"}});
}

TEST_CASE("OSP: a jump to a line behind / is refused, a line that nothing leads to stays read") {
  check_osp({{"G15 H1 G0 X0 Y0 Z0\nGOTO N5\nX5\n/N5 M8\nX6\nM2\n", 2, 1, "nc-block-delete", "line 4"},
             {"G15 H1 G0 X0 Y0 Z0\nIF [1 EQ 1] NEND\nX5\n/NEND\nX6\nM2\n", 2, 1, "nc-block-delete"},
             {"G15 H1 G0 X0 Y0 Z0\n/N5 M8\n/ (NOTE)\n/M9\n/N7 M8\nM2\n", 0, 0}});
}

TEST_CASE("Fanuc: statements behind /") {
  const std::string begin = "G21 G90 G94 G54\nG0 X0 Y0 Z0\n#100=1\n";
  check_unsaid(begin + "/GOTO 5\nX5.\nN5 X6.\nM30\n", "fanuc", 4);
  check_unsaid(begin + "/IF [#100 EQ 1] GOTO 5\nX5.\nN5 X6.\nM30\n", "fanuc", 4);
  check_unsaid(begin + "/WHILE [#100 LT 3] DO 1\n#100=#100+1\nEND 1\nM30\n", "fanuc", 4);
  check_unsaid(begin + "WHILE [#100 LT 3] DO 1\n#100=#100+1\n/END 1\nM30\n", "fanuc", 6);
  check_unsaid(begin + "GOTO 5\nX5.\n/N5 M8\nX6.\nM30\n", "fanuc", 4);
  check_read(begin + "/GOTO 5\nX5.\nN5 X6.\nM30\n", "fanuc", true);
  check_read(begin + "/GOTO 5\nX5.\nN5 X6.\nM30\n", "fanuc", false);
  check_read(begin + "/N5 M8\n/(NOTE)\n/N7 M9\nM30\n", "fanuc");
}

TEST_CASE("LinuxCNC: O words behind /") {
  check_unsaid("G0 X0\n/o1 if [1 EQ 1]\nG0 X5\no1 endif\nM2\n", "linuxcnc", 2);
  check_unsaid("G0 X0\no1 if [1 EQ 1]\nG0 X5\n/o1 endif\nM2\n", "linuxcnc", 4);
  check_unsaid("o2 sub\nG0 X5\no2 endsub\n/o2 call\nM2\n", "linuxcnc", 4);
  check_unsaid("/o2 sub\nG0 X5\no2 endsub\nM2\n", "linuxcnc", 1);
  check_read("G0 X0\n/o1 if [1 EQ 1]\n/G0 X5\n/o1 endif\nM2\n", "linuxcnc", true);
  check_read("G0 X0\n/o1 if [1 EQ 1]\n/G0 X5\n/o1 endif\nM2\n", "linuxcnc", false);
}

TEST_CASE("Siemens: jumps, branches and loops behind /") {
  const std::string begin = "G71 G90 G94 G54\nG0 X0 Y0 Z0\nR1=1\n";
  check_unsaid(begin + "/GOTOF LA\nG0 X5\nLA: G0 X6\nM30\n", "siemens", 4);
  check_unsaid(begin + "/IF R1==1 GOTOF LA\nG0 X5\nLA: G0 X6\nM30\n", "siemens", 4);
  check_unsaid(begin + "GOTOF LA\nG0 X5\n/LA: M8\nG0 X6\nM30\n", "siemens", 4);
  check_unsaid(begin + "IF R1==1\nG0 X5\n/ELSE\nG0 X6\nENDIF\nM30\n", "siemens", 6);
  // R1==2 leaves out what is in it, and the switch says where that ends.
  check_unsaid(begin + "IF R1==2\n/IF R1==3\nG0 X5\nENDIF\nG0 X6\nENDIF\nM30\n", "siemens", 4);
  check_read(begin + "IF R1==2\n/IF R1==3\nG0 X5\n/ENDIF\nG0 X6\nENDIF\nM30\n", "siemens", false);
  check_read(begin + "/M8\n/N7 M9\n/LA: M8\nM30\n", "siemens");
}

TEST_CASE("OSP: an end behind / that is executed leaves what stands behind it as it is") {
  const auto check = [](const std::string& program, std::optional<bool> block_delete, std::size_t line) {
    ProgramSettings settings = at_zero();
    settings.work_offsets[0] = WorkOffset{};
    settings.block_delete = block_delete;
    const std::optional<Diagnostic> found = refusal_of("G15 H1 G0 X0 Y0 Z0\n" + program, settings, "okuma");
    INFO(program << (found ? to_text(*found) : ""));
    CHECK(found.has_value() == (line != 0));
    if (found) CHECK(found->place.line == line);
  };
  for (const std::string end : {"/M2\n", "/M30\n", "/2 N9 M02\n"}) {
    check(end + "G1 X5 F100\nM2\n", false, 3);
    check(end + "G1 X5 F100\nM2\n", true, 0);
    check(end + "G1 X5 F100\nM2\n", std::nullopt, 2);
  }
  check("/M2\n(THE END)\n%\n", false, 0);
}
