// Parts of a SINUMERIK program that CALL BLOCK calls, written out where they are executed.
#include <string>

#include <catch2/catch.hpp>

#include "compensate/play.hpp"

using namespace plumbline;

namespace {

const std::string kBeforeParts = "G54 G17 G710 G90 G94 F300\nG0 X0 Y0 Z20 A0 B0 C0\n";

}  // namespace

TEST_CASE("a part that CALL BLOCK calls comes out as if it stood there") {
  const Job job = job_of_control("siemens");
  const std::string contour = "G1 X10 F400\nY5\nG2 X5 Y5 I-2.5 J0\n", slot = "G91\nG1 Z-1\nX3\nG90\n";
  const std::string parts = "G0 Z30\nM30\nLABEL1:; CONTOUR\n" + contour + "LABEL0:\n\nLABEL2:\n" + slot + "LABEL0:\n";
  const std::string one = "CALL BLOCK LABEL1 TO LABEL0\n", two = "CALL BLOCK LABEL2 TO LABEL0\n";
  for (const auto& [calls, plain] :
       {std::pair{one, contour}, std::pair{two + "G1 X1\n" + one, slot + "G1 X1\n" + contour},
        std::pair{one + "G0 X0 Y0\n" + two + two, contour + "G0 X0 Y0\n" + slot + slot},
        std::pair{"FOR R1=1 TO 2\nG0 X=R1 Y0\n" + one + "ENDFOR\n", "G0 X1 Y0\n" + contour + "G0 X2 Y0\n" + contour}}) {
    const std::string whole = kBeforeParts + calls + parts;
    INFO(whole);
    const Result result = run(whole, job);
    INFO(result.text);
    CHECK(result.text.find("CALL") == std::string::npos);
    const auto called = moves_of(result.text, job.program, "siemens");
    const auto written = moves_of(run(kBeforeParts + plain + "G0 Z30\nM30\n", job).text, job.program, "siemens");
    REQUIRE(called.size() == written.size());
    for (std::size_t i = 0; i < called.size(); ++i) CHECK(tip_distance(called[i].to_W, written[i].to_W) < 2.5e-3);
    CHECK(play(whole, result.text, job).at_points_um <= 2.5);  // of increments of 0.001 mm
  }
}

TEST_CASE("a part that CALL BLOCK calls stays as it is where nothing is to be changed") {
  Job still = job_of_control("siemens");
  still.model.gravity.setZero();
  still.settings.friction = false;
  const std::string whole = kBeforeParts + "CALL BLOCK AA TO BB\nM30\nAA:\nG1 X9\nBB:";
  CHECK(moves_of(run(whole, still).text, still.program, "siemens").size() == 2);
}

TEST_CASE("axes that only a part behind M30 names are not taken to stand at zero") {
  const Job job = job_of_control("siemens");
  const std::string start = "G54 G17 G710 G90 G94 F300\nG0 X0 Y0 Z20 B0 C0\n", turn = "\nG1 A2\nX7\n";
  for (const std::string& rest :
       {"CALL BLOCK AA TO BB\nM30\nAA:" + turn + "BB:\n", "CASE 1 OF 1 GOTOF AA\nM30\nAA:" + turn + "M30\n",
        "GOTOF AA\nM30\nAA:" + turn + "M30\n"}) {
    INFO(rest);
    std::size_t line = 0;
    CHECK(code_of(start + "G1 X5\n" + rest, job, &line) == "compensate-position-unknown");
    CHECK(line == 3);
    CHECK(code_of(start + "G0 A0\nG1 X5\n" + rest, job).empty());
  }
  CHECK(code_of(start + "G1 X5\nM30\nG1 A2\n", job).empty());  // nothing leads there
}

TEST_CASE("a program that is written out keeps its PROC, with the parameters that its callers give") {
  const Job job = job_of_control("siemens");
  const std::string loop = "FOR R1=1 TO 2\nG1 X=R1\nENDFOR\n";
  for (const std::string head : {"PROC PART(REAL LONG)", "PROC PART SBLOF", "PROC PART(INT NN) DISPLOF ; it"}) {
    for (const std::string end : {"RET\n", "M17\n", "M30\n"}) {
      INFO(head << end);
      const Result result = run(head + "\nDEF REAL DEEP=3\n" + kBeforeParts + loop + end, job);
      INFO(result.text);
      CHECK(result.text.find(head.substr(0, head.find(" ;")) + (head.ends_with("it") ? " ;" : "\n")) !=
            std::string::npos);
      CHECK(moves_of(result.text, job.program, "siemens").size() >= 3);
    }
  }
}

TEST_CASE("a part that CALL BLOCK calls is told as one that is called") {
  const Job job = job_of_control("siemens");
  const std::string whole = kBeforeParts + "CALL BLOCK AA TO BB\nM30\nAA:\nG1 X9\nBB:\n";
  const std::string text = run(whole, job).text;
  INFO(text);
  CHECK(text.find("AA> called in line 3") != std::string::npos);
  CHECK(text.find("loop") == std::string::npos);
}
