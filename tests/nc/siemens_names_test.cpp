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
