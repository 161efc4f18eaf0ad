// Variables that outlast a program, which the output sets no more where it is written out.
#include <catch2/catch.hpp>

#include "compensate/play.hpp"

using namespace plumbline;

namespace {

const std::string kProgramBegin = "O0001\nG21 G17 G90 G54 G94\nG0 X0. Y0. Z50. A0. B0. C0.\n";

}  // namespace

TEST_CASE("what a program sets for others, or for the control, is not lost where it is written out") {
  const Job job = job_of_control("fanuc");
  const std::string loop = "#1=0\nWHILE [#1 LT 2] DO 1\n#1=#1+1\nG1 X[#1*5] F200.\nEND 1\n";
  for (const std::string set : {"#500=5.", "#999=#1", "#3004=7", "#3003=1", "IF [#1 EQ 2] THEN #505=1", "#[500+1]=2"}) {
    INFO(set);
    CHECK(code_of(kProgramBegin + loop + set + "\nM30\n", job) == "compensate-flow");
    if (set.find("#1") == std::string::npos)
      CHECK(run(kProgramBegin + "G1 X5. F200.\n" + set + "\nM30\n", job).text.find(set) != std::string::npos);
  }
  CHECK(code_of(kProgramBegin + loop + "#33=2\nM30\n", job).empty());
}

TEST_CASE("a common variable that a program sets and does not read is not lost where it is written out") {
  const Job job = job_of_control("fanuc");
  CHECK(run(kProgramBegin + "G1 X5. F200.\n#100=5.\nM30\n", job).text.find("#100=5.") != std::string::npos);
  const std::string loop = "#1=0\nWHILE [#1 LT 2] DO 1\n#1=#1+1\nG1 X[#1*5] F200.\nEND 1\n";
  for (const std::string set : {"#100=5.", "#199=#1", "IF [#1 EQ 2] THEN #105=1", "#[100+1]=2"}) {
    INFO(set);
    CHECK(code_of(kProgramBegin + loop + set + "\nM30\n", job) == "compensate-flow");
    CHECK(code_of(kProgramBegin + loop + set + "\nM99\n", job) == "compensate-flow");
  }
  for (const std::string used : {"#100=5.\nG1 X#100 F200.", "#101=0\nWHILE [#101 LT 2] DO 1\n#101=#101+1\nEND 1",
                                 "#102=1\nIF [#102 EQ 1] GOTO 9\nG1 X9. F200.\nN9 G1 Y5. F200."}) {
    INFO(used);
    CHECK(code_of(kProgramBegin + loop + used + "\nM30\n", job).empty());
  }
}

TEST_CASE("common variables of an OSP that a program sets and does not read are not lost where it is written out") {
  Job job = job_of_control("okuma");
  job.program.variables = {{3, 1.0}};
  const std::string head = "G15 H1\nG90 G94 G0 X0 Y0 Z20 A0 B0 C0\n";
  const std::string loop = "VC1=0\nNA IF [VC1 GE 2] NB\nG1 X=VC1*10 F500\nVC1=VC1+1\nGOTO NA\nNB ";
  for (const std::string set : {"VC2=5", "VC[2]=VC1", "VC3=VC3+1"}) {
    INFO(set);
    CHECK(code_of(head + loop + set + "\nM2\n", job) == "compensate-flow");
    CHECK(run(head + "VC1=1\nG1 X5 F500\n" + set + "\nM2\n", job).text.find(set) != std::string::npos);
  }
  CHECK(code_of(head + loop + "VC2=5\nG1 X=VC2\nM2\n", job).empty());
  CHECK(code_of(head + loop + "G1 X=VC3\nM2\n", job).empty());
}

