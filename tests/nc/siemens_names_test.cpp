// Names that are words of a SINUMERIK: none is a variable or a subprogram, and no refusal says that it should be one.
#include <optional>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "nc/programs.hpp"

using namespace plumbline;
using namespace plumbline::nc;
using namespace plumbline::nc::tests;

namespace {

std::optional<Diagnostic> refused_name(const std::string& line) {
  ProgramSettings settings = empty_tables();
  settings.work_offsets[0] = WorkOffset{};
  return refusal_of("G54 G17 G90 G94 G710\nG0 X0 Y0 Z50 A0 B0 C0 S1000 M3 F500\n" + line + "\nX5\nM30\n", settings,
                    "siemens");
}

}  // namespace

TEST_CASE("words of the control are no subprograms and no variables") {
  for (const std::string line : {"ORIRESET",
                                 "ORIRESET(10,20)",
                                 "CUT3DF",
                                 "CUT3DFS",
                                 "CUT3DCC",
                                 "ORID",
                                 "ORIPATH",
                                 "ORIROTA",
                                 "PTP",
                                 "PTPG0",
                                 "CUTCONON",
                                 "SPCON",
                                 "SPCOF(1)",
                                 "WAITE(1)",
                                 "TLIFT(C)",
                                 "TRAILON(Y,X,1)",
                                 "LEADON(Y,X,1)",
                                 "TOFFON(Z)",
                                 "FPRAON(X,S1)",
                                 "DRFOF",
                                 "CORROF(X,\"DRF\")",
                                 "STOPREOF",
                                 "DELDTG",
                                 "WRITE(R1,\"PROT\",\"TEXT\")",
                                 "NEWCONF",
                                 "SETM(1)",
                                 "CLEARM(1)",
                                 "SPLINEPATH(1,X,Y)",
                                 "BAUTO",
                                 "EAUTO",
                                 "CYCLE61(50,0,2,-5)",
                                 "CYCLE63(\"A\")",
                                 "CYCLE79(5)",
                                 "CYCLE806",
                                 "CYCLE978(200,,1)",
                                 "CYCLE996(1)",
                                 "CYCLE997(1)",
                                 "VELOLIM[X]=50",
                                 "JERKLIM[X]=75",
                                 "ACCLIMA[X]=80",
                                 "FXS[X]=1",
                                 "FOCON[X]",
                                 "G1 PO[X]=(1,2) X5",
                                 "G1 X5 A6=1 B6=0 C6=1",
                                 "AN3=1",
                                 "ISD=2",
                                 "PL=3",
                                 "SD=2",
                                 "FD=5",
                                 "SVC=100",
                                 "MMC(\"PICTURE_ON\",\"N\")",
                                 "COUPON(S2,S1)",
                                 "FPR(S1)",
                                 "VELOLIM[ X ] = R1"}) {
    INFO(line);
    const auto refusal = refused_name(line);
    REQUIRE(refusal);
    INFO(refusal->message << " " << refusal->help);
    CHECK(refusal->code == "nc-not-interpreted");
    CHECK(refusal->message.find("subprogram") == std::string::npos);
    CHECK(refusal->help.find("SPF") == std::string::npos);
    CHECK(refusal->help.find("DEF REAL") == std::string::npos);
  }
}

TEST_CASE("what is so without them is read") {
  for (const std::string line : {"CP", "TRAFOOF()", "TRAFOOF", "CP G1 X3"}) CHECK_FALSE(refused_name(line));
  CHECK(refused_name("TRAFOOF(1)"));
}

TEST_CASE("names of the control's folders are those of its programs") {
  for (const std::string path :
       {"/_N_WKS_DIR/_N_LL10_SPF", "_N_LL10_SPF", "LL10", "//NC/_N_SPF_DIR/_N_LL10_MPF", "x/ll10.spf"}) {
    INFO(path);
    ProgramSettings settings = empty_tables();
    CHECK(
        code_of("%_N_TEIL_MPF\nG54 G0 X0\nEXTCALL \"" + path + "\"\nM30\n%_N_LL10_SPF\nX7\nRET\n", settings, "siemens")
            .empty());
    CHECK(code_of("%_N_TEIL_MPF\nG54 G0 X0\nEXTCALL (\"" + path + "1\")\nM30\n%_N_LL10_SPF\nX7\nRET\n", settings,
                  "siemens") == "nc-flow-open");
  }
}

TEST_CASE("a tool's name is taken letter for letter, digits as well") {
  ProgramSettings settings = empty_tables();
  settings.as_with_empty_tables = false;
  settings.work_offsets[0] = WorkOffset{};
  settings.tools = ToolTable({{1, 100, {}, {}, {}, "MILL10"}, {8, 80, {}, {}, {}, "007"}});
  const auto code = [&](const std::string& name) {
    return code_of("G54 G0 X0 Y0 Z50 A0 B0 C0\nT=\"" + name + "\" M6\nX5\nM30\n", settings, "siemens");
  };
  for (const std::string known : {"1", "8", "MILL10", "007"}) CHECK(code(known).empty());
  for (const std::string unknown : {"01", "001", "0007", "08", "mill10"}) CHECK(code(unknown) == "nc-tool-unknown");
}

