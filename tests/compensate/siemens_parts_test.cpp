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