TEST_CASE("variables that outlast a program of LinuxCNC have their last values where it is written out") {
  Job job = job_of_control("linuxcnc");
  const std::string head = "G21 G90 G94 G0 X0 Y0 Z5 A0 B0 C0\n";
  const std::string loop = "#1=0\no1 while [#1 LT 2]\n#1=[#1+1]\nG1 X[#1*5] F200\no1 endwhile\n";
  for (const auto& [set, restated] :
       {std::pair<std::string, std::string>{"#100=5\n#5000=-0.5\nM2\n", "\n#100=5\n#5000=-0.5\nM2\n"},
        {"#<_Safe Height>=[1/3]\n#<own>=4\nM30\n", "\n#<_safeheight>=0.3333333333333333\nM30\n"},
        {"#31=[2*4]\n#[30+1]=[#31/1000]\n#30=1\nM2\n", "\n#31=0.008\nM2\n"},
        {"o9 sub\n#<_n>=#1\n#40=7\no9 endsub\no9 call [3]\nM2\n", "\n#<_n>=3\n#40=7\nM2\n"}}) {
    INFO(set);
    CHECK(run(head + loop + set, job).text.ends_with(restated));
  }
  CHECK(run("%\n" + head + loop + "#33=1\n%\n", job).text.ends_with("\n#33=1\n%\n"));
  CHECK(run(head + "#100=5\nG1 X5 F200\nM2\n", job).text.find("#100=5\nG1") != std::string::npos);
  job.program.variables = {{101, 3.0}};
  CHECK(code_of(head + loop + "#101=[#101+1]\nM2\n", job) == "compensate-flow");
  CHECK(code_of(head + loop + "G1 X#101\nM2\n", job).empty());
}

TEST_CASE("R parameters that a program sets have their last values where it is written out") {
  Job job = job_of_control("siemens");
  const std::string head = "G17 G71 G90 G94\nG0 X0 Y0 Z5 A0 B0 C0\n";
  const std::string loop = "R1=0\nWHILE R1<3\nR1=R1+1\nG1 X=R1*5 F200\nENDWHILE\n";
  for (const auto& [set, restated] :
       {std::pair{"R99=5", "R99=5\n"}, {"R[7]=R1/3", "R7=1\n"}, {"R0=-1/3", "R0=-0.33333333\n"}}) {
    INFO(set);
    const std::string text = run(head + loop + set + "\nM30\n", job).text;
    CHECK(text.find(restated) != std::string::npos);
    CHECK(text.find("R1=3\n") != std::string::npos);
    CHECK(text.ends_with("M30\n"));
  }
  CHECK(run("DEF REAL DEPTH=2\n" + head + loop + "DEPTH=3\nM30\n", job).text.find("DEPTH") == std::string::npos);
  job.program.variables = {{0, 3.0}};
  CHECK(code_of(head + loop + "R0=R0+1\nM30\n", job) == "compensate-flow");
}

// What FOR leaves in its variable was found in no source.
TEST_CASE("what FOR counted is left by a FOR where the program is written out") {
  const Job job = job_of_control("siemens");
  const std::string head = "DEF INT NUM\nG17 G71 G90 G94\nG0 X0 Y0 Z5 A0 B0 C0\n";
  const std::string loop = "FOR R1=1 TO 2\nG1 X=R1*5 F200\nENDFOR\n";
  for (const auto& [program, end] :
       {std::pair<std::string, std::string>{loop + "R2=4\n", "FOR R1=2 TO 2\nENDFOR\nR2=4\n"},
        {loop + "R1=7\n", "\nR1=7\n"},
        {loop + "FOR R1=-3 TO -1\nG1 Y=R1 F200\nENDFOR\n", "\nFOR R1=-1 TO -1\nENDFOR\n"},
        {"FOR R3=1 TO 2\n" + loop + "ENDFOR\n", "\nFOR R1=2 TO 2\nENDFOR\nFOR R3=2 TO 2\nENDFOR\n"},
        {loop + "FOR R1=5 TO 4\nENDFOR\n", "\nR1=5\n"},
        {"FOR R1=1 TO 9\nG1 X=R1*5 F200\nIF R1==2 GOTOF NEXT\nENDFOR\nNEXT:\n", "\nR1=2\n"},
        {"FOR NUM=1 TO 2\nG1 X=NUM F200\nENDFOR\nR9=1\n", "\nR9=1\n"}}) {
    INFO(program);
    CHECK(run(head + program + "M30\n", job).text.ends_with(end + "M30\n"));
    CHECK(run(head + program, job).text.ends_with(end));
  }
  CHECK(code_of(head + loop + "R2=R1\nM30\n", job) == "compensate-flow");
}