TEST_CASE("further words of the control are none of the program's, a file of that name or a DEF there or not") {
  for (const std::string word :
       {"TOROTX",    "TOFRAMEZ", "TCOFRX",   "TOWWCS",   "WALCS1",     "WALCS10",  "CLGON",    "REPOS",     "REPOSA",
        "SETINT",    "ENABLE",   "DISABLE",  "LIFTFAST", "LFON",       "POLFMASK", "CTABDEF",  "CTABEND",   "SON",
        "PDELAYON",  "OSSE",     "CPDEF",    "EGDEL",    "ICYCON",     "IPTRLOCK", "RESETMON", "SETDNO",    "GETT",
        "SETPIECE",  "BLSYNC",   "EXECUTE",  "CONTPRON", "CALCPOSI",   "PROTA",    "NPROTDEF", "GFRAME0",   "GFRAME100",
        "ORIANGLE",  "GWPSON",   "EXTOPEN",  "ISFILE",   "REDEF",      "CYCLE435", "CYCLE751", "CYCLE4071", "CYCLE9960",
        "CYCLE8181", "HOLES7",   "POCKET12", "cycle495", "DELAYFSTON", "CPSYNCOP", "CTABFNO",  "ORIAXPOS",  "CRPL",
        "OMA3",      "CADAPTON", "WRTPR"}) {
    INFO(word);
    for (const std::string& line : {word, word + "(1)", "N7 " + word + " ; it", "R1=" + word + "(2)"}) {
      const auto refusal = refused_name(line + "\nM30\n%_N_" + word + "_SPF\nX5\nM17");
      REQUIRE(refusal);
      INFO(line << " " << refusal->message << " " << refusal->help);
      CHECK(refusal->code == "nc-not-interpreted");
      CHECK(refusal->help.find("SPF") == std::string::npos);
    }
    CHECK(code_of("DEF REAL " + word + "\nM30\n", empty_tables(), "siemens") == "nc-assignment");
  }
  for (const std::string word : {"DL",   "TU",   "STAT", "ST",    "SR", "STOLF", "ALF", "DITS", "DITE", "SPN", "SPP",
                                 "PRIO", "DILF", "MOVT", "DISPR", "IR", "JR",    "KR",  "PM",   "PR",   "SF"}) {
    INFO(word);
    for (const std::string& line : {word + "=1", word + "='B10'", "G1 X5 " + word + "=R1", word + "[X]=2"}) {
      const auto refusal = refused_name(line);
      REQUIRE(refusal);
      INFO(line << " " << refusal->message << " " << refusal->help);
      CHECK(refusal->code == "nc-not-interpreted");
      CHECK(refusal->help.find("DEF REAL") == std::string::npos);
    }
    CHECK(code_of("DEF REAL " + word + "=2\nM30\n", empty_tables(), "siemens") == "nc-assignment");
  }
}

TEST_CASE("names that only look like words of the control are the program's") {
  for (const std::string name : {"CYCLEX", "CYCLE_7", "MYCYCLE83", "REPOS_IN", "GFRAMES", "TOOLCHANGE", "CYCLE81A"}) {
    INFO(name);
    CHECK_FALSE(refused_name(name + "\nX7\nM30\n%_N_" + name + "_SPF\nX5\nM17"));
  }
  for (const std::string name : {"RPY", "OUTP", "QEC", "QFK", "SYSEX", "READAL", "TFRAME", "PFRAME", "NEWTL", "CPROTD",
                                 "TRAORI_DYN", "SOFTENDSA", "ORIAXESP", "MEACALC"}) {
    INFO(name);
    CHECK_FALSE(refused_name(name + "\nX7\nM30\n%_N_" + name + "_SPF\nDEF REAL " + name + "=3\nX=" + name + "\nM17"));
  }
  CHECK_FALSE(refused_name("GROUP_ADDEND"));
  CHECK_FALSE(refused_name("OSOF"));
  CHECK_FALSE(refused_name("GOTOF REPOS\nREPOS: X5"));
}

TEST_CASE("T1= with a name is the tool of a spindle or a holder") {
  for (const std::string line : {"T1=\"MILL10\"", "T1=\"MILL10\" M6", "T2 = \"A\"", "T1=1", "T1=R1"}) {
    const auto refusal = refused_name(line);
    REQUIRE(refusal);
    INFO(line << " " << refusal->message << " " << refusal->help);
    CHECK(refusal->message.find("spindle or a tool holder") != std::string::npos);
    CHECK(refusal->help.find("write T") != std::string::npos);
  }
  CHECK(refused_name("T1=\"MILL10\" M6")->help.find("T=\"MILL10\"") != std::string::npos);
  CHECK(refused_name("R1=\"MILL10\"")->message.find("texts are not interpreted") != std::string::npos);
}

TEST_CASE("words that no move can stand for are not to be written out in moves") {
  for (const std::string line : {"G26 S5000", "G25 X10", "ACC[X]=50", "FL[A]=100", "VELOLIM[X]=50", "JERKLIM[X]=75",
                                 "ACCLIMA[X]=80", "OVRRAP=20", "SETAL(65000)", "WAITP(X)", "WAITM(1,1)", "CUTMOD=1",
                                 "GEOAX()", "TOROT", "ORIEULER", "LEAD=2", "G110 X5"}) {
    const auto refusal = refused_name(line);
    REQUIRE(refusal);
    INFO(line << " " << refusal->help);
    CHECK(refusal->help.find("G0, G1, G2 and G3") == std::string::npos);
    CHECK_FALSE(refusal->help.empty());
  }
}
