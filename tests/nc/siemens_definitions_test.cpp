// What a program of a SINUMERIK begins with: PROC, then DEF, then its blocks; and what may be the name of a variable.
#include <optional>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "nc/programs.hpp"

using namespace plumbline;
using namespace plumbline::nc;
using namespace plumbline::nc::tests;

namespace {

void check_all(const std::string& dialect, const std::string& code, const std::vector<std::string>& programs) {
  for (const std::string& text : programs) {
    INFO(text);
    ProgramSettings settings = empty_tables();
    settings.work_offsets[0] = WorkOffset{};
    const std::optional<Diagnostic> refused = refusal_of(text, settings, dialect);
    CHECK((refused ? refused->code : "") == code);
    if (refused) CHECK_FALSE(refused->help.empty());
  }
}

}  // namespace

TEST_CASE("a program begins with its definitions") {
  const std::string sub = "SUB\nM30\n%_N_SUB_SPF\n";
  check_all(
      "siemens", "nc-flow-control",
      {"G0 X5\nDEF REAL DEPTH\n", "N1 G54\nN2 DEF INT COUNT=3\n", "MSG(\"PART\")\nDEF BOOL YES\n",
       "R1=5\nDEF REAL DEPTH=R1\n", "DEF REAL DEPTH\nG54\nDEF REAL WIDTH\n", "SUB\nDEF REAL DEPTH\n%_N_SUB_SPF\nRET\n",
       sub + "G0 X5\nDEF REAL DEPTH\nRET\n", "G0 X5\nPROC PART\n", "DEF REAL DEPTH\nPROC PART\n",
       sub + "DEF INT COUNT\nPROC SUB\nRET\n", "IF R1==0\nDEF REAL DEPTH\nENDIF\n"});
  check_all("siemens", "",
            {"; part\nN5\nDEF REAL DEPTH\n\nN10 DEF INT COUNT=2, NUMBER ; both\nG0 X=COUNT\n",
             "%_N_PART_MPF\n;$PATH=/_N_MPF_DIR\nPROC PART\nEXTERN SUB\nDEF REAL DEPTH\nG0 X5\nEXTERN OTHER\n",
             "AGAIN:\nDEF REAL WIDTH=3\nR1=R1+1\nG0 X=WIDTH\nIF R1<3 GOTOB AGAIN\n",
             "DEF REAL DEPTH=2\nSUB P2\nG0 X=DEPTH\nM30\n%_N_SUB_SPF\n; below\nPROC SUB\nDEF REAL DEPTH=3\nG0 "
             "X=DEPTH\nRET\n"});
}

TEST_CASE("words of the control are no names of variables") {
  check_all("siemens", "nc-assignment",
            {"DEF REAL PHI\n", "DEF INT ANZAHL, ID=3\n", "DEF REAL LEAD=1\n", "DEF REAL ABS\n", "DEF REAL NUT\nNUT=3\n",
             "SUB(1)\nM30\n%_N_SUB_SPF\nPROC SUB(REAL ANG)\nRET\n", "DEF BOOL ENDIF\n", "DEF REAL CYCLE83\n"});
  check_all(
      "siemens", "",
      {"DEF REAL DEPTH,COUNT,FEED,SPEED,RADIUS,TOOL,LEN,WIDTH,ANGLE,ANF,ENDE,POSX,RAD,MAX1,_ID,PHI1,U_PHI\nG0 X=PHI1\n",
       "DEF INT TIEFE,VORSCHUB,ZUST,ANZAHL,AUFMASS,MITTE,LOOP1,IDX,ANGE\nG0 X=ANGE\n",
       "SUB(1)\nM30\n%_N_SUB_SPF\nPROC SUB(REAL LEADS)\nG0 X=LEADS\nRET\n"});
}

TEST_CASE("numbers of codes and blocks have no point") {
  for (const std::string dialect : {"siemens", "fanuc", "okuma"}) {
    INFO(dialect);
    check_all(dialect, "nc-not-whole", {"G0 X1.\nG1.0 X5. F100.\n", "M3. S100\n", "N5 G90. G0 X1.\n", "G17.0\n"});
    check_all(dialect, "nc-line-number", {"N1.5 G0 X5.\n", "N10. X5.\n", "N1\nN2.0\n"});
    check_all(dialect, "", {"N1 G0 X1.0\n", "N010 G01 X5.0 F100.0\n"});
  }
  check_all("fanuc", "", {"G54.1 P1\n", "G5.1 Q0\n"});
  check_all("linuxcnc", "", {"G0. X1\n", "N5 G1. X5 F100\n", "M3. S100\n"});
}

TEST_CASE("an archive begins with its main program, whatever its subprogram would do") {
  const std::string main = "%_N_PART_MPF\nG54\nDRILL\nM30\n";
  check_all(
      "siemens", "nc-flow-open",
      {"%_N_DRILL_SPF\n;$PATH=/_N_WKS_DIR\nG1 X5\nRET\n" + main, "%_N_DRILL_SPF\nPROC DRILL(REAL WIDTH)\nRET\n" + main,
       "\n%_N_DRILL_SPF\nX=R5/R6\nM17\n" + main, "%_N_ONE_SPF\nTWO\nRET\n%_N_TWO_SPF\nRET\n"});
  check_all("siemens", "", {main + "%_N_DRILL_SPF\nG1 X5 F100\nRET\n", "%_N_DRILL_SPF\nG0 X5\nRET\n"});
}

TEST_CASE("a cycle behind a stop is told to say --keeps-position with its code") {
  for (const std::string stop : {"M0", "M1", "T1 M6"}) {
    INFO(stop);
    ProgramSettings settings = empty_tables();
    settings.as_with_empty_tables = false;
    settings.work_offsets[0] = WorkOffset{};
    const auto refused = refusal_of(
        "G54 G17 G90 G21\nG0 X0 Y0 Z50. A0 B0 C0\n" + stop + "\nG81 X5. Y5. Z-5. R2. F100.\nM30\n", settings, "fanuc");
    REQUIRE(refused);
    CHECK(refused->code == "nc-position-unknown");
    CHECK(refused->help.find("M0, M1 or M6") != std::string::npos);
  }
}
