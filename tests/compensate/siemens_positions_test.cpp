// Words and modes of a SINUMERIK that do not mean what the modes around them say.
#include <algorithm>

#include <catch2/catch.hpp>

#include "compensate/play.hpp"

using namespace plumbline;

namespace {

bool warns_of_stops(const compensate::Summary& summary) { return warnings_of(summary, "compensate-stops") > 0; }

}  // namespace

TEST_CASE("X=AC(5) under G91 stays a position where an increment would go elsewhere") {
  const Job job = job_of_control("siemens");
  const std::string placed = "G54 G17 G90 G64\nG0 X0 Y0 Z50 A0 B0 C0\nG91\n";
  for (const std::string lost : {"M0\n", "M1\n", "CYCLE800()\n"}) {
    INFO(lost);
    const std::string out =
        run(placed + lost + "G0 X=AC(0) Y=AC(0) Z=AC(50) A=AC(0) B=AC(0) C=AC(0)\nG90\nG1 Z10 F100\nM30\n", job).text;
    INFO(out);
    CHECK(has_text(out, "Z=AC(50.0"));
    CHECK(has_text(out, "X=AC("));
  }
  CHECK(has_text(run("G54 G17 G91\nG0 X=AC(10) Y=AC(0) Z=AC(50) A=AC(0) B=AC(0) C=AC(0)\nG1 X1 F100\nM30\n", job).text,
                 "Z=AC(50.0"));
  const std::string copied =
      run("G54 G17 G90 G64\nG0 X0 Y0 Z10 A0 B0 C0\nM0\nG91\nG0 X=AC(20) Y=AC(0) A=AC(0) B=AC(0) C=AC(0)\nG0 Z=AC(10)\n"
          "G1 X1 F100\nM30\n",
          job)
          .text;
  INFO(copied);
  CHECK(has_text(copied, "X=AC(20) Y=AC(0)"));
  CHECK(has_text(copied, "Z=AC(10.0"));
  const std::string shifted = run(placed + "TRANS X10\nG0 X=AC(10)\nG1 Z=AC(10) F100\nM30\n", job).text;
  INFO(shifted);
  CHECK(has_text(shifted, "G0 X=AC("));
}

TEST_CASE("positions under G91 begin after a turn, and stay positions where a cycle is called after them") {
  const Job job = job_of_control("siemens");
  const std::string placed = "G54 G17 G90 G64\nG0 X0 Y0 Z10 A0 B0 C0\nS1000 M3 F100\n";
  for (const auto& [program, written] :
       {std::pair<std::string, std::string>{"ROT Z30\nG91\nG1 X=AC(10) Y=AC(2)\n", "G1 X=AC(0.909) Y=AC(0.182)"},
        {"G91\nAROT Z30\nX=AC(10) Y=AC(3)\nX1\n", "X=AC(10) Y=AC(3) A-0.001"},
        {"ROT Z30\nG1 X=AC(10) Y=AC(2)\n", "G1 X0.9091 Y0.1818"},
        {"TRANS X10\nG91\nMCALL CYCLE81(10,0,2,-5)\nX=AC(20) Y=AC(0)\nX=AC(21)\nMCALL\n", "G0 X=AC(20.999)"},
        {"TRANS X10\nG91\nMCALL CYCLE84(10,0,2,-5,,1,5,,2,0,500,500)\nX=AC(20)\nMCALL\nX1\n", "G0X=AC(19.999)"},
        {"M0\nG91\nMCALL CYCLE83(10,0,2,-5,,-2,,,,,1)\nX=AC(20) Y=AC(0) A=AC(0) B=AC(0) C=AC(0)\nX=AC(21)\nMCALL\n",
         "G0 X=AC(20.999)"},
        {"G91\nMCALL CYCLE82(10,0,2,-5,,1)\nX20 Z=AC(12)\nMCALL\n", "Z=AC(2.0"},
        {"G91\nX1\nCYCLE81(10,0,2,-5)\nX1\n", "Z=AC(2.0"}}) {
    INFO(program);
    const std::string text = placed + program + "M30\n";
    const Result result = run(text, job);
    INFO(result.text);
    CHECK(has_text(result.text, written));
  }
  CHECK(code_of(placed + "ROT Z30\nG1 X=AC(10) Y=IC(2)\nM30\n", job) == "compensate-position-unknown");
  CHECK(code_of(placed + "ROT Z30\nG91\nG1 X=AC(10)\nM30\n", job) == "compensate-position-unknown");
}

TEST_CASE("CYCLE832 chooses the path mode, and no block gets one beside it") {
  const Job job = job_of_control("siemens");
  const std::string cut = "G0 X0 Y0 Z50 A0 B0 C0\nG1 X100 F1000\nM30\n";
  CHECK(has_text(run("G54 G17 G90 G60\n" + cut, job).text, "G64"));
  for (const std::string cycle : {"CYCLE832(0.05,_FINISH,1)\n", "CYCLE832(0.01,1,1)\n", "CYCLE832()\n"}) {
    INFO(cycle);
    const Result result = run("G54 G17 G90 G60\n" + cycle + cut, job);
    CHECK_FALSE(has_text(result.text, "G64"));
    CHECK_FALSE(has_text(result.text.substr(result.text.find("G60") + 3), "G60"));
    CHECK_FALSE(warns_of_stops(result.summary));
    CHECK(has_text(run("G54 G17 G90\n" + cycle + "G60\n" + cut, job).text, "G64"));
  }
}

TEST_CASE("where a program states no path mode, and the control may stop after each block, it is warned of") {
  Job job = job_of_control("siemens");
  const std::string cut = "G0 X0 Y0 Z50 A0 B0 C0\nG1 X100 F1000\nM30\n";
  CHECK(warns_of_stops(run("G54 G17 G90\n" + cut, job).summary));
  for (const std::string mode : {"G60", "G64", "G642", "CYCLE832(0.05,_FINISH,1)"}) {
    INFO(mode);
    CHECK_FALSE(warns_of_stops(run("G54 G17 G90\n" + mode + "\n" + cut, job).summary));
  }
  CHECK_FALSE(warns_of_stops(run("G54 G17 G90\nG0 X0 Y0 Z50 A0 B0 C0\nG1 X0.5 F1000\nM30\n", job).summary));
  job.dialect = "fanuc";
  CHECK_FALSE(warns_of_stops(run("O1\nG54 G17 G90\n" + cut, job).summary));
}

TEST_CASE("a small tilt of the program's own loses the tip where the length changes, in the output as well") {
  Job job = job_of_control("siemens");
  job.program.tools = fanuc_job().program.tools;
  const std::string placed = "T1 M6\nG54 G17 G90 G64 D1\nG0 X0 Y0 Z22 A0 B0 C0\n";
  for (const std::string rest :
       {"G1 X5 A0.05 F2749\nG0 SUPA Z-900 D0\n", "G1 X5 B0.04 F900\nG0 G53 Z-900 D0\n",
        "G1 X5 A-0.02 F900\nD0 G0 Z40\n", "D0\nG0 X1 Y1 Z30\nG1 X5 B0.09 F900\nD1 G0 Z60\n",
        "G1 X5 A0.05 F900\nG0 D0 B0.04\n", "G1 X5 A0.03 B0.03 F900\nD0\nG0 Z60\n",
        "G1 X5 A0.05 F900\nD0\nG0 X0 Y0 Z60\nG1 Z50\n", "G1 X5 A0.05 F900\nM6\nG0 X0 Y0 Z60 A0 B0 C0\nG1 Z50\n"}) {
    INFO(rest);
    CHECK(code_of(placed + rest + "M30\n", job).empty());
  }
  for (const std::string cut : {"G1 X5 A0.05 F900\nD0\nG0 Z60\nG1 X9\n", "G1 X5 B0.05 F900\nD0 G0 X0 Y0\nG1 X9\n"}) {
    INFO(cut);
    CHECK(code_of(placed + cut + "M30\n", job) == "compensate-position-unknown");
  }
  Job fanuc = fanuc_job();
  const std::string length = "O1\nG54 G17 G90\nG0 G43 H1 X0 Y0 Z22 A0 B0 C0\nG1 X5 A0.05 F900\n";
  for (const std::string rest : {"G49\nG0 X0 Y0 Z60\n", "G0 G49 Z60\n", "G28 Z0\nG49\n"}) {
    INFO(rest);
    CHECK(code_of(length + rest + "M30\n", fanuc) != "compensate-read-back");
  }
}

TEST_CASE("MSG beside a cut stands with its first piece") {
  const Job job = job_of_control("siemens");
  const std::string placed = "G54 G17 G90 G64\nG0 X0 Y0 Z20 A0 B0 C0\n";
  for (const std::string cut : {"G1 X150 F900 MSG(\"cut\")\n", "MSG(\"cut\") G1 Y90 F900\n",
                                "G1 F900 X5 A3 MSG(\"cut\")\n", "G2 X0 Y0 I40 J0 F900 MSG(\"cut\")\n"}) {
    const std::string text = run(placed + cut + "M30\n", job).text;
    INFO(text);
    const std::size_t message = text.find("MSG(");
    REQUIRE(message != std::string::npos);
    CHECK(text.find("MSG(", message + 1) == std::string::npos);
    CHECK(std::count(text.begin() + static_cast<std::ptrdiff_t>(message), text.end(), '\n') > 5);  // pieces follow
  }
}
